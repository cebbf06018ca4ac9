// The tab Numbers: couplings and kernels of the model as tables, and channels of the motion on the stage.
// Loaded when the tab is opened.
import { html, nothing } from "lit";
import type { ClipEntry } from "../clips/clips-store";
import type { ModelStore } from "../couplings/model-store";
import { weightText } from "../couplings/weights";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { Engine, RolloutRequest } from "../engine/protocol";
import type { LatentLogDensity } from "../engine/whole-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import type { Playback } from "../stage/playback";
import { withTerms } from "../terms/term";
import { fixed, short } from "../ui/format";
import { View } from "../ui/view";
import type { PlottedMotion } from "./angles-view";
import "./angles-view";
import { channelsOf, type Recorded, readMotion } from "./channels";
import "./details.css";
import { numbers as words } from "../words/sections";
import { shownPart } from "../words/lab";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";

/** A Gaussian process: lengthscales are in units of the latent space, one for each input dimension. */
interface Kernel {
  lengthscales: number[];
}

interface PoseKernel extends Kernel {
  part: string;
  /** sigma^2 */
  variance: number;
  /** beta, the variance of the observation noise. */
  noise: number;
}

interface ExpertKernel extends Kernel {
  source: number;
  target: number;
  /** alpha, as learned. */
  coupling: number;
}

interface Kernels {
  /** The number of earlier frames that an expert sees. */
  order: number;
  poses: PoseKernel[];
  /** The experts about the first part come first. Their signal variance is 1. */
  experts: ExpertKernel[];
}

/** The fields of a document; its `lambda` are squared lengthscales. */
interface Document {
  order: number;
  parts: { name: string; lambda: number[]; variance: number; beta: number }[];
  /** By target, then by source. */
  dynamics: { experts: { lambda: number[] }[] }[];
  /** [source][target] */
  alpha: number[][];
}

const lengths = (lambda: readonly number[]) => lambda.map(Math.sqrt);

export function kernelsOf(text: string): Kernels {
  const { order, parts, dynamics, alpha } = JSON.parse(text) as Document;
  return {
    order,
    poses: parts.map(({ name, lambda, variance, beta }) => ({
      part: name,
      variance,
      noise: beta,
      lengthscales: lengths(lambda),
    })),
    experts: dynamics.flatMap(({ experts }, target) =>
      experts.map(({ lambda }, source) => ({
        source,
        target,
        coupling: alpha[source]?.[target] ?? Number.NaN,
        lengthscales: lengths(lambda),
      })),
    ),
  };
}

/** The name of a part with its colour. */
const partCell = (name: string, part: number) =>
  html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${name}</span>`;
const numbers = (values: readonly number[]) => values.map((value) => html`<td>${short(value)}</td>`);

/** The number of dimensions of the widest latent space; parts with fewer have empty cells. */
const widest = (rows: readonly { lengthscales: readonly number[] }[]) =>
  Math.max(1, ...rows.map(({ lengthscales }) => lengthscales.length));
const latents = (count: number, index: (q: number) => string) =>
  Array.from({ length: count }, (_, q) => html`<th scope="col">x<sub>${index(q)}</sub></th>`);

function kernelTables({ poses, experts, order }: Kernels) {
  const across = widest(poses);
  const inputs = widest(experts);
  /** The earlier frame of an input dimension, and the dimension in that frame. */
  const history = (q: number) =>
    `${(q % (inputs / order)) + 1}, t−${order - Math.floor((q * order) / inputs)}`;
  const name = (part: number) => poses[part]?.part ?? "";
  const { couplings, kernels: heads } = words();
  return html`
    <section>
      <h2>${withTerms(heads.poses)}</h2>
      <div class="table-scroll" tabindex="0" role="region" aria-label=${heads.posesLabel}>
        <table class="note tabular" data-testid="pose-kernels">
          <thead class="quiet">
            <tr><th rowspan="2" scope="col">${heads.part}</th>
              <th rowspan="2" scope="col"><pg-term of="signal-variance" text="σ²"></pg-term></th>
              <th rowspan="2" scope="col"><pg-term of="noise-variance" text="β"></pg-term></th>
              <th colspan=${across} scope="colgroup">${withTerms(heads.along)}</th></tr>
            <tr>${latents(across, (q) => String(q + 1))}</tr>
          </thead>
          <tbody>${poses.map(
            ({ part, variance, noise, lengthscales }, i) =>
              html`<tr><th scope="row">${partCell(shownPart(part), i)}</th>${numbers([variance, noise, ...lengthscales])}</tr>`,
          )}</tbody>
        </table>
      </div>
    </section>
    <section>
      <h2>${withTerms(heads.experts(order))}</h2>
      <div class="table-scroll" tabindex="0" role="region" aria-label=${heads.expertsLabel}>
        <table class="note tabular" data-testid="expert-kernels">
          <thead class="quiet">
            <tr><th rowspan="2" scope="col">${heads.from}</th><th rowspan="2" scope="col">${couplings.about}</th>
              <th rowspan="2" scope="col">${withTerms(couplings.alphaLearned)}</th>
              <th colspan=${inputs} scope="colgroup">${withTerms(heads.along)}</th></tr>
            <tr>${latents(inputs, history)}</tr>
          </thead>
          <tbody>${experts.map(
            ({ source, target, coupling, lengthscales }) =>
              html`<tr><th scope="row">${partCell(shownPart(name(source)), source)}</th><th scope="row">${partCell(shownPart(name(target)), target)}</th>
              ${numbers([coupling, ...lengthscales])}</tr>`,
          )}</tbody>
        </table>
      </div>
      <p class="hint">${heads.note}</p>
    </section>`;
}

/** A clip on the stage. */
type Clip = Pick<ClipEntry, "title" | "loaded" | "source" | "first" | "end">;

interface ReadMotion {
  of: "model now" | "model as learned" | { clip: string };
  motion: Recorded;
  /** Null for a clip. */
  logDensity: LatentLogDensity | null;
}

export class NumbersView extends View {
  static override properties = {
    clip: { attribute: false },
    visible: { type: Boolean },
    kernels: { state: true },
    motions: { state: true },
    problem: { state: true },
  };
  declare workers: WholeWorkers;
  declare engine: EngineStore;
  declare model: ModelStore;
  declare playback: Playback;
  /** Null: the model's motion is on the stage. */
  clip: Clip | null = null;
  /** Whether the tab is open. Nothing is computed for a closed tab. */
  visible = false;
  kernels: Kernels | null = null;
  motions: readonly ReadMotion[] = [];
  problem = "";
  /** The model and the motion that were asked for last. */
  #asked: unknown[] = [];
  readonly #latest = new Latest(
    (engine: Engine) => this.#read(engine),
    ({ kernels, motions }) => Object.assign(this, { kernels, motions, problem: "" }),
    () => {
      this.problem = words().failed;
    },
  );

  protected override stores() {
    return [this.model, this.engine];
  }

  override willUpdate(): void {
    const { model, engine, clip, visible } = this;
    const now = [model.model?.revision, clip ?? model.rollout, clip?.first, clip?.end];
    if (!visible || !engine.engine || !model.rollout || now.every((part, i) => part === this.#asked[i]))
      return;
    this.#asked = now;
    this.#latest.request(engine.engine);
  }

  async #read(engine: Engine): Promise<{ kernels: Kernels; motions: ReadMotion[] }> {
    const { model, clip } = this;
    const text = await engine.modelJson();
    const kernels = kernelsOf(text);
    const { clips } = this.engine;
    if (clip && clips) {
      const { loaded, source, first, end } = clip;
      const bvh = await clips.clipBvh({ id: loaded.id, source, first, end });
      const motion = readMotion(bvh);
      return { kernels, motions: [{ of: { clip: clip.title }, motion, logDensity: null }] };
    }
    const read = async (of: "model now" | "model as learned", request: RolloutRequest) => {
      const [bvh, logDensity] = await Promise.all([
        engine.rolloutBvh(request),
        this.workers.desk.run((worker) => worker.latentLogDensity(text, request)),
      ]);
      return { of, motion: readMotion(bvh), logDensity };
    };
    const now = await read("model now", model.rolloutRequest());
    if (!model.couplings.altered || !model.learned) return { kernels, motions: [now] };
    return { kernels, motions: [now, await read("model as learned", model.learned.request)] };
  }

  /** The name of a motion in the language of the page. */
  #nameOf({ of }: ReadMotion): string {
    const { modelNow, asLearned } = words();
    const names = { "model now": modelNow, "model as learned": asLearned };
    return typeof of === "string" ? names[of] : of.clip;
  }

  get #plotted(): PlottedMotion[] {
    return this.motions.map((read) => ({ name: this.#nameOf(read), motion: read.motion }));
  }

  #logDensity() {
    const { logDensity: heads } = words();
    const number = (value: number | null) => (value === null ? "–" : fixed(value, 1));
    const rows = this.motions.flatMap((read) =>
      read.logDensity ? [{ name: this.#nameOf(read), ...read.logDensity }] : [],
    );
    if (rows.length === 0) return nothing;
    const elbo = this.model.model?.info.dynamicsElbo ?? null;
    return html`
      <section>
        <h2>${heads.title}</h2>
        <div class="table-scroll" tabindex="0" role="region" aria-label=${heads.title}>
          <table class="note tabular" data-testid="log-density">
            <thead class="quiet"><tr><th scope="col">${heads.of}</th><th scope="col">${heads.rollout}</th>
              <th scope="col">${heads.training}</th><th scope="col">${heads.difference}</th></tr></thead>
            <tbody>${rows.map(
              ({ name, rollout, training, difference }) => html`
              <tr><th scope="row">${name}</th><td>${number(rollout)}</td><td>${number(training)}</td>
                <td>${number(difference)}</td></tr>`,
            )}</tbody>
          </table>
        </div>
        <p class="hint">${heads.about(number(elbo))}</p>
        <p class="hint">${heads.caution}</p>
      </section>`;
  }

  #couplings() {
    const { couplings, model } = this.model;
    const names = model?.info.parts.map(({ name }) => shownPart(name)) ?? [];
    const pairs = names.flatMap((_, target) => names.map((__, source) => ({ source, target })));
    const { couplings: heads } = words();
    return html`
      <section>
        <h2>${withTerms(heads.title)}</h2>
        <div class="table-scroll" tabindex="0" role="region" aria-label=${heads.label}>
          <table class="note tabular" data-testid="coupling-numbers-table">
            <thead class="quiet"><tr><th scope="col">${heads.decides}</th><th scope="col">${heads.about}</th>
              <th scope="col">${withTerms(heads.alphaLearned)}</th><th scope="col">${heads.alphaNow}</th>
              <th scope="col">${withTerms(heads.weightNow)}</th></tr></thead>
            <tbody>${pairs.map(
              ({ source, target }) => html`
              <tr><th scope="row">${partCell(names[source] ?? "", source)}</th><th scope="row">${partCell(names[target] ?? "", target)}</th>
                <td>${short(couplings.learnedAlpha(source, target))}</td><td>${short(couplings.alphaOf(source, target))}</td>
                <td>${weightText(couplings.weight(source, target))}</td></tr>`,
            )}</tbody>
          </table>
        </div>
      </section>`;
  }

  protected override render() {
    const { kernels, model, clip, problem } = this;
    const joints = clip?.loaded.info.joints ?? model.model?.info.joints ?? [];
    if (problem) return html`<p class="bad" role="alert">${problem}</p>`;
    if (!kernels) return html`<p class="empty">${words().empty}</p>`;
    return html`
      <section>
        <h2>${words().angles.title}</h2>
        <pg-angles .playback=${this.playback} .motions=${this.#plotted} .channels=${channelsOf(joints)}></pg-angles>
      </section>
      ${this.#logDensity()}
      ${model.model ? this.#couplings() : nothing}
      ${kernelTables(kernels)}`;
  }
}
customElements.define("pg-numbers", NumbersView);
