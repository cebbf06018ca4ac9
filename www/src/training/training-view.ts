// The panel Training: its settings, the button and the chart.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { type NumberName, settingField, settingInput } from "../settings/setting-field";
import { BY_HAND, POSE_WEIGHTS, SETTINGS } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { sentence } from "../ui/format";
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
import { type LearnWords, lab, shownPart, shownSplit } from "../words/lab";
import { timeLeft } from "./words";
import { partStyle } from "../ui/styled";

export class TrainingView extends View {
  declare training: TrainingStore;
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  declare engine: EngineStore;

  protected override stores() {
    return [this.training, this.settings, this.clips, this.engine];
  }

  #count(name: Exclude<NumberName & keyof LearnWords["settings"], "seed">, term?: TermName, symbol = "?") {
    const { field, settings } = lab().learn;
    const { label, hint } = settings[name];
    // Trainings of one session have the same data, so that their bounds can be compared.
    const disabled = this.training.busy && name === "framesPerSecond";
    const afterLabel =
      term && html`<pg-term of=${term} text=${symbol} about=${field.about(label)}></pg-term>`;
    const usual = name === "dynamicsIps" || name === "poseIps" ? this.training.usual?.[name] : undefined;
    const input = { testId: `setting-${name}`, disabled, ...(afterLabel && { afterLabel }) };
    return settingField(this.settings, name, { label, hint, ...input }, usual);
  }

  /** Why the library gives these clips as many inducing points. */
  #whyPoints() {
    const { usual } = this.training;
    const { dynamicsIps, poseIps } = this.settings.values;
    if (!usual || (dynamicsIps > 0 && poseIps > 0)) return nothing;
    const words = lab().learn.settings.whyPoints(
      usual.dynamicsIps,
      usual.dynamicsIps > SETTINGS.dynamicsIps.usual,
    );
    return html`<p class="hint" data-testid="why-points">${words}</p>`;
  }

  #partsField() {
    const { clips } = this;
    const [clip] = clips.ticked;
    const presets = clip?.loaded.info.presets ?? [];
    const { parts } = this.settings.values;
    const words = lab().learn.settings;
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
        <span><pg-term of="part" text=${words.parts}></pg-term></span>
        <select data-testid="setting-parts" aria-label=${words.parts} ?disabled=${clips.locked || !clip} @change=${choose}>
          ${presets.map((preset) => html`<option value=${preset.id} ?selected=${preset.id === chosen}>${shownSplit(preset)}</option>`)}
          <option value=${BY_HAND} ?selected=${byHand}>${words.byHand}</option>
        </select>
      </div>
      <ul class="part-row" aria-label=${words.partsToTrain}>
        ${clips.parts.map(
          ({ name, joints }, part) => html`
          <li style=${partStyle(partColour(part))}><i class="swatch"></i>${shownPart(name)} <small>${words.joints(joints.length)}</small></li>`,
        )}
      </ul>
      ${byHand && clip ? html`<pg-parts-editor .settings=${this.settings} .clips=${clips}></pg-parts-editor>` : nothing}`;
  }

  /** The status next to the button: the plan, the progress or the end. */
  #words(why: string) {
    const { training } = this;
    const { asked, busy, ending } = training;
    const words = lab().learn.training;
    const last = asked.length === 1 ? asked[0]?.steps.at(-1) : undefined;
    const iteration = last
      ? html`<span>${words.iterationOf(last.iteration, last.maxIterations)}${busy ? "" : "."}</span>`
      : nothing;
    if (busy) {
      if (asked.every(({ steps }) => steps.length === 0)) return html`<span>${words.settingUp}</span>`;
      if (asked.some(({ catchingUp }) => catchingUp)) return html`<span>${words.catchingUp}</span>`;
      const done =
        asked.length > 1
          ? html`<span>${words.done(asked.filter(isOver).length, asked.length)}</span>`
          : iteration;
      const left = asked.filter((run) => !isOver(run));
      const watches = left.length > 0 && left.every(({ steps }) => steps.at(-1)?.phase === "own-rollouts");
      return html`${watches ? html`<span>${sentence(lab().learn.phases["own-rollouts"])}</span>` : done}<span>${sentence(timeLeft(secondsLeft(asked, training.workers)))}</span>`;
    }
    if (why) return sentence(why);
    if (ending.failed) return html`<span class="bad">${sentence(words.failed(ending.words))}</span>`;
    if (ending.words) return html`${iteration}<span>${sentence(ending.words)}</span>`;
    const { ticked } = this.clips;
    const made = ticked.every(({ origin }) => origin === "made");
    const of = words.newModels(training.count, ticked.length, made);
    const { cost } = training;
    return cost.words
      ? html`${of} <span class=${cost.absurd ? "bad" : ""} data-testid="cost">${cost.words}</span>`
      : of;
  }

  /** For a run on the stage that stopped before its bound had settled. */
  #continueButton() {
    const { training } = this;
    const run = training.charted;
    if (!run || !training.canContinue(run)) return nothing;
    const more = training.moreIterations(run);
    const words = lab().learn.training;
    return html`<button data-testid="continue" title=${words.continueMeaning(run.settings.seed, more)}
      @click=${() => void training.continue(run)}>${words.continue(more)}</button>`;
  }

  /** Screen readers read the state, not each iteration. */
  #announcement(): string {
    const { status, asked, ending } = this.training;
    const words = lab().learn.training;
    if (status === "running") {
      const done = Math.floor(share(asked) * 10) * 10;
      return asked.some(({ steps }) => steps.length > 0) ? words.share(done) : words.started;
    }
    if (status === "cancelling") return words.cancelling;
    return ending.words ? words.ended(sentence(ending.words)) : "";
  }

  protected override render() {
    const { training, settings } = this;
    const { busy } = training;
    const cancelling = training.status === "cancelling";
    const why = training.whyNot();
    const { field, settings: names, training: words } = lab().learn;
    return html`
      <h2>${words.title}</h2>
      <div class="train-row">
        ${
          busy
            ? html`<button class="primary big" data-testid="cancel" ?disabled=${cancelling}
              title=${words.cancelMeaning} @click=${() => training.cancel()}>${words.cancel}</button>
              <button data-testid="add" ?disabled=${cancelling}
              title=${words.addMeaning} @click=${() => void training.start()}>${words.add}</button>`
            : html`<button class="primary big" data-testid="train" ?disabled=${why !== ""} aria-describedby="train-why"
              @click=${() => void training.start()}>${words.train}</button>
              ${this.#continueButton()}`
        }
        <p id="train-why" class="hint words" data-testid="progress">${this.#words(why)}</p>
      </div>
      ${progressBar(words.title, busy ? share(training.asked) : null)}
      <div class="visually-hidden" role="status" aria-live="polite">${this.#announcement()}</div>
      <div class="fields main-fields">
        ${this.#partsField()}
        ${this.#count("latent", "latent-space", "Q")}
        ${this.#count("dynamicsIps", "dynamics-points", "K")}
        ${this.#count("poseIps", "pose-points", "L")}
        ${this.#count("framesPerSecond")}
      </div>
      ${this.#whyPoints()}
      <details class="advanced">
        <summary>${names.advanced}</summary>
        <div class="fields">
          <div class="field seed">
            <span><label for="seed-input">${names.seed}</label> <pg-term of="seed" text="?" about=${field.about(names.seed)}></pg-term></span>
            ${settingInput(settings, "seed", { id: "seed-input", testId: "setting-seed", disabled: false })}
            <button class="round" aria-label=${names.newSeed} title=${names.newSeed} ?disabled=${!this.engine.engine} @click=${() => void training.newSeed()}>${icon("dice")}</button>
          </div>
          ${this.#count("trainings")}
          ${this.#count("order", "order", "p")}
          ${this.#count("maxIterations", "iterations")}
          <label class="field"><span>${names.poseWeight.label}</span>
            <select data-testid="setting-poseWeight" title=${names.poseWeight.hint}
              @change=${(event: Event) => settings.change({ poseWeight: POSE_WEIGHTS[(event.target as HTMLSelectElement).selectedIndex] ?? "balanced" })}>
              ${POSE_WEIGHTS.map((weight) => html`<option ?selected=${weight === settings.values.poseWeight}>${names.poseWeight.value(weight)}</option>`)}
            </select></label>
        </div>
      </details>
      <pg-bound-chart .training=${training}></pg-bound-chart>`;
  }
}
customElements.define("pg-training", TrainingView);
