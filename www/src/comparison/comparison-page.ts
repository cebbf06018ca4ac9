// Comparing models: what to compare, how far it is, the models side by side, and what came of them.
import { html, nothing } from "lit";
import { LARGEST_FILE, tickClip } from "../clips/clips";
import { changeSettings } from "../settings/change";
import { studying } from "./comparison-store";
import { messageOf, sentence, timeLeft } from "../ui/format";
import { partsFor } from "../clips/parts";
import { BY_HAND, MODELS, type NumberSetting, SETTINGS, type SettingName } from "../settings/settings";
import "./comparison.css";
import { isCoupled, secondsLeft, share } from "./jobs";
import { icon } from "../ui/icons";
import { noticeCard } from "../ui/notices";
import { View } from "../ui/view";
import type { SaveFailure } from "./comparison-figures";
import "./comparison-figures";
import { modelStyle } from "./model-style";
import "./side-by-side";

/** What each kind of model is, in a line. */
const ABOUT: Record<(typeof MODELS)[number], string> = {
  vcgpdm: "The coupled model of this page",
  vgpdm: "The same, with the whole body as one part",
  "map-gpdm": "Point latents instead of distributions; slow",
  "map-cgpdm": "The same, with coupled parts; slowest",
  tmp: "Weighted curves over a common phase",
  "dmp-discrete": "A spring pulled towards a goal",
  "dmp-rhythmic": "A spring pulled around a cycle",
};

type Count = "heldOut" | "seeds" | "comparedIterations" | "seed" | "framesPerSecond" | "latent" | "order";

export class ComparisonPage extends View {
  static override topics = ["study", "settings", "clips", "engine", "notices"] as const;
  static override properties = { unfolded: { state: true } };
  /** Whether the choices are open. */
  declare unfolded: boolean;
  private problem = "";

  constructor() {
    super();
    this.unfolded = true;
  }

  private count(name: Count, label: string, hint: string) {
    const { min, max, step } = SETTINGS[name] as NumberSetting;
    return html`
      <label class="field" title=${hint}><span>${label}</span>
        <input type="number" data-testid="compare-${name}" min=${min} max=${max} step=${step} .value=${String(this.app.settings[name])}
          ?disabled=${studying(this.app).busy} @change=${(event: Event) => this.change(event, name, (input) => input.valueAsNumber)} />
      </label>`;
  }

  private list(name: "ips" | "bases", label: string, hint: string) {
    return html`
      <label class="field" title=${hint}><span>${label}</span>
        <input type="text" inputmode="numeric" data-testid="compare-${name}" .value=${this.app.settings[name].join(", ")}
          ?disabled=${studying(this.app).busy} @change=${(event: Event) =>
            this.change(event, name, (input) =>
              input.value
                .split(/[\s,]+/)
                .filter(Boolean)
                .map(Number),
            )} />
      </label>`;
  }

  private flag(name: "balanced" | "growth", label: string, hint: string) {
    return html`
      <label class="check" title=${hint}>
        <input type="checkbox" data-testid="compare-${name}" .checked=${this.app.settings[name]} ?disabled=${studying(this.app).busy}
          @change=${(event: Event) => changeSettings(this.app, { [name]: (event.target as HTMLInputElement).checked })} />
        ${label}</label>`;
  }

  /** Takes a value over within its limits, and shows what was taken over. */
  private change(event: Event, name: SettingName, value: (input: HTMLInputElement) => unknown): void {
    const input = event.target as HTMLInputElement;
    changeSettings(this.app, { [name]: value(input) });
    const now = this.app.settings[name];
    input.value = Array.isArray(now) ? now.join(", ") : String(now);
  }

  private models() {
    const { app } = this;
    const { models } = app.settings;
    return html`
      <fieldset class="models">
        <legend>Models</legend>
        ${MODELS.map(
          (id) => html`
          <label class="check">
            <input type="checkbox" data-testid="model-${id}" .checked=${models.includes(id)} ?disabled=${studying(app).busy}
              @change=${(event: Event) => {
                const on = (event.target as HTMLInputElement).checked;
                changeSettings(app, { models: MODELS.filter((one) => (one === id ? on : models.includes(one))) });
              }} />
            <span>${modelStyle(id).name} <small>${ABOUT[id]}</small></span>
          </label>`,
        )}
      </fieldset>`;
  }

  private trials() {
    const { app } = this;
    const { busy } = studying(app);
    return html`
      <details class="trials">
        <summary>Trials <small>${app.tickedClips().length} of ${app.clips.length} clips ticked</small></summary>
        <ul>${app.clips.map(
          ({ key, title, ticked }) => html`
          <li><label class="check"><input type="checkbox" .checked=${ticked} ?disabled=${busy || app.busy}
            @change=${(event: Event) => void tickClip(app, key, (event.target as HTMLInputElement).checked)} /> ${title}</label></li>`,
        )}
        </ul>
        <p class="hint">Drop your own clips (.bvh) anywhere on the page.</p>
      </details>`;
  }

  private parts() {
    const { app } = this;
    const clip = app.tickedClips()[0];
    const presets = clip?.loaded.info.presets ?? [];
    const { parts, split } = app.settings;
    const names = clip
      ? partsFor(clip.loaded.info, parts, split)
          .map(({ name }) => name)
          .join(", ")
      : "";
    return html`
      <label class="field wide" title="How the coupled models split the body"><span>Parts of the coupled models</span>
        <select data-testid="compare-parts" ?disabled=${studying(app).busy || !clip}
          @change=${(event: Event) => changeSettings(app, { parts: (event.target as HTMLSelectElement).value })}>
          ${presets.map(({ id, title }) => html`<option value=${id} ?selected=${id === parts}>${title}</option>`)}
          ${parts === BY_HAND ? html`<option value=${BY_HAND} selected>By hand: ${names}</option>` : nothing}
        </select>
      </label>`;
  }

  private words() {
    const studies = studying(this.app);
    if (this.problem) return html`<span class="bad" role="alert">${sentence(this.problem)}</span>`;
    if (studies.status === "starting") return "Loading the other models";
    if (studies.status === "cancelling") return "Cancelling";
    if (studies.busy) {
      const { jobs } = studies.study!;
      const done = jobs.filter(({ state }) => state === "done" || state === "failed").length;
      return html`<span>${done} of ${jobs.length} trainings done</span><span>${sentence(timeLeft(secondsLeft(jobs, studies.width), "about"))}</span>`;
    }
    const ended = studies.failed
      ? html`<span class="bad" role="alert">The comparison failed. ${sentence(studies.ending)}</span>`
      : html`<span>${sentence(studies.ending)}</span>`;
    const why = studies.whyNot();
    if (why) return html`${ended}<span>${sentence(why)}</span>`;
    const { all, open, goesOn } = studies.outlook();
    const known = open < all ? `, ${all - open} finished before` : "";
    const words = open > 0 ? `${open} ${open === 1 ? "training" : "trainings"}${known}.` : "";
    return html`${ended}<span>${words}${goesOn ? "" : " Other trials, parts or frame rate than below: a comparison of its own."}</span>`;
  }

  private announcement(): string {
    const studies = studying(this.app);
    if (studies.status === "running")
      return `Comparing, ${Math.floor(share(studies.study!.jobs) * 10) * 10} per cent done`;
    if (studies.status === "cancelling") return "Cancelling";
    return studies.status === "idle" && !studies.failed ? studies.ending : "";
  }

  /** What is missing for the figure of learning time. */
  private growthWords(): string {
    const { settings } = this.app;
    if (!settings.growth) return "";
    const some = settings.models.some(isCoupled);
    if (!some || this.app.tickedClips().length < 4)
      return "Needs the vCGPDM or the MAP CGPDM, and four trials or more.";
    return "Times are taken with all workers busy; the terminal can measure alone.";
  }

  private openFile(event: Event): void {
    const input = event.target as HTMLInputElement;
    const [file] = input.files ?? [];
    input.value = "";
    if (!file) return;
    void this.opening(file.name, async () => {
      if (file.size > LARGEST_FILE)
        throw new Error("This file has more than 200 MB; expected the results of a comparison.");
      await studying(this.app).open(await file.text());
    });
  }

  /** Opens results; what is shown stays when they cannot be. */
  private async opening(name: string, open: () => Promise<void>): Promise<void> {
    this.problem = "";
    try {
      await open();
    } catch (problem) {
      this.problem = `${name}: ${messageOf(problem)}`;
      this.requestUpdate();
    }
  }

  private setup() {
    const { app } = this;
    const studies = studying(app);
    const why = studies.whyNot();
    const total = studies.study?.jobs ?? [];
    return html`
      <div class="begin">
        ${
          studies.busy
            ? html`<button class="primary big" data-testid="compare-cancel" ?disabled=${studies.status === "cancelling"}
              title="Stops; finished trainings are kept" @click=${() => studies.cancel()}>Cancel</button>`
            : html`<button class="primary big" data-testid="compare" ?disabled=${why !== ""} @click=${() => {
                this.problem = "";
                // What is found stands below the choices there.
                if (matchMedia("(max-width: 759.98px)").matches) this.unfolded = false;
                void studies.begin();
              }}>Compare</button>`
        }
        <p class="hint words" data-testid="compare-progress">${this.words()}</p>
      </div>
      <progress max="1" .value=${studies.busy ? share(total) : 0} aria-label="Comparing" class=${studies.busy ? "" : "resting"}
        aria-hidden=${studies.busy ? "false" : "true"}></progress>
      <div class="visually-hidden" role="status" aria-live="polite">${this.announcement()}</div>
      <p class="hint">Each trial is held out in turn. Every model learns from the others, sees the trial’s first five frames, and predicts the rest.</p>
      <details class="choices" ?open=${this.unfolded} @toggle=${(event: Event) => (this.unfolded = (event.target as HTMLDetailsElement).open)}>
      <summary>What to compare</summary>
      ${this.models()}
      ${this.trials()}
      <div class="fields">
        ${this.parts()}
        ${this.list("ips", "Inducing points", "Of every dynamics map and every pose map of the variational models; several to compare")}
        ${this.list("bases", "DMP bases", "Basis functions of every column of the DMPs; several to compare")}
        ${this.count("comparedIterations", "Iterations at most", "Of the optimiser, for every model that has one")}
        ${this.count("heldOut", "Only trial (0: each)", "The trial held out, counted from 1; 0: each in turn")}
      </div>
      ${this.flag("growth", "Learning time against frames", "Trains the vCGPDM and the MAP CGPDM also on fewer trials")}
      <p class="hint">${this.growthWords()}</p>
      <details class="advanced">
        <summary>Advanced</summary>
        <div class="fields">
          ${this.count("seed", "First seed", "Of everything random")}
          ${this.count("seeds", "Seeds", "How many, from the first on")}
          ${this.count("latent", "Latent dimensions", "Q of every part")}
          ${this.count("order", "Frames of history", "The order p of the dynamics")}
          ${this.count("framesPerSecond", "Frames a second", "Clips are resampled to this rate")}
        </div>
        ${this.flag("balanced", "Balanced MAP models", "Their dynamics weigh as much as their many columns (Urtasun, Fleet and Fua 2006)")}
      </details>
      </details>
      <div class="files">
        <label class="small file-button">${icon("open")} Open results
          <input type="file" class="visually-hidden" data-testid="open-results" accept=".json,application/json" ?disabled=${studies.busy}
            aria-label="Open results (.json) of this page or of the terminal" @change=${(event: Event) => this.openFile(event)} /></label>
        <button class="small" data-testid="save-results" ?disabled=${!studies.study?.results.finished.length} @click=${() => studies.save()}>${icon("save")} Save results</button>
        <button class="small" data-testid="open-walks" ?disabled=${studies.busy || !app.engine} title="All models, ten walks of one person, 30 frames a second"
          @click=${() => void this.opening("Ten recorded walks", () => studies.openWalks())}>${icon("eye")} Ten recorded walks</button>
      </div>`;
  }

  private failures() {
    const { study } = studying(this.app);
    const known =
      study?.results.finished
        .filter(({ failure }) => failure)
        .map(({ job, failure }) => ({ job, why: failure ?? "" })) ?? [];
    const failed = [...known, ...(study?.jobs.filter(({ state }) => state === "failed") ?? [])];
    if (failed.length === 0) return nothing;
    return html`<ul class="failures card">${failed.map(
      ({ job, why }) => html`
      <li class="bad">${modelStyle(job.candidate.model).name}, trial ${job.held_out} held out: ${sentence(why)}</li>`,
    )}</ul>`;
  }

  protected override render() {
    const { app } = this;
    const { comparison } = studying(app);
    return html`
      <section class="card setup" aria-label="What to compare"><h2>Compare models</h2>${this.setup()}</section>
      <section class="found" aria-label="What came of it">
        <div class="card stage-card"><pg-side-by-side .app=${app}></pg-side-by-side></div>
        ${app.notices.filter(({ at }) => at === null).map((notice) => noticeCard(app, notice))}
        ${this.failures()}
        <div class="card"><comparison-figures .comparison=${comparison}
          @save-failed=${({ detail }: CustomEvent<SaveFailure>) =>
            app.notify({
              kind: "error",
              title: `${detail.name} was not saved`,
              text: detail.message,
              at: null,
            })}></comparison-figures></div>
      </section>`;
  }
}
customElements.define("pg-comparison", ComparisonPage);
