// Hands counted for the answers of a question, by keys. No rendering.
import { Store } from "../ui/store";

export class Tally extends Store {
  readonly #hands = new Map<string, string[]>();

  /** Counts a hand for an answer to a question. */
  add(question: string, answer: string): void {
    const hands = this.#hands.get(question) ?? [];
    this.#hands.set(question, [...hands, answer]);
    this.changed();
  }

  /** Takes the last hand of a question back. */
  takeBack(question: string): void {
    this.#hands.set(question, this.#hands.get(question)?.slice(0, -1) ?? []);
    this.changed();
  }

  count(question: string, answer: string): number {
    return this.#hands.get(question)?.filter((hand) => hand === answer).length ?? 0;
  }

  total(question: string): number {
    return this.#hands.get(question)?.length ?? 0;
  }

  /** The answer with the most hands; null: no hand was counted, or two answers have as many. */
  favourite(question: string): string | null {
    const answers = [...new Set(this.#hands.get(question))];
    const [first, second] = answers
      .map((answer) => ({ answer, hands: this.count(question, answer) }))
      .sort((a, b) => b.hands - a.hands);
    return first && first.hands !== second?.hands ? first.answer : null;
  }
}
