// The page for teachers: slides, plans, exercises and the codes of a class.
import { html, nothing } from "lit";
import type { App } from "../app/app";
import { siteHead } from "../app/site-head";
import { EXERCISE_NAMES } from "../exercises/exercises";
import { addressOf } from "../settings/chapters";
import { DARES } from "../settings/settings";
import { View } from "../ui/view";
import { loadTeach, teachIfLoaded, teachWords } from "../words/sections";
import { addressOf as linkOf } from "../app/code";
import { codePicture, showCode } from "../app/code-dialog";
import { keepLength, lengthOfPlan, type PlanLength, type Step, type StepWords, timesOf } from "./plans";
import "./teach.css";

const LENGTHS: readonly PlanLength[] = [45, 90];
/** The addresses of steps that are no chapters. */
const ADDRESSES: Partial<Record<Step, string>> = { compare: "view=compare" };

const EXERCISES = [...EXERCISE_NAMES, "hands"] as const;

function addressOfExercise(place: number): string {
  if (EXERCISES[place] === "hands") return `view=draw&exercise=${DARES.hand}`;
  return `exercise=${place + 1}${EXERCISES[place] === "few" ? "&tab=learn&dynamics=6" : ""}`;
}

export class TeachPage extends View {
  declare app: App;
  #length: PlanLength = lengthOfPlan();

  protected override stores() {
    return [this.app.settings, this.app.words];
  }

  protected override arrived(): void {
    const { teach, notLoaded } = this.app.words.now.frame;
    void loadTeach(this.app.words).catch(() => this.app.notices.addError(teach, notLoaded));
  }

  #choose(length: PlanLength): void {
    this.#length = length;
    this.requestUpdate();
    keepLength(length);
  }

  /** The chapters on the whole screen, from the first one. */
  #startSlides(): void {
    // A browser that refuses shows the slides in the window.
    document.documentElement.requestFullscreen?.().catch(() => {});
    this.app.lecture.turn(true);
    this.app.settings.change({ teach: false, chapter: 1 });
  }

  /** The answer of a chapter, and likely questions with theirs. */
  #asked({ answer, asked }: StepWords) {
    const { notes } = teachWords();
    if (!asked) return nothing;
    return html`<details><summary>${notes.asked}</summary>
      ${answer ? html`<p><b>${notes.answer}:</b> ${answer}</p>` : nothing}
      <dl>${asked.map(([question, reply]) => html`<dt>${question}</dt><dd>${reply}</dd>`)}</dl></details>`;
  }

  #plan() {
    const { plan, steps } = teachWords();
    const words = this.app.words.now;
    const title = (step: Step) => {
      const { title } = words.chapters[step as keyof typeof words.chapters] ?? {};
      if (title) return html`<a href="#story=${addressOf(step)}">${title}</a>`;
      const name = plan.do[step as keyof typeof plan.do];
      return ADDRESSES[step] ? html`<a href="#${ADDRESSES[step]}">${name}</a>` : name;
    };
    const [minutes, ...others] = plan.columns;
    return html`
      <section aria-labelledby="teach-plan">
        <h2 id="teach-plan">${plan.title}</h2>
        <div class="story-choice" role="group" aria-label=${plan.length}>
          ${LENGTHS.map(
            (length) =>
              html`<button aria-pressed=${this.#length === length ? "true" : "false"} data-testid="plan-${length}" @click=${() => this.#choose(length)}>${plan.minutes(length)}</button>`,
          )}
        </div>
        <table class="teach-plan">
          <thead class="hint"><tr><th scope="col">${minutes}</th>${others.map((column) => html`<th scope="col">${column}</th>`)}</tr></thead>
          <tbody>${timesOf(this.#length).map(
            ({ step, from, to }) => html`
            <tr><td>${from}–${to}</td><th scope="row">${title(step)}</th><td>${steps[step].say}${this.#asked(steps[step])}</td><td>${steps[step].wrong}</td></tr>`,
          )}</tbody>
        </table>
      </section>`;
  }

  #exercises() {
    const { exercises, notes } = teachWords();
    return html`
      <section class="teach-sheet" aria-labelledby="teach-exercises">
        <h2 id="teach-exercises">${exercises.title}</h2>
        <p>${exercises.lead}</p>
        <ol>
          ${EXERCISES.map((name, place) => {
            const fragment = addressOfExercise(place);
            return html`
            <li>
              <div>
                <p>${exercises.tasks[name]}</p>
                <p class="teach-why quiet">${exercises.whys[name]}</p>
                <details><summary>${notes.answer}</summary><p>${exercises.solutions[name]}</p></details>
                <p class="teach-links"><a href="#${fragment}" data-testid="try-${name}">${exercises.try}</a>
                  <button class="link" @click=${() => void showCode(this.app, fragment)}>${exercises.code}</button></p>
              </div>
              <div class="teach-code">${codePicture(linkOf(fragment), exercises.number(place + 1))}</div>
            </li>`;
          })}
        </ol>
        <button class="story-button" data-testid="print" @click=${() => print()}>${exercises.print}</button>
      </section>`;
  }

  #content() {
    const { title, lead, slides, codes } = teachWords();
    return html`
      <main class="teach-main" tabindex="-1">
        <h1>${title}</h1>
        <p class="teach-lead quiet">${lead}</p>
        <section aria-labelledby="teach-slides">
          <h2 id="teach-slides">${slides.title}</h2>
          <dl>${Object.values(slides.keys).map(
            ([keys = "", meaning = ""]) =>
              html`<div><dt>${keys.split(" ").map((key) => html`<kbd>${key}</kbd> `)}</dt><dd>${meaning}</dd></div>`,
          )}</dl>
          <button class="story-button" data-testid="start-slides" @click=${() => this.#startSlides()}>${slides.start}</button>
        </section>
        ${this.#plan()}
        ${this.#exercises()}
        <section aria-labelledby="teach-codes">
          <h2 id="teach-codes">${codes.title}</h2>
          <p>${codes.text}</p>
          <p><a href="#view=perception">${codes.open}</a></p>
        </section>
      </main>`;
  }

  protected override updated(): void {
    if (teachIfLoaded()) document.title = `${teachWords().title} · ${this.app.words.now.frame.page}`;
  }

  protected override render() {
    return html`<div class="teach" data-state=${teachIfLoaded() ? "open" : "loading"}>
      ${siteHead(this.app, "teach")}
      ${teachIfLoaded() ? this.#content() : nothing}
    </div>`;
  }
}
customElements.define("pg-teach", TeachPage);
