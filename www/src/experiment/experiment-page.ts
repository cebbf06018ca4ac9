// The view of the synthetic experiment: the true systems, the data, the findings of training, and those of
// other seeds.
import { html, nothing } from "lit";
import { settingField } from "../settings/setting-field";
import type { SettingsStore } from "../settings/settings-store";
import { restOf, shareOf } from "../training/runs";
import { localNumber, sentence } from "../ui/format";
import { experimentWords } from "./view-words";
import { progressBar } from "../ui/progress-bar";
import { download } from "../ui/download";
import { icon } from "../ui/icons";
import { randomNumbers } from "../ui/random-numbers";
import "../ui/two-columns.css";
import { View } from "../ui/view";
import type { Draw } from "../views/define-view";
import "./experiment.css";
import type { SyntheticFindings } from "../engine/whole-protocol";
import type { ExperimentStore } from "./experiment-store";
import { headline, tally, TEN_SEEDS } from "./experiments";
import { alphaTable, endingOf, fitTable, runsTable, verdictWords } from "./findings-tables";
import { timeLeft } from "../training/words";
import { curvesPicture, latentPicture, snapshotLegend, snapshotPictures } from "./pictures";
import { SETTINGS } from "../settings/settings";

/** The most frames of the curves; more would blur. In a riddle, more would show the answer. */
const CURVE_FRAMES = 100;
const RIDDLE_FRAMES = 40;
const PARTS = [0, 1];

/** The riddles come in this order. */
const RIDDLES = 1;

/** x of a part at a frame, or at the frame before. */
const state = (part: number, before: boolean) => html`x<sub>${part}</sub>(t${before ? html` − 1` : nothing})`;

export class ExperimentPage extends View {
  static override properties = { vote: { state: true }, told: { state: true } };
  /** What the visitor thinks of the riddle: whether part 1 drives part 2; null: no vote yet. */
  vote: boolean | null = null;
  /** The last riddle, when its curtain is drawn; null: none, or its curtain is not drawn. */
  told: { driving: boolean; right: boolean; findings: SyntheticFindings | null } | null = null;
  readonly #random = randomNumbers(RIDDLES);

  declare experiment: ExperimentStore;
  declare settings: SettingsStore;

  protected override arrived(): void {
    this.whenLeaving(this.experiment.follow());
    this.whenLeaving(() => this.experiment.setRiddle(null));
    // The view begins with a riddle, unless the address or an earlier training names an experiment.
    const { drawn, driving } = this.settings.values;
    if (drawn === 0 && driving && this.experiment.runs.length === 0) this.#beginRiddle();
    // A link or Back to another experiment ends the riddle.
    const named = () => JSON.stringify([this.settings.values.drawn, this.settings.values.driving]);
    const before = named();
    this.whenLeaving(
      this.settings.on(
        () => this.experiment.isRiddle && named() !== before && this.experiment.setRiddle(null),
      ),
    );
  }

  #beginRiddle(): void {
    [this.vote, this.told] = [null, null];
    const driving = this.#random() < 0.5;
    const { points } = this.experiment.experiment;
    // The findings of an earlier training would tell the answer.
    const unknown = this.experiment.open(TEN_SEEDS.map((seed) => ({ seed, driving, points })));
    const riddles = unknown.length > 0 ? unknown : [{ seed: 0, driving, points }];
    this.experiment.setRiddle(riddles[Math.floor(this.#random() * riddles.length)] ?? null);
  }

  /** Shows the truth of the riddle, which the address names from now on. */
  #drawCurtain(): void {
    const { experiment, shown } = this.experiment;
    const { seed, driving } = experiment;
    this.told = { driving, right: this.vote === driving, findings: shown?.findings ?? null };
    this.settings.change({ drawn: seed, driving });
    this.experiment.setRiddle(null);
  }

  /** The sentence about the riddle whose curtain is drawn. */
  #truth() {
    if (this.told === null) return nothing;
    const { driving, right, findings } = this.told;
    const found = findings ? headline(findings, driving) : "";
    return html`<p data-testid="riddle-told">${experimentWords().riddle.truth(driving, right)} ${found}</p>`;
  }

  /** The question of the riddle, and what follows the vote. */
  #riddle() {
    const store = this.experiment;
    const words = experimentWords().riddle;
    const none = html`<button class="small" data-testid="riddle-none" @click=${() => store.setRiddle(null)}>${words.none}</button>`;
    const vote = (answer: boolean) => {
      this.vote = answer;
      void store.train([store.experiment]);
    };
    if (this.vote === null)
      return html`
        <fieldset class="riddle"><legend>${words.question}</legend>
          <button class="small" data-testid="riddle-yes" ?disabled=${store.busy} @click=${() => vote(true)}>${words.yes}</button>
          <button class="small" data-testid="riddle-no" ?disabled=${store.busy} @click=${() => vote(false)}>${words.no}</button>
        </fieldset>
        ${none}`;
    return html`
      ${store.shown?.state === "done" ? nothing : none}
      <p>${words.voted(this.vote)} ${store.shown?.state === "done" ? words.read : ""}</p>
      <button class="small" data-testid="riddle-curtain" ?disabled=${store.shown?.state !== "done"} @click=${() => this.#drawCurtain()}>${words.curtain}</button>`;
  }

  /** The status next to the button: the plan, the progress or the end. */
  #status() {
    const { asked, shown, status, busy, width } = this.experiment;
    const words = experimentWords();
    if (status === "cancelling") return words.stopping;
    if (busy) {
      if (asked.every(({ iteration }) => iteration === 0)) return words.settingUp;
      const [first] = asked;
      const over = asked.filter(({ state }) => state === "done" || state === "failed").length;
      const where =
        first && asked.length === 1 ? words.iteration(first.iteration) : words.seedsDone(over, asked.length);
      return html`<span>${where}</span><span>${sentence(timeLeft(restOf(asked, width)))}</span>`;
    }
    if (shown?.state === "failed")
      return html`<span class="bad">${sentence(words.failed(shown.ending))}</span>`;
    if (shown?.outcome)
      return html`<span>${words.iteration(shown.iteration)}.</span><span>${sentence(endingOf(shown))}</span>`;
    return words.seedDecides;
  }

  /** Screen readers read the state, not each iteration. */
  #announcement(): string {
    const { asked, runs, shown, status, busy } = this.experiment;
    const words = experimentWords();
    if (status === "running") return words.share(Math.floor(shareOf(asked) * 10) * 10);
    if (busy) return words.stopping;
    if (this.experiment.isRiddle) return shown?.outcome || shown?.ending ? words.ended : "";
    if (asked.length > 1) return `${words.ended} ${tally(runs)}`;
    return shown?.findings && (shown.outcome || shown.ending)
      ? `${words.ended} ${headline(shown.findings, shown.driving)}`
      : "";
  }

  /** One button for both actions, so that it keeps the focus. */
  #button() {
    const store = this.experiment;
    const words = experimentWords();
    const { busy, status, experiment } = store;
    const trained = store.open([experiment]).length === 0;
    const why = busy ? words.cancelMeaning : trained ? words.trained : "";
    return html`
      <button class="primary big" data-testid=${busy ? "experiment-cancel" : "experiment-train"} title=${why}
        ?disabled=${busy ? status === "cancelling" : trained || store.problem !== ""}
        @click=${() => (busy ? store.cancel() : void store.train([experiment]))}>${busy ? words.cancel : words.train}</button>`;
  }

  #setup() {
    const { experiment: store } = this;
    const { busy, asked } = store;
    const words = experimentWords();
    return html`
      <header class="panel-head row"><h2>${words.title}</h2></header>
      ${store.isRiddle ? this.#riddle() : this.#truth()}
      <div class="train-row row wrap">
        ${store.isRiddle ? nothing : this.#button()}
        <p class="hint words" data-testid="experiment-progress">${this.#status()}</p>
      </div>
      ${progressBar(words.training, busy ? shareOf(asked) : null)}
      <div class="visually-hidden" role="status" aria-live="polite">${this.#announcement()}</div>
      ${store.isRiddle ? nothing : this.#choice()}`;
  }

  /** The choice of the experiment. */
  #choice() {
    const { experiment: store, settings } = this;
    const { busy, problem } = store;
    const { driving, points } = store.experiment;
    const words = experimentWords();
    const ten = TEN_SEEDS.map((seed) => ({ seed, driving, points }));
    return html`
      ${settingField(settings, "drawn", { label: words.seed, hint: "", testId: "experiment-seed", disabled: false })}
      <label class="choice">
        <input type="checkbox" data-testid="experiment-driving" .checked=${driving}
          @change=${(event: Event) => settings.change({ driving: (event.target as HTMLInputElement).checked })} />
        <span>${words.driving} <small class="own-line">${words.drivingHint}</small></span>
      </label>
      <div class="row spread"><span id="points-label">${words.points} <small class="own-line">${words.pointsHint}</small></span>
        <span class="segments" role="group" aria-labelledby="points-label">${SETTINGS.drawnPoints.values.map(
          (value) => html`
          <button aria-pressed=${value === points ? "true" : "false"} data-testid="experiment-points-${value}"
            @click=${() => settings.change({ drawnPoints: value })}>${value}</button>`,
        )}</span></div>
      <button class="small" data-testid="riddle" ?disabled=${busy} title=${words.riddle.giveMeaning} @click=${() => this.#beginRiddle()}>${words.riddle.give}</button>
      <button class="small" data-testid="experiment-ten" ?disabled=${busy || problem !== "" || store.open(ten).length === 0}
        @click=${() => void store.train(ten)}>${words.ten(driving)}</button>
      <p class="hint">${words.source}</p>`;
  }

  #made() {
    const { truth, experiment, isRiddle } = this.experiment;
    const { driving } = experiment;
    const words = experimentWords().made;
    if (isRiddle)
      return html`
        <h2><span class="step note">1</span> ${words.title}</h2>
        <p>${words.hidden}</p>`;
    return html`
      <h2><span class="step note">1</span> ${words.title}</h2>
      <p>${words.points(truth?.frames ?? 300)} ${driving ? words.driven : words.control} ${words.rules}</p>
      <p class="formula">${state(1, false)} = g<sub>1</sub>(${state(1, true)})<br />
        ${state(2, false)} = ${driving ? html`${localNumber("0.1")} g<sub>1</sub>(${state(1, true)}) + ${localNumber("0.9")} ` : nothing}g<sub>2</sub>(${state(2, true)})</p>
      <div class="pictures">${PARTS.map((part) => latentPicture(part, truth, null))}</div>`;
  }

  #seen() {
    const { truth, isRiddle } = this.experiment;
    const words = experimentWords().seen;
    const frames = isRiddle ? RIDDLE_FRAMES : CURVE_FRAMES;
    return html`
      <h2><span class="step note">2</span> ${words.title}</h2>
      <p>${words.text(frames)}</p>
      <div class="curves">${PARTS.map((part) => curvesPicture(part, truth, frames))}</div>`;
  }

  #found() {
    const { truth, shown, isRiddle } = this.experiment;
    const findings = shown?.findings ?? null;
    const words = experimentWords().found;
    const picture = (part: number) => latentPicture(part, truth, findings?.model ?? null);
    return html`
      <h2><span class="step note">3</span> ${words.title}</h2>
      <div class=${isRiddle ? "" : "findings"}>
        ${isRiddle ? nothing : html`<div><div class="pictures">${PARTS.map(picture)}</div><p class="hint">${words.colours}</p></div>`}
        <div class="answers stack">
          ${alphaTable(findings)}
          <p class="hint">${words.alpha} ${truth ? words.largest(truth.largestAlpha) : ""}</p>
          ${this.experiment.isRiddle ? nothing : verdictWords(shown, truth)}
          ${fitTable(shown)}
          <p class="hint">${truth ? words.noise(truth.noise) : ""}</p>
        </div>
      </div>`;
  }

  /** The model before and after training, and its file. */
  #inside() {
    const { truth, shown, experiment } = this.experiment;
    const words = experimentWords().inside;
    const text = shown?.findings?.text ?? "";
    const name = `synthetic-${experiment.seed}.model.json`;
    const file = () => new File([text], name, { type: "application/json" });
    return html`
      <h2><span class="step note">4</span> ${words.title}</h2>
      <p>${words.text(experiment.points)}</p>
      <div class="pictures parts-inside">${PARTS.map((part) => snapshotPictures(part, truth, shown?.findings?.model ?? null))}</div>
      ${snapshotLegend()}
      <p class="hint">${words.curves} ${words.control}</p>
      <div class="row wrap">
        <button class="small" data-testid="experiment-save" ?disabled=${text === ""} @click=${() => download(name, file())}>${icon("save")} ${words.save}</button>
        <button class="small" data-testid="experiment-series" ?disabled=${text === ""} @click=${() => this.tell("open-files", [file()])}>${words.open}</button>
        <span class="hint">${words.file}</span>
      </div>`;
  }

  #others() {
    const { runs, shown, truth } = this.experiment;
    const words = experimentWords().others;
    return html`
      <h2><span class="step note">5</span> ${words.title}</h2>
      <p>${words.text}</p>
      <p class="tally" data-testid="experiment-tally">${tally(runs)}</p>
      ${runsTable(runs, shown, ({ seed, driving }) => this.settings.change({ drawn: seed, driving }))}
      ${truth ? html`<p class="hint">${words.means(truth.much, truth.alike)}</p>` : nothing}`;
  }

  protected override render() {
    const { problem, isRiddle } = this.experiment;
    const words = experimentWords();
    return html`
      <section class="panel panels-setup scroll stack loose experiment-setup" aria-label=${words.setup}>${this.#setup()}</section>
      <div class="panels-found scroll stack experiment" ?data-riddle=${isRiddle}>
        ${
          problem
            ? html`<p class="panel bad" role="alert">${words.notMade(sentence(problem))}
              <button class="small" @click=${() => this.experiment.draw()}>${words.tryAgain}</button></p>`
            : nothing
        }
        <section class="panel made-panel" aria-label=${words.made.title}>${this.#made()}</section>
        <section class="panel" aria-label=${words.seen.title}>${this.#seen()}</section>
        ${isRiddle && this.vote === null ? nothing : html`<section class="panel wide-panel" aria-label=${words.found.title}>${this.#found()}</section>`}
        ${
          isRiddle
            ? nothing
            : html`<section class="panel wide-panel" aria-label=${words.inside.title}>${this.#inside()}</section>
        <section class="panel wide-panel" aria-label=${words.others.title}>${this.#others()}</section>`
        }
      </div>`;
  }
}
customElements.define("pg-synthetic", ExperimentPage);

export const draw: Draw<"synthetic"> = (experiment, { settings }) =>
  html`<pg-synthetic .experiment=${experiment} .settings=${settings}></pg-synthetic>`;
