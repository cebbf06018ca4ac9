// The card of the study: its design, the texts for participants, and the movements of the attention checks.
import { html } from "lit";
import type { StudyInfo, StudyPreset, StudyTexts, StudyView } from "../engine/whole-protocol";
import "../terms/term";
import { modelStyle } from "../figures/model-style";
import { plain } from "../figures/numbers";
import { duration } from "../ui/format";
import { icon } from "../ui/icons";
import type { PerceptionStore } from "./perception-store";

const PLANS: Record<StudyPreset, { name: string; meaning: string }> = {
  class: { name: "Class", meaning: "A short one, for a class" },
  "p3-part-1": { name: "P3, part 1", meaning: "As in the first part of Knopp et al. (2019)" },
  "p3-part-2": { name: "P3, part 2", meaning: "As in the second part of Knopp et al. (2019)" },
  p2: { name: "P2", meaning: "As in Velychko et al. (2018)" },
};

const TEXTS: [keyof StudyTexts, string, number][] = [
  ["consent", "Consent", 6],
  ["instructions", "Instructions", 8],
  ["question", "Question of each trial", 2],
  ["pause", "Pause", 3],
  ["end", "After the last trial", 3],
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
  const inBlocks =
    blocks > 1 ? ` in ${blocks} blocks, pauses of at least ${duration(pauseSeconds)} between` : "";
  return `${trials} trials${inBlocks}, about ${minutesOf(info, trials)} minutes.`;
}

const minutesOf = (times: Parameters<typeof lengthOf>[0], trials: number) =>
  Math.max(1, Math.round(lengthOf(times, trials) / 60));

function movementsWords({ stimuli }: StudyInfo): string {
  const natural = stimuli.filter(({ kind }) => kind === "natural").length;
  const failed = stimuli.filter(({ failed }) => failed).length;
  const checks = failed === 0 ? "none of them marked as failed" : `${failed} of them marked as failed`;
  return `${natural} natural and ${stimuli.length - natural} generated movements, ${checks}.`;
}

function textFields(store: PerceptionStore, { texts }: StudyInfo) {
  return html`
    <details class="advanced">
      <summary>What participants read</summary>
      ${TEXTS.map(
        ([name, label, rows]) => html`
        <label class="field wide"><span>${label}</span>
          <textarea rows=${rows} data-testid="text-${name}" .value=${texts[name]} ?disabled=${store.busy}
            @change=${(event: Event) => void store.change({ texts: { ...texts, [name]: (event.target as HTMLTextAreaElement).value } })}></textarea></label>`,
      )}
      <p class="hint">An empty line begins a new paragraph. The texts are saved with the study.</p>
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
  return html`
    <details class="advanced">
      <summary>Movements that check attention</summary>
      <p class="hint">Tick those that have obviously failed, for <pg-term of="attention-check" text="attention checks"></pg-term>. They are left out of the comparison, and who takes more than 15 % of them for natural is left out too.</p>
      <ul class="movement-marks">${generated.map(
        ({ id, model, scores, failed }) => html`
        <li><label class="check"><input type="checkbox" data-testid="failed-${id}" .checked=${failed} ?disabled=${store.busy} @change=${() => toggle(id)} />
          <span>${id} <small>${model ? modelStyle(model).name : ""}, MSE ${plain(scores?.mse ?? NaN)}</small></span></label>
          <button class="round" data-testid="look-${id}" aria-label="Look at ${id}" title="Look at it beside the natural one" @click=${() => look(id)}>${icon("eye")}</button></li>`,
      )}</ul>
    </details>`;
}

/** The open study. `look` shows one of its movements. */
export function studyCard(store: PerceptionStore, look: (id: string) => void) {
  const { study, busy } = store;
  if (!study)
    return html`<p class="empty">${busy ? "Loading the study." : "Open a study (.json) to begin."}</p>`;
  const { info } = study;
  return html`
    <p data-testid="study-title"><strong>${info.title}</strong></p>
    <p class="hint" data-testid="study-words">${designWords(study)} ${movementsWords(info)}</p>
    <div class="plans" role="group" aria-label="Plan">
      ${study.plans.map(
        (plan) => html`
        <button class="small" title=${PLANS[plan.preset].meaning} data-testid="preset-${plan.preset}" aria-pressed=${plan.chosen ? "true" : "false"}
          ?disabled=${busy} @click=${() => void store.change({ preset: plan.preset })}>
          ${PLANS[plan.preset].name} <small>${plan.trials.toLocaleString("en")} trials, ${minutesOf(plan, plan.trials)} min</small></button>`,
      )}
    </div>
    <label class="check"><input type="checkbox" data-testid="points" .checked=${info.look === "points"} ?disabled=${busy}
      @change=${() => void store.change({ look: info.look === "points" ? "figure" : "points" })} />
      <span>Point lights <small>Dots at the joints instead of grey figures.</small></span></label>
    ${textFields(store, info)}
    ${marks(store, info, look)}`;
}
