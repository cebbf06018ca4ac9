// The card of the study: its design, the texts for participants, and the movements of the attention checks.
import { html } from "lit";
import type { StudyInfo, StudyTexts, StudyView } from "../engine/whole-protocol";
import { withTerms } from "../terms/term";
import { modelStyle } from "../figures/model-style";
import { plain } from "../figures/numbers";
import { duration, grouped } from "../ui/format";
import { icon } from "../ui/icons";
import { perceptionWords } from "./view-words";
import type { PerceptionStore } from "./perception-store";
import { shownText, storedText } from "./standard-texts";

/** The texts in their order, each with the rows of its field. */
const TEXTS: [keyof StudyTexts, number][] = [
  ["consent", 6],
  ["instructions", 8],
  ["question", 2],
  ["pause", 3],
  ["end", 3],
];

/** The usual time of an answer, in seconds. */
const ANSWER = 1;

/** The usual time of a whole participation, in seconds. */
export function lengthOf(
  { crossSeconds, seconds, design }: Pick<StudyInfo, "crossSeconds" | "seconds" | "design">,
  trials: number,
): number {
  return trials * (crossSeconds + seconds + ANSWER) + (design.blocks - 1) * design.pauseSeconds;
}

function designWords({ info, trials }: StudyView): string {
  const { blocks, pauseSeconds } = info.design;
  return perceptionWords().study.design(trials, blocks, duration(pauseSeconds), minutesOf(info, trials));
}

const minutesOf = (times: Parameters<typeof lengthOf>[0], trials: number) =>
  Math.max(1, Math.round(lengthOf(times, trials) / 60));

function movementsWords({ stimuli }: StudyInfo): string {
  const natural = stimuli.filter(({ kind }) => kind === "natural").length;
  const failed = stimuli.filter(({ failed }) => failed).length;
  return perceptionWords().study.movements(natural, stimuli.length - natural, failed);
}

function textFields(store: PerceptionStore, { texts }: StudyInfo) {
  const words = perceptionWords().study.texts;
  const write = (name: keyof StudyTexts, text: string) =>
    void store.change({ texts: { ...texts, [name]: storedText(name, text) } });
  return html`
    <details class="advanced">
      <summary>${words.title}</summary>
      ${TEXTS.map(
        ([name, rows]) => html`
        <label class="field stack wide"><span>${words[name]}</span>
          <textarea rows=${rows} data-testid="text-${name}" .value=${shownText(name, texts[name])} ?disabled=${store.busy}
            @change=${(event: Event) => write(name, (event.target as HTMLTextAreaElement).value)}></textarea></label>`,
      )}
      <p class="hint">${words.hint}</p>
    </details>`;
}

/** The choice of the generated movements so bad that every attentive participant sees it. */
function marks(store: PerceptionStore, { stimuli }: StudyInfo, look: (id: string) => void) {
  const generated = stimuli.filter(({ kind }) => kind === "generated");
  const failed = generated.filter(({ failed }) => failed).map(({ id }) => id);
  const toggle = (id: string) =>
    void store.change({
      failed: failed.includes(id) ? failed.filter((other) => other !== id) : [...failed, id],
    });
  const words = perceptionWords().study.marks;
  return html`
    <details class="advanced">
      <summary>${words.title}</summary>
      <p class="hint">${withTerms(words.hint)}</p>
      <ul class="movement-marks stack">${generated.map(
        ({ id, model, scores, failed }) => html`
        <li><label class="check"><input type="checkbox" data-testid="failed-${id}" .checked=${failed} ?disabled=${store.busy} @change=${() => toggle(id)} />
          <span>${id} <small class="own-line">${model ? modelStyle(model).name : ""}, MSE ${plain(scores?.mse ?? NaN)}</small></span></label>
          <button class="round" data-testid="look-${id}" aria-label=${words.lookAt(id)} title=${words.look} @click=${() => look(id)}>${icon("eye")}</button></li>`,
      )}</ul>
    </details>`;
}

/** The open study. `look` shows one of its movements. */
export function studyCard(store: PerceptionStore, look: (id: string) => void) {
  const { study, busy } = store;
  const words = perceptionWords().study;
  if (!study) return html`<p class="empty">${busy ? words.loading : words.openFirst}</p>`;
  const { info } = study;
  return html`
    <p data-testid="study-title"><strong>${info.title}</strong></p>
    <p class="hint" data-testid="study-words">${designWords(study)} ${movementsWords(info)}</p>
    <div class="plans wrap tight" role="group" aria-label=${words.plan}>
      ${study.plans.map(
        (plan) => html`
        <button class="small" title=${words.plans[plan.preset].meaning} data-testid="preset-${plan.preset}" aria-pressed=${plan.chosen ? "true" : "false"}
          ?disabled=${busy} @click=${() => void store.change({ preset: plan.preset })}>
          ${words.plans[plan.preset].name} <small>${words.planLength(grouped(plan.trials), minutesOf(plan, plan.trials))}</small></button>`,
      )}
    </div>
    <label class="check"><input type="checkbox" data-testid="points" .checked=${info.look === "points"} ?disabled=${busy}
      @change=${() => void store.change({ look: info.look === "points" ? "figure" : "points" })} />
      <span>${words.points} <small class="own-line">${words.pointsMeaning}</small></span></label>
    ${textFields(store, info)}
    ${marks(store, info, look)}`;
}
