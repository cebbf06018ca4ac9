// An exercise in the Lab: its task, what the page measures of the model on the stage, and whether that solves it.
import { html, nothing } from "lit";
import type { BodyStore } from "../couplings/body-store";
import type { ModelStore } from "../couplings/model-store";
import { largestDistance } from "../scene/motion";
import type { SettingsStore } from "../settings/settings-store";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import { View } from "../ui/view";
import { loadTeach, teachIfLoaded } from "../words/sections";
import type { WordsStore } from "../words/words";
import { EXERCISE_NAMES, type Facts, type Finding, judge } from "./exercises";
import "./exercise.css";
import { lab } from "../words/lab";

export class ExerciseView extends View {
  declare body: BodyStore;
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare notices: NoticesStore;
  declare words: WordsStore;
  /** The distance between two motions, computed once for each. */
  #apart: { rollout: unknown; millimetres: number } | null = null;

  protected override stores() {
    return [this.body, this.model, this.settings];
  }

  protected override arrived(): void {
    const { exercise, why } = lab().files.notLoaded;
    loadTeach(this.words).catch(() => this.notices.addError(exercise, why));
  }

  /** What the page measures now; null while it measures. */
  #facts(): Facts | null {
    const { body, model } = this;
    const { rollout, learned } = model;
    if (!model.model || !rollout || !learned || !body.reports || !body.isCurrent) return null;
    if (this.#apart?.rollout !== rollout)
      this.#apart = { rollout, millimetres: 1000 * largestDistance(rollout.motion, learned.motion) };
    return {
      isStartModel: model.openedText === null,
      learned: model.couplings.learned,
      alpha: model.couplings.alpha,
      reports: body.reports,
      apart: this.#apart.millimetres,
      points: Math.max(...model.model.info.dynamicsIps.flat()),
    };
  }

  protected override render() {
    const number = this.settings.values.exercise;
    const name = EXERCISE_NAMES[number - 1];
    const { exercises } = teachIfLoaded() ?? {};
    if (!name || !exercises) return nothing;
    const facts = this.#facts();
    const verdict = facts && judge(name, facts);
    const say = ({ name, values }: Finding) => {
      const sentence = exercises.found[name];
      return typeof sentence === "string"
        ? sentence
        : (sentence as (...values: unknown[]) => string)(...values);
    };
    return html`
      <section class="exercise" aria-label=${exercises.number(number)} data-solved=${verdict?.isSolved ? "yes" : "no"} data-testid="exercise">
        <p><b>${exercises.number(number)}</b> ${exercises.tasks[name]}</p>
        <p class="exercise-found" role="status">${
          verdict
            ? html`<b>${verdict.isSolved ? exercises.solved : exercises.notYet}</b> ${verdict.findings.map(say).join(" ")}
              ${verdict.isSolved ? html`<i>${exercises.whys[name]}</i>` : nothing}`
            : exercises.measuring
        }</p>
        <button class="round" aria-label=${exercises.close} title=${exercises.close} data-testid="close-exercise"
          @click=${() => this.settings.change({ exercise: 0 })}>${icon("close")}</button>
      </section>`;
  }
}
customElements.define("pg-exercise", ExerciseView);
