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
import { DARES } from "../settings/settings";
import { changesOf, EXERCISE_NAMES, type Facts, type Finding, judge } from "./exercises";
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

  protected override arrived(): void {
    const { exercise, why } = lab().files.notLoaded;
    loadTeach(this.words).catch(() => this.notices.addError(exercise, why));
  }

  /** What the page measures now; null while it measures. */
  #facts(isDare: boolean): Facts | null {
    const { body, model } = this;
    const { rollout, learned } = model;
    if (!model.model || !rollout || !learned || !body.reports || !body.isCurrent) return null;
    if (this.#apart?.rollout !== rollout)
      this.#apart = { rollout, millimetres: 1000 * largestDistance(rollout.motion, learned.motion) };
    return {
      // A dare comes with its model.
      isStartModel: isDare || model.openedText === null,
      learned: model.couplings.learned,
      alpha: model.couplings.alpha,
      reports: body.reports,
      apart: this.#apart.millimetres,
      points: Math.max(...model.model.info.dynamicsIps.flat()),
    };
  }

  protected override render() {
    const { exercise: number, says } = this.settings.values;
    const dare = (["pose", "pace"] as const).find((name) => DARES[name] === number);
    const name = dare ?? EXERCISE_NAMES[number - 1];
    const { exercises } = teachIfLoaded() ?? {};
    if (!name || !exercises) return nothing;
    const facts = this.#facts(dare !== undefined);
    const verdict = facts && judge(name, facts);
    // One arrow is enough: it is part of the dare.
    const isSolved = verdict?.isSolved && !(dare === "pose" && changesOf(facts!).length > 1);
    const { dares } = exercises;
    const title = dare ? dares.title : exercises.number(number);
    const say = ({ name, values }: Finding) => {
      const sentence = exercises.found[name];
      return typeof sentence === "string"
        ? sentence
        : (sentence as (...values: unknown[]) => string)(...values);
    };
    return html`
      <section class="exercise" aria-label=${title} data-solved=${isSolved ? "yes" : "no"} data-testid="exercise">
        ${dare && says ? html`<p data-testid="said">“${says}”</p>` : nothing}
        <p><b>${title}</b> ${dare ? dares.tasks[dare] : exercises.tasks[name]}</p>
        <p class="exercise-found hint" role="status">${
          verdict
            ? html`<b>${isSolved ? (dare ? dares.met : exercises.solved) : exercises.notYet}</b> ${verdict.findings.map(say).join(" ")}
              ${isSolved ? html`<i class="own-line">${exercises.whys[name]}</i>` : nothing}`
            : exercises.measuring
        }</p>
        <button class="round" aria-label=${exercises.close} title=${exercises.close} data-testid="close-exercise"
          @click=${() => this.settings.change({ exercise: 0, says: "" })}>${icon("close")}</button>
      </section>`;
  }
}
customElements.define("pg-exercise", ExerciseView);
