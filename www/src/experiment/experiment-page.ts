// The synthetic experiment as a lesson: what was made, what the model sees, what training finds, and with how many seeds.
import { html, nothing } from "lit";
import { lessonOf } from "./experiment-store";
import { changeSettings } from "../settings/change";
import { sentence, timeLeft } from "../ui/format";
import { headline, tally, TEN_SEEDS } from "./experiments";
import { restOf, shareOf } from "../training/runs";
import { onThemeChange } from "../ui/palette";
import { SETTINGS } from "../settings/settings";
import "./experiment.css";
import { View } from "../ui/view";
import { alphaTable, fitTable, verdictWords } from "./found";
import { CURVE_FRAMES, curvesPicture, latentPicture } from "./pictures";
import { triesTable } from "./runs-table";

const PARTS = [0, 1];

export class SyntheticPage extends View {
  static override topics = ["lesson", "settings"] as const;
  private stopTheme: (() => void) | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.stopTheme = onThemeChange(() => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopTheme?.();
  }

  override willUpdate(): void {
    lessonOf(this.app).draw();
  }

  /** Beside the button: what would happen, what is happening, or how it ended. */
  private words() {
    const lesson = lessonOf(this.app);
    const { asked, shown } = lesson;
    if (lesson.status === "cancelling") return "Stopping";
    if (lesson.busy) {
      if (asked.every(({ iteration }) => iteration === 0)) return "Setting up";
      const [first] = asked;
      const where =
        asked.length === 1
          ? `Iteration ${first!.iteration}`
          : `${asked.filter(({ state }) => state === "done" || state === "failed").length} of ${asked.length} seeds done`;
      return html`<span>${where}</span><span>${sentence(timeLeft(restOf(asked, lesson.width)))}</span>`;
    }
    if (shown?.state === "failed") return html`<span class="bad">Training failed. ${sentence(shown.ending)}</span>`;
    if (shown?.ending) return html`<span>Iteration ${shown.iteration}.</span><span>${sentence(shown.ending)}</span>`;
    return "The seed decides the data and the training.";
  }

  /** Heard by screen readers: the state, not each iteration. */
  private announcement(): string {
    const lesson = lessonOf(this.app);
    const { asked, tries, shown } = lesson;
    if (lesson.status === "running") return `Training, ${Math.floor(shareOf(asked) * 10) * 10} per cent done`;
    if (lesson.busy) return "Stopping";
    if (asked.length > 1) return `Training ended. ${tally(tries)}`;
    return shown?.findings && shown.ending ? `Training ended. ${headline(shown.findings, shown.driving)}` : "";
  }

  /** One button, so that it keeps the focus while what it does changes. */
  private button(tried: boolean) {
    const lesson = lessonOf(this.app);
    const { busy, job } = lesson;
    const why = busy
      ? "Stops here and keeps the best so far"
      : tried
        ? "This seed was trained to the end; it would find the same again"
        : "";
    return html`
      <button class="primary big" data-testid=${busy ? "lesson-cancel" : "lesson-train"} title=${why}
        ?disabled=${busy ? lesson.status === "cancelling" : tried || lesson.problem !== ""}
        @click=${() => (busy ? lesson.cancel() : void lesson.train([job]))}>${busy ? "Cancel" : "Train"}</button>`;
  }

  private setup() {
    const { app } = this;
    const lesson = lessonOf(app);
    const { job, asked } = lesson;
    const { min, max } = SETTINGS.drawn;
    const tried = lesson.open([job]).length === 0;
    const ten = TEN_SEEDS.map((seed) => ({ seed, driving: job.driving }));
    return html`
      <header class="panel-head"><h2>Who drives whom?</h2></header>
      <div class="train-row">
        ${this.button(tried)}
        <p class="hint words" data-testid="lesson-progress">${this.words()}</p>
      </div>
      <progress max="1" .value=${lesson.busy ? shareOf(asked) : 0} aria-label="Training" class=${lesson.busy ? "" : "resting"}
        aria-hidden=${lesson.busy ? "false" : "true"}></progress>
      <div class="visually-hidden" role="status" aria-live="polite">${this.announcement()}</div>
      <label class="field"><span>Seed</span>
        <input type="number" data-testid="lesson-seed" min=${min} max=${max} step="1" .value=${String(job.seed)}
          @change=${(event: Event) => {
            const input = event.target as HTMLInputElement;
            changeSettings(app, { drawn: input.valueAsNumber });
            input.value = String(app.settings.drawn);
          }} />
      </label>
      <label class="choice">
        <input type="checkbox" data-testid="lesson-driving" .checked=${job.driving}
          @change=${(event: Event) => changeSettings(app, { driving: (event.target as HTMLInputElement).checked })} />
        <span>Part 1 drives part 2 <small>Untick it for the control: two systems that have nothing to do with each other.</small></span>
      </label>
      <button class="small" data-testid="lesson-ten" ?disabled=${lesson.busy || lesson.problem !== "" || lesson.open(ten).length === 0}
        @click=${() => void lesson.train(ten)}>Train seeds 0 to 9${job.driving ? "" : " without driving"}</button>
      <p class="hint">The experiment is that of Velychko et al. (2018), section 5.1. Their draws are not known; these are ours.</p>`;
  }

  private made() {
    const { truth, job } = lessonOf(this.app);
    const point = (part: number, before: boolean) => html`x<sub>${part}</sub>(t${before ? html` − 1` : nothing})`;
    return html`
      <h2><span class="step">1</span> What was made</h2>
      <p>Two systems, each a point that moves in the plane for ${truth?.frames ?? 300} frames.
        ${
          job.driving
            ? "Part 1 follows a rule of its own. Part 2 follows its own rule too, but one tenth of each move comes from part 1."
            : "Each follows a rule of its own. This is the control: part 1 has no share in part 2."
        }
        The rules are drawn at random, so that the points go round, each at its own rate.</p>
      <p class="formula">${point(1, false)} = g<sub>1</sub>(${point(1, true)})<br />
        ${point(2, false)} = ${job.driving ? html`0.1 g<sub>1</sub>(${point(1, true)}) + 0.9 ` : nothing}g<sub>2</sub>(${point(2, true)})</p>
      <div class="pictures">${PARTS.map((part) => latentPicture(part, truth, null, null))}</div>`;
  }

  private seen() {
    const { truth } = lessonOf(this.app);
    return html`
      <h2><span class="step">2</span> What the model sees</h2>
      <p>Not the points: only ten noisy curves of each part, made from its point by functions that are drawn at random too.
        Nobody tells it who drives whom. The first ${CURVE_FRAMES} frames:</p>
      <div class="curves">${PARTS.map((part) => curvesPicture(part, truth))}</div>`;
  }

  private found() {
    const { truth, shown } = lessonOf(this.app);
    const learned = shown?.findings ?? null;
    return html`
      <h2><span class="step">3</span> What training finds</h2>
      <div class="findings">
        <div>
          <div class="pictures">${PARTS.map((part) => latentPicture(part, truth, learned?.learned[part] ?? null, learned?.explained[part] ?? null))}</div>
          <p class="hint">Grey: the true points. Coloured: the learned ones. A model finds its latents only up to stretching, turning and shifting,
            so they are laid over the true ones by least squares.</p>
        </div>
        <div class="answers">
          ${alphaTable(learned)}
          <p class="hint">A small α is a large influence; the weights w into a part sum to 1.
            They need not be the 0.1 and 0.9 of step 1: a larger function makes up for a smaller weight.
            ${truth ? `No α can be larger than ${truth.largestAlpha}.` : ""}</p>
          ${verdictWords(shown, truth)}
          ${fitTable(shown)}
          <p class="hint">${truth ? `The noise alone makes an MSE of ${truth.noise}.` : ""}</p>
        </div>
      </div>`;
  }

  private tried() {
    const { app } = this;
    const { tries, shown, truth } = lessonOf(app);
    return html`
      <h2><span class="step">4</span> Try it yourself</h2>
      <p>One seed proves little. Try others, and untick driving: then α from 1 to 2 must become large.
        It does not always work: of seeds 0 to 9 with driving, two miss by little; of seeds 0 to 29, five miss.</p>
      <p class="tally" data-testid="lesson-tally">${tally(tries)}</p>
      ${triesTable(tries, shown, ({ seed, driving }) => changeSettings(app, { drawn: seed, driving }))}
      ${
        truth
          ? html`<p class="hint">Found means: α from 2 to 1 is at least ${truth.much} times α from 1 to 1, and α from 1 to 2 within a factor of ${truth.alike} of α from 2 to 2;
            without driving it is at least ${truth.much} times as large.</p>`
          : nothing
      }`;
  }

  protected override render() {
    const lesson = lessonOf(this.app);
    return html`
      <section class="panel lesson-setup" aria-label="The experiment">${this.setup()}</section>
      <div class="lesson">
        ${
          lesson.problem
            ? html`<p class="panel bad" role="alert">The experiment could not be made: ${sentence(lesson.problem)}
              <button class="small" @click=${() => lesson.drawAgain()}>Try again</button></p>`
            : nothing
        }
        <section class="panel made-panel" aria-label="What was made">${this.made()}</section>
        <section class="panel" aria-label="What the model sees">${this.seen()}</section>
        <section class="panel wide-panel" aria-label="What training finds">${this.found()}</section>
        <section class="panel wide-panel" aria-label="Try it yourself">${this.tried()}</section>
      </div>`;
  }
}
customElements.define("pg-synthetic", SyntheticPage);
