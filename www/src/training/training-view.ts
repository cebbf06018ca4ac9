// The panel Training: its settings, the button and the chart.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { type NumberName, settingField, settingInput } from "../settings/setting-field";
import { BY_HAND, POSE_WEIGHTS } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { sentence, timeLeft } from "../ui/format";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import "../terms/term";
import type { TermName } from "../terms/terms";
import "./bound-chart";
import { isOver, secondsLeft, share } from "./runs";
import "./training.css";
import type { TrainingStore } from "./training-store";
import { newModelWords } from "./words";
import { partStyle } from "../ui/styled";

export class TrainingView extends View {
  declare training: TrainingStore;
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  declare engine: EngineStore;

  protected override stores() {
    return [this.training, this.settings, this.clips, this.engine];
  }

  #count(name: NumberName, label: string, hint: string, term?: TermName, symbol = "?") {
    // Trainings of one session have the same data, so that their bounds can be compared.
    const disabled = this.training.busy && name === "framesPerSecond";
    const afterLabel =
      term && html`<pg-term of=${term} text=${symbol} about="${label}: what is that?"></pg-term>`;
    return settingField(this.settings, name, {
      label,
      hint,
      testId: `setting-${name}`,
      disabled,
      ...(afterLabel && { afterLabel }),
    });
  }

  #partsField() {
    const { clips } = this;
    const [clip] = clips.ticked;
    const presets = clip?.loaded.info.presets ?? [];
    const { parts } = this.settings.values;
    const byHand = parts === BY_HAND;
    // The editor is loaded at its first use; after a failure the next change tries again.
    if (byHand) import("../clips/parts-editor").catch(() => {});
    const chosen = byHand ? BY_HAND : (presets.find(({ id }) => id === parts) ?? presets[0])?.id;
    const choose = (event: Event) => {
      const { value } = event.target as HTMLSelectElement;
      clips.setParts(value === BY_HAND ? { parts: BY_HAND, split: clips.parts } : { parts: value });
    };
    return html`
      <div class="field wide">
        <span><pg-term of="part" text="Parts"></pg-term></span>
        <select data-testid="setting-parts" aria-label="Parts" ?disabled=${clips.locked || !clip} @change=${choose}>
          ${presets.map(({ id, title }) => html`<option value=${id} ?selected=${id === chosen}>${title}</option>`)}
          <option value=${BY_HAND} ?selected=${byHand}>By hand</option>
        </select>
      </div>
      <ul class="part-row" aria-label="The parts to train">
        ${clips.parts.map(
          ({ name, joints }, part) => html`
          <li style=${partStyle(partColour(part))}><i class="swatch"></i>${name} <small>${joints.length} ${joints.length === 1 ? "joint" : "joints"}</small></li>`,
        )}
      </ul>
      ${byHand && clip ? html`<pg-parts-editor .settings=${this.settings} .clips=${clips}></pg-parts-editor>` : nothing}`;
  }

  /** The status next to the button: the plan, the progress or the end. */
  #words(why: string) {
    const { training } = this;
    const { asked, busy, ending } = training;
    const last = asked.length === 1 ? asked[0]?.steps.at(-1) : undefined;
    const iteration = last
      ? html`<span>Iteration ${last.iteration} of ${last.maxIterations}${busy ? "" : "."}</span>`
      : nothing;
    if (busy) {
      if (asked.every(({ steps }) => steps.length === 0)) return html`<span>Setting up</span>`;
      if (asked.some(({ catchingUp }) => catchingUp))
        return html`<span>Catching up with where it stopped</span>`;
      const done =
        asked.length > 1
          ? html`<span>${asked.filter(isOver).length} of ${asked.length} trainings done</span>`
          : iteration;
      return html`${done}<span>${sentence(timeLeft(secondsLeft(asked, training.workers)))}</span>`;
    }
    if (why) return sentence(why);
    if (ending.failed) return html`<span class="bad">${sentence(`Training failed: ${ending.words}`)}</span>`;
    if (ending.words) return html`${iteration}<span>${sentence(ending.words)}</span>`;
    const { ticked } = this.clips;
    const made = ticked.every(({ origin }) => origin === "made");
    const of = newModelWords(training.count, ticked.length, made);
    const { words, absurd } = training.cost;
    return words ? html`${of} <span class=${absurd ? "bad" : ""} data-testid="cost">${words}</span>` : of;
  }

  /** For a run on the stage that stopped before its bound had settled. */
  #continueButton() {
    const { training } = this;
    const run = training.charted;
    if (!run || !training.canContinue(run)) return nothing;
    const more = training.moreIterations(run);
    const how = more > 0 ? `, for ${more} more iterations` : ", as if it had not been cancelled";
    return html`<button data-testid="continue" title="Goes on where seed ${run.settings.seed} stopped${how}"
      @click=${() => void training.continue(run)}>Continue${more > 0 ? `, ${more} more` : ""}</button>`;
  }

  /** Screen readers read the state, not each iteration. */
  #announcement(): string {
    const { status, asked, ending } = this.training;
    if (status === "running") {
      const done = Math.floor(share(asked) * 10) * 10;
      return asked.some(({ steps }) => steps.length > 0)
        ? `Training, ${done} per cent of the iterations`
        : "Training started";
    }
    if (status === "cancelling") return "Cancelling";
    return ending.words ? `Training ended. ${sentence(ending.words)}` : "";
  }

  protected override render() {
    const { training, settings } = this;
    const { busy } = training;
    const cancelling = training.status === "cancelling";
    const why = training.whyNot();
    return html`
      <h2>Training</h2>
      <div class="train-row">
        ${
          busy
            ? html`<button class="primary big" data-testid="cancel" ?disabled=${cancelling}
              title="Stops here and keeps what was learned so far" @click=${() => training.cancel()}>Cancel</button>
              <button data-testid="add" ?disabled=${cancelling}
              title="Trains with the settings below too, beside the others" @click=${() => void training.start()}>Add</button>`
            : html`<button class="primary big" data-testid="train" ?disabled=${why !== ""} aria-describedby="train-why"
              @click=${() => void training.start()}>Train</button>
              ${this.#continueButton()}`
        }
        <p id="train-why" class="hint words" data-testid="progress">${this.#words(why)}</p>
      </div>
      ${progressBar("Training", busy ? share(training.asked) : null)}
      <div class="visually-hidden" role="status" aria-live="polite">${this.#announcement()}</div>
      <div class="fields main-fields">
        ${this.#partsField()}
        ${this.#count("latent", "Latent dimensions", "The dimensions of each part's latent space", "latent-space", "Q")}
        ${this.#count("dynamicsIps", "Dynamics points", "Inducing points of each coupling's dynamics", "dynamics-points", "K")}
        ${this.#count("poseIps", "Pose points", "Inducing points of each part's pose map", "pose-points", "L")}
        ${this.#count("framesPerSecond", "Frames a second", "Clips are resampled to this rate")}
      </div>
      <details class="advanced">
        <summary>Advanced</summary>
        <div class="fields">
          <div class="field seed">
            <span><label for="seed-input">Seed</label> <pg-term of="seed" text="?" about="Seed: what is that?"></pg-term></span>
            ${settingInput(settings, "seed", { id: "seed-input", testId: "setting-seed", disabled: false })}
            <button class="round" aria-label="New seed" title="New seed" ?disabled=${!this.engine.engine} @click=${() => void training.newSeed()}>${icon("dice")}</button>
          </div>
          ${this.#count("trainings", "Trainings", "One for each seed from this one on, as many at once as this machine has cores; 0: as many as cores, up to 4")}
          ${this.#count("order", "Frames of history", "The order of the dynamics", "order", "p")}
          ${this.#count("maxIterations", "Iterations at most", "The optimiser stops here at the latest", "iterations")}
          <label class="field"><span>Weight of the poses</span>
            <select data-testid="setting-poseWeight" title="1: training maximises the bound. Less: the latents become easier to predict, and the poses less exact"
              @change=${(event: Event) => settings.change({ poseWeight: POSE_WEIGHTS[(event.target as HTMLSelectElement).selectedIndex] ?? 1 })}>
              ${POSE_WEIGHTS.map((weight) => html`<option ?selected=${weight === settings.values.poseWeight}>${weight}</option>`)}
            </select></label>
        </div>
      </details>
      <pg-bound-chart .training=${training}></pg-bound-chart>`;
  }
}
customElements.define("pg-training", TrainingView);
