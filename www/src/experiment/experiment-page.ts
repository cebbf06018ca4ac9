// The view of the synthetic experiment: the true systems, the data, the findings of training, and those of
// other seeds.
import { html, nothing } from "lit";
import { settingField } from "../settings/setting-field";
import type { SettingsStore } from "../settings/settings-store";
import { restOf, shareOf } from "../training/runs";
import { sentence } from "../ui/format";
import { progressBar } from "../ui/progress-bar";
import { randomNumbers } from "../ui/random-numbers";
import "../ui/two-columns.css";
import { View } from "../ui/view";
import "./experiment.css";
import type { ExperimentStore } from "./experiment-store";
import { headline, tally, TEN_SEEDS } from "./experiments";
import { alphaTable, fitTable, verdictWords } from "./findings-tables";
import { CURVE_FRAMES, curvesPicture, latentPicture } from "./pictures";
import { runsTable } from "./runs-table";
import { timeLeft } from "../training/words";
import { endingOf } from "./ending";

const PARTS = [0, 1];

/** The riddles come in this order. */
const RIDDLES = 1;

/** x of a part at a frame, or at the frame before. */
const state = (part: number, before: boolean) => html`x<sub>${part}</sub>(t${before ? html` − 1` : nothing})`;

export class ExperimentPage extends View {
  static override properties = { vote: { state: true }, told: { state: true } };
  /** What the visitor thinks of the riddle: whether part 1 drives part 2; null: no vote yet. */
  declare vote: boolean | null;
  /** The sentence about the last riddle, when its curtain is drawn. */
  declare told: string;
  readonly #random = randomNumbers(RIDDLES);

  constructor() {
    super();
    [this.vote, this.told] = [null, ""];
  }

  declare experiment: ExperimentStore;
  declare settings: SettingsStore;

  protected override stores() {
    return [this.experiment, this.settings];
  }

  protected override arrived(): void {
    this.whenLeaving(this.experiment.follow());
    this.whenLeaving(() => this.experiment.setRiddle(null));
  }

  #beginRiddle(): void {
    [this.vote, this.told] = [null, ""];
    const driving = this.#random() < 0.5;
    // The findings of an earlier training would tell the answer.
    const unknown = this.experiment.open(TEN_SEEDS.map((seed) => ({ seed, driving })));
    const riddles = unknown.length > 0 ? unknown : [{ seed: 0, driving }];
    this.experiment.setRiddle(riddles[Math.floor(this.#random() * riddles.length)] ?? null);
  }

  /** Shows the truth of the riddle, which the address names from now on. */
  #drawCurtain(): void {
    const { experiment, shown } = this.experiment;
    const { seed, driving } = experiment;
    const found = shown?.findings ? ` ${headline(shown.findings, driving)}` : "";
    const truth = driving ? "Part 1 drives part 2." : "Neither drives the other.";
    this.told = `The truth: ${truth} You were ${this.vote === driving ? "right" : "wrong"}.${found}`;
    this.settings.change({ drawn: seed, driving });
    this.experiment.setRiddle(null);
  }

  /** The question of the riddle, and what follows the vote. */
  #riddle() {
    const store = this.experiment;
    const vote = (answer: boolean) => {
      this.vote = answer;
      void store.train([store.experiment]);
    };
    if (this.vote === null)
      return html`
        <fieldset class="riddle"><legend>Does part 1 drive part 2? Look at both, and vote. Then a model learns.</legend>
          <button data-testid="riddle-yes" ?disabled=${store.busy} @click=${() => vote(true)}>Yes</button>
          <button data-testid="riddle-no" ?disabled=${store.busy} @click=${() => vote(false)}>No</button>
        </fieldset>`;
    return html`
      <p>You say ${this.vote ? "yes" : "no"}. ${store.shown?.state === "done" ? "What do you read in the α of step 3?" : ""}</p>
      <button data-testid="riddle-curtain" ?disabled=${store.shown?.state !== "done"} @click=${() => this.#drawCurtain()}>Draw the curtain</button>`;
  }

  /** The status next to the button: the plan, the progress or the end. */
  #status() {
    const { asked, shown, status, busy, width } = this.experiment;
    if (status === "cancelling") return "Stopping";
    if (busy) {
      if (asked.every(({ iteration }) => iteration === 0)) return "Setting up";
      const [first] = asked;
      const over = asked.filter(({ state }) => state === "done" || state === "failed").length;
      const where =
        first && asked.length === 1
          ? `Iteration ${first.iteration}`
          : `${over} of ${asked.length} seeds done`;
      return html`<span>${where}</span><span>${sentence(timeLeft(restOf(asked, width)))}</span>`;
    }
    if (shown?.state === "failed")
      return html`<span class="bad">${sentence(`Training failed: ${shown.ending}`)}</span>`;
    if (shown?.outcome)
      return html`<span>Iteration ${shown.iteration}.</span><span>${sentence(endingOf(shown))}</span>`;
    return "The seed decides the data and the training.";
  }

  /** Screen readers read the state, not each iteration. */
  #announcement(): string {
    const { asked, runs, shown, status, busy } = this.experiment;
    if (status === "running") return `Training, ${Math.floor(shareOf(asked) * 10) * 10} per cent done`;
    if (busy) return "Stopping";
    if (this.experiment.isRiddle) return shown?.outcome || shown?.ending ? "Training ended." : "";
    if (asked.length > 1) return `Training ended. ${tally(runs)}`;
    return shown?.findings && (shown.outcome || shown.ending)
      ? `Training ended. ${headline(shown.findings, shown.driving)}`
      : "";
  }

  /** One button for both actions, so that it keeps the focus. */
  #button() {
    const store = this.experiment;
    const { busy, status, experiment } = store;
    const trained = store.open([experiment]).length === 0;
    const why = busy
      ? "Stops here and keeps the best so far"
      : trained
        ? "This seed was trained to the end; it would find the same again"
        : "";
    return html`
      <button class="primary big" data-testid=${busy ? "experiment-cancel" : "experiment-train"} title=${why}
        ?disabled=${busy ? status === "cancelling" : trained || store.problem !== ""}
        @click=${() => (busy ? store.cancel() : void store.train([experiment]))}>${busy ? "Cancel" : "Train"}</button>`;
  }

  #setup() {
    const { experiment: store } = this;
    const { busy, asked } = store;
    return html`
      <header class="panel-head"><h2>Who drives whom?</h2></header>
      ${store.isRiddle ? this.#riddle() : this.told ? html`<p data-testid="riddle-told">${this.told}</p>` : nothing}
      <div class="train-row">
        ${store.isRiddle ? nothing : this.#button()}
        <p class="hint words" data-testid="experiment-progress">${this.#status()}</p>
      </div>
      ${progressBar("Training", busy ? shareOf(asked) : null)}
      <div class="visually-hidden" role="status" aria-live="polite">${this.#announcement()}</div>
      ${store.isRiddle ? nothing : this.#choice()}`;
  }

  /** The choice of the experiment. */
  #choice() {
    const { experiment: store, settings } = this;
    const { busy, problem } = store;
    const { driving } = store.experiment;
    const ten = TEN_SEEDS.map((seed) => ({ seed, driving }));
    return html`
      ${settingField(settings, "drawn", { label: "Seed", hint: "", testId: "experiment-seed", disabled: false })}
      <label class="choice">
        <input type="checkbox" data-testid="experiment-driving" .checked=${driving}
          @change=${(event: Event) => settings.change({ driving: (event.target as HTMLInputElement).checked })} />
        <span>Part 1 drives part 2 <small>Untick it for the control: two systems that have nothing to do with each other.</small></span>
      </label>
      <button class="small" data-testid="riddle" ?disabled=${busy} title="An experiment whose truth stays behind a curtain" @click=${() => this.#beginRiddle()}>Give me a riddle</button>
      <button class="small" data-testid="experiment-ten" ?disabled=${busy || problem !== "" || store.open(ten).length === 0}
        @click=${() => void store.train(ten)}>Train seeds 0 to 9${driving ? "" : " without driving"}</button>
      <p class="hint">The experiment is that of Velychko et al. (2018), section 5.1. Their draws are not known; these are ours.</p>`;
  }

  #made() {
    const { truth, experiment, isRiddle } = this.experiment;
    const { driving } = experiment;
    if (isRiddle)
      return html`
        <h2><span class="step">1</span> What was made</h2>
        <p>Two systems, each a point that moves in the plane. Whether part 1 drives part 2 is behind a curtain.</p>
        <div class="pictures">${PARTS.map((part) => latentPicture(part, truth, null, null))}</div>`;
    return html`
      <h2><span class="step">1</span> What was made</h2>
      <p>Two systems, each a point that moves in the plane for ${truth?.frames ?? 300} frames.
        ${
          driving
            ? "Part 1 follows a rule of its own. Part 2 follows its own rule too, but one tenth of each move comes from part 1."
            : "Each follows a rule of its own. This is the control: part 1 has no share in part 2."
        }
        The rules are drawn at random, so that the points go round, each at its own rate.</p>
      <p class="formula">${state(1, false)} = g<sub>1</sub>(${state(1, true)})<br />
        ${state(2, false)} = ${driving ? html`0.1 g<sub>1</sub>(${state(1, true)}) + 0.9 ` : nothing}g<sub>2</sub>(${state(2, true)})</p>
      <div class="pictures">${PARTS.map((part) => latentPicture(part, truth, null, null))}</div>`;
  }

  #seen() {
    const { truth } = this.experiment;
    return html`
      <h2><span class="step">2</span> What the model sees</h2>
      <p>Not the points: only ten noisy curves of each part, made from its point by functions that are drawn at random too.
        Nobody tells it who drives whom. The first ${CURVE_FRAMES} frames:</p>
      <div class="curves">${PARTS.map((part) => curvesPicture(part, truth))}</div>`;
  }

  #found() {
    const { truth, shown } = this.experiment;
    const findings = shown?.findings ?? null;
    return html`
      <h2><span class="step">3</span> What training finds</h2>
      <div class="findings">
        <div>
          <div class="pictures">${PARTS.map((part) =>
            latentPicture(part, truth, findings?.learned[part] ?? null, findings?.explained[part] ?? null),
          )}</div>
          <p class="hint">Grey: the true points. Coloured: the learned ones. A model finds its latents only up to stretching, turning and shifting,
            so they are laid over the true ones by least squares.</p>
        </div>
        <div class="answers">
          ${alphaTable(findings)}
          <p class="hint">A small α is a large influence; the weights w into a part sum to 1.
            They need not be the 0.1 and 0.9 of step 1: a larger function makes up for a smaller weight.
            ${truth ? `No α can be larger than ${truth.largestAlpha}.` : ""}</p>
          ${this.experiment.isRiddle ? nothing : verdictWords(shown, truth)}
          ${fitTable(shown)}
          <p class="hint">${truth ? `The noise alone makes an MSE of ${truth.noise}.` : ""}</p>
        </div>
      </div>`;
  }

  #others() {
    const { runs, shown, truth } = this.experiment;
    return html`
      <h2><span class="step">4</span> Try it yourself</h2>
      <p>One seed proves little. Try others, and untick driving: then α from 1 to 2 must become large.
        It does not always work: docs/synthetic.md in the project says how often it did.</p>
      <p class="tally" data-testid="experiment-tally">${tally(runs)}</p>
      ${runsTable(runs, shown, ({ seed, driving }) => this.settings.change({ drawn: seed, driving }))}
      ${
        truth
          ? html`<p class="hint">Found means: α from 2 to 1 is at least ${truth.much} times α from 1 to 1, and α from 1 to 2 within a factor of ${truth.alike} of α from 2 to 2;
            without driving it is at least ${truth.much} times as large.</p>`
          : nothing
      }`;
  }

  protected override render() {
    const { problem } = this.experiment;
    return html`
      <section class="panel panels-setup experiment-setup" aria-label="The experiment">${this.#setup()}</section>
      <div class="panels-found experiment">
        ${
          problem
            ? html`<p class="panel bad" role="alert">The experiment could not be made: ${sentence(problem)}
              <button class="small" @click=${() => this.experiment.draw()}>Try again</button></p>`
            : nothing
        }
        <section class="panel made-panel" aria-label="What was made">${this.#made()}</section>
        <section class="panel" aria-label="What the model sees">${this.#seen()}</section>
        <section class="panel wide-panel" aria-label="What training finds">${this.#found()}</section>
        ${this.experiment.isRiddle ? nothing : html`<section class="panel wide-panel" aria-label="Try it yourself">${this.#others()}</section>`}
      </div>`;
  }
}
customElements.define("pg-synthetic", ExperimentPage);
