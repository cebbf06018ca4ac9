// Train, follow and cancel; and what to train.
import { html, nothing } from "lit";
import { partsChanged } from "../clips/clips";
import { changeSettings } from "../settings/change";
import { cancelTraining, newSeed, train, whyNotTrain } from "./training";
import { sentence, timeLeft } from "../ui/format";
import { partColour } from "../ui/palette";
import { partsFor } from "../clips/parts";
import { isOver, secondsLeft, share } from "./runs";
import { BY_HAND, type NumberSetting, SETTINGS } from "../settings/settings";
import "./bound-chart";
import { icon } from "../ui/icons";
import "../clips/parts-editor";
import { swatchStyle, View } from "../ui/view";

type Count =
  | "latent"
  | "dynamicsIps"
  | "poseIps"
  | "framesPerSecond"
  | "seed"
  | "maxIterations"
  | "order"
  | "trainings";

export class TrainingView extends View {
  static override topics = ["training", "settings", "clips", "engine"] as const;

  private count(name: Count, label: string, hint: string) {
    const { min, max, step } = SETTINGS[name] as NumberSetting;
    const { settings, busy } = this.app;
    // Trainings that run at the same time explain the same numbers, so that their bounds can be compared.
    const held = busy && name === "framesPerSecond";
    return html`
      <label class="field" title=${hint}>
        <span>${label}</span>
        <input type="number" data-testid="setting-${name}" min=${min} max=${max} step=${step} .value=${String(settings[name])} ?disabled=${held}
          @change=${(event: Event) => {
            const input = event.target as HTMLInputElement;
            changeSettings(this.app, { [name]: input.valueAsNumber });
            input.value = String(this.app.settings[name]);
          }} />
      </label>`;
  }

  private partsField() {
    const { app } = this;
    const clip = app.tickedClips()[0];
    const presets = clip?.loaded.info.presets ?? [];
    const { parts, split } = app.settings;
    const hand = parts === BY_HAND;
    const chosen = hand ? BY_HAND : (presets.find(({ id }) => id === parts) ?? presets[0])?.id;
    const now = clip ? partsFor(clip.loaded.info, parts, split) : [];
    const choose = (event: Event) => {
      const value = (event.target as HTMLSelectElement).value;
      changeSettings(app, value === BY_HAND ? { parts: BY_HAND, split: now } : { parts: value });
      partsChanged(app);
    };
    return html`
      <label class="field wide">
        <span>Parts</span>
        <select data-testid="setting-parts" aria-label="Parts" ?disabled=${app.busy || !clip} @change=${choose}>
          ${presets.map(({ id, title }) => html`<option value=${id} ?selected=${id === chosen}>${title}</option>`)}
          <option value=${BY_HAND} ?selected=${hand}>By hand</option>
        </select>
      </label>
      <ul class="part-row" aria-label="The parts to train">
        ${now.map(
          ({ name, joints }, part) => html`
          <li style=${swatchStyle(partColour(part))}><i class="swatch"></i>${name} <small>${joints.length} ${joints.length === 1 ? "joint" : "joints"}</small></li>`,
        )}
      </ul>
      ${hand && clip ? html`<pg-parts-editor .app=${app}></pg-parts-editor>` : nothing}`;
  }

  /** Beside the button: what would happen, what is happening, or how it ended. */
  private words(why: string) {
    const { app } = this;
    const { runs, ending, failed } = app.training;
    const last = runs.length === 1 ? runs[0]!.steps.at(-1) : undefined;
    const iteration = last
      ? html`<span>Iteration ${last.iteration} of ${last.maxIterations}${app.busy ? "" : "."}</span>`
      : nothing;
    if (app.busy) {
      if (runs.every(({ steps }) => steps.length === 0)) return html`<span>Setting up</span>`;
      const done =
        runs.length > 1 ? html`<span>${runs.filter(isOver).length} of ${runs.length} trainings done</span>` : iteration;
      return html`${done}<span>${sentence(timeLeft(secondsLeft(runs, app.pool?.width ?? 1)))}</span>`;
    }
    if (why) return sentence(why);
    if (failed) return html`<span class="bad">Training failed. ${sentence(ending)}</span>`;
    if (ending) return html`${iteration}<span>${sentence(ending)}</span>`;
    const ticked = app.tickedClips().length;
    const { trainings } = app.settings;
    const models = trainings === 1 ? "A new model" : `${trainings} new models`;
    return `${models}, from ${ticked} ${ticked === 1 ? "clip" : "clips"}.`;
  }

  /** Heard by screen readers: the state, not each iteration. */
  private announcement(): string {
    const { status, runs, ending } = this.app.training;
    if (status === "running") {
      const done = Math.floor(share(runs) * 10) * 10;
      return runs.some(({ steps }) => steps.length > 0)
        ? `Training, ${done} per cent of the iterations`
        : "Training started";
    }
    if (status === "cancelling") return "Cancelling";
    return ending ? `Training ended. ${sentence(ending)}` : "";
  }

  protected override render() {
    const { app } = this;
    const why = whyNotTrain(app);
    return html`
      <header class="panel-head"><h2>Training</h2></header>
      <div class="train-row">
        ${
          app.busy
            ? html`<button class="primary big" data-testid="cancel" ?disabled=${app.training.status === "cancelling"}
              title="Stops here and keeps what was learned so far" @click=${() => cancelTraining(app)}>Cancel</button>
              <button data-testid="add" ?disabled=${app.training.status === "cancelling"}
              title="Trains with the settings below too, beside the others" @click=${() => void train(app)}>Add</button>`
            : html`<button class="primary big" data-testid="train" ?disabled=${why !== ""} aria-describedby="train-why"
              @click=${() => void train(app)}>Train</button>`
        }
        <p id="train-why" class="hint words" data-testid="progress">${this.words(why)}</p>
      </div>
      <progress max="1" .value=${app.busy ? share(app.training.runs) : 0} aria-label="Training"
        class=${app.busy ? "" : "resting"} aria-hidden=${app.busy ? "false" : "true"}></progress>
      <div class="visually-hidden" role="status" aria-live="polite">${this.announcement()}</div>
      <div class="fields main-fields">
        ${this.partsField()}
        ${this.count("latent", "Latent dimensions", "Q, the dimensions of each part's latent space")}
        ${this.count("dynamicsIps", "Dynamics points", "Inducing points of each coupling's dynamics")}
        ${this.count("poseIps", "Pose points", "Inducing points of each part's pose map")}
        ${this.count("framesPerSecond", "Frames a second", "Clips are resampled to this rate")}
      </div>
      <details class="advanced">
        <summary>Advanced</summary>
        <div class="fields">
          <div class="field seed">
            <label for="seed-input">Seed</label>
            <input id="seed-input" type="number" data-testid="setting-seed" min="0" max=${SETTINGS.seed.max} .value=${String(app.settings.seed)}
              @change=${(event: Event) => {
                const input = event.target as HTMLInputElement;
                changeSettings(app, { seed: input.valueAsNumber });
                input.value = String(app.settings.seed);
              }} />
            <button class="round" aria-label="New seed" title="New seed" ?disabled=${!app.engine} @click=${() => void newSeed(app)}>${icon("dice")}</button>
          </div>
          ${this.count("trainings", "Trainings", "One for each seed from this one on, as many at once as this machine has cores")}
          ${this.count("order", "Frames of history", "The order p of the dynamics")}
          ${this.count("maxIterations", "Iterations at most", "The optimiser stops here at the latest")}
        </div>
      </details>
      <pg-bound-chart .app=${app}></pg-bound-chart>`;
  }
}
customElements.define("pg-training", TrainingView);
