// The tabs next to the stage, where a page shows the Lab in a frame: few, because a frame is small.
import { type Settings, TABS } from "../settings/settings";

type Tab = Settings["tab"];

const USUAL: readonly Tab[] = ["listen", "loops"];
/** The exercise in which a model is trained, as its address counts it. */
export const TRAINING_EXERCISE = 6;

export class FrameTabs {
  /** The tabs that an address, a file or an explained term has opened. */
  readonly #opened = new Set<Tab>(USUAL);

  /** The tabs now; a tab that was open stays. */
  shown({ tab, exercise }: Pick<Settings, "tab" | "exercise">): readonly Tab[] {
    this.#opened.add(tab);
    if (exercise === TRAINING_EXERCISE) this.#opened.add("learn");
    return TABS.filter((tab) => this.#opened.has(tab));
  }
}
