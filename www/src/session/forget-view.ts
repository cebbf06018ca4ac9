// "Forget everything" in the footer: asks with numbers, and can be undone until the page is left.
import { html } from "lit";
import { messageOf } from "../ui/format";
import { forgetKept } from "../ui/browser";
import type { NoticesStore } from "../ui/notices-store";
import { isConfirmed } from "../unsaved/unsaved";
import { View } from "../ui/view";
import type { AnswerCounts } from "../perception/answer-database";
import type { SessionStore } from "./session-store";
import { sessionWords } from "../words/sections";

interface Forgettable {
  contents: string;
  earlierVisits: number;
}

/** What is stored, piece by piece. `answers`: null when they could not be counted. */
function pieces({ contents, earlierVisits }: Forgettable, answers: AnswerCounts | null): string[] {
  const words = sessionWords();
  return [
    ...(contents === "" ? [] : [words.ofVisits(contents, earlierVisits)]),
    ...(answers === null ? [words.allAnswers] : []),
    ...(answers && answers.participants > 0 ? [words.answers(answers.answers, answers.participants)] : []),
  ];
}

/** "This removes 2 clips and a training, and 60 answers of 3 participants on this machine." */
function lossText(forgettable: Forgettable, answers: AnswerCounts | null): string {
  const stored = pieces(forgettable, answers);
  const { storesNothing, removes } = sessionWords();
  return stored.length === 0 ? storesNothing : removes(stored);
}

/** The same when it has happened. */
const forgottenText = (forgettable: Forgettable, answers: AnswerCounts | null): string =>
  sessionWords().forgotten(pieces(forgettable, answers));

/** The page as this view sees it. */
interface Page {
  readonly notices: NoticesStore;
  countAnswers(): Promise<AnswerCounts>;
  forgetAnswers(): Promise<() => Promise<void>>;
}

export class ForgetView extends View {
  static override properties = { undo: { state: true }, busy: { state: true } };
  declare session: SessionStore;
  declare app: Page;
  /** Brings everything back; null: nothing was forgotten. */
  undo: (() => Promise<void>) | null = null;
  busy = false;
  #forgotten = "";

  async #forget(): Promise<void> {
    const { session, app } = this;
    const { forgettable } = session;
    const answers = await app.countAnswers().catch(() => null);
    const words = sessionWords();
    const text = `${lossText(forgettable, answers)} ${words.undoable}`;
    if (!(await isConfirmed(words.forgetTitle, text, words.forget))) return;
    this.#forgotten = forgottenText(forgettable, answers);
    await this.#act(words.notForgotten, async () => {
      const undoes: (() => Promise<void>)[] = [];
      try {
        const restore = forgetKept();
        undoes.push(async () => restore());
        undoes.push(await session.forgetAll());
        undoes.push(await app.forgetAnswers());
      } finally {
        if (undoes.length > 0) this.undo = () => this.#undoAll(undoes);
      }
    });
  }

  /** After a failure the next call goes on with the rest. */
  async #undoAll(undoes: (() => Promise<void>)[]): Promise<void> {
    for (let last = undoes.at(-1); last; last = undoes.at(-1)) {
      await last();
      undoes.pop();
    }
    this.undo = null;
  }

  async #act(failure: string, action: () => Promise<void>): Promise<void> {
    this.busy = true;
    try {
      await action();
    } catch (problem) {
      this.app.notices.addError(failure, messageOf(problem));
    }
    this.busy = false;
    await this.updateComplete;
    this.querySelector("button")?.focus();
  }

  protected override render() {
    const { undo, busy } = this;
    const words = sessionWords();
    return html`<span role="status" data-testid="forgotten">${undo ? this.#forgotten : ""}</span>
      ${
        undo
          ? html`<button class="small" data-testid="undo-forget" ?disabled=${busy} @click=${() => void this.#act(words.notBack, undo)}>${words.undo}</button>`
          : html`<button class="link" data-testid="forget" ?disabled=${busy} @click=${() => void this.#forget()}>${words.forget}</button>`
      }`;
  }
}
customElements.define("pg-forget", ForgetView);
