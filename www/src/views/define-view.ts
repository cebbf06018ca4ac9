// A view of the page. Its folder has a file entry.ts, which is all that the page, the build and the tests of sizes
// and imports need to know, and a file whose name ends with -page.ts, which draws the view.
import type { TemplateResult } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import type { WholeWorkers } from "../engine/whole-workers";
import type { SettingsStore } from "../settings/settings-store";
import type { ViewName, ViewStores } from "../settings/views";
import type { NoticesStore } from "../ui/notices-store";
import type { Language, WordsStore } from "../words/words";

/** What the page gives to its views. */
export interface Page {
  readonly engine: EngineStore;
  readonly settings: SettingsStore;
  readonly clips: ClipsStore;
  readonly notices: NoticesStore;
  readonly words: WordsStore;
  readonly workers: WholeWorkers;
  /** The view has changed something that the session stores. */
  readonly touched: () => void;
}

export interface View<Name extends ViewName = ViewName> {
  /** In the address of the page, and the folder of the built files. */
  name: Name;
  /** The most gzipped bytes of the folders assets/NAME and NAME of the built page. */
  budget: number;
  /** The place in the navigation; null: only a visitor who has opened the view finds it there, at the end. */
  place: number | null;
  /** The name in the navigation, and the sentence above the view. */
  words: Readonly<Record<Language, { name: string; lead: string }>>;
  /** Loads and makes the stores. */
  stores(page: Page): Promise<ViewStores[Name]>;
}

/**
 * The -page.ts of a view exports this as `draw`. An element with the attribute `data-clock` has a motion, which
 * the keys play and step.
 */
export type Draw<Name extends ViewName> = (stores: ViewStores[Name], page: Page) => TemplateResult;

export const defineView = <Name extends ViewName>(view: View<Name>): View<Name> => view;
