// What a visitor can ask of the page: by a key, by a button, and by an event of a view that has the command's name.
import { messageOf } from "../ui/format";
import { lab } from "../words/lab";
import type { StagedModel } from "../stage/stage-store";
import type { App } from "./app";
import type { LabView } from "./lab-view";
import { openAnyModel, openFiles } from "./open-files";

interface Clock {
  togglePlay(): void;
  step(direction: 1 | -1): void;
}

/** The page, as its commands know it. */
export interface Commanded {
  readonly app: App;
  /** The clock of the open view; null: it has none. */
  readonly clock: Clock | null;
  readonly lab: LabView | null;
  openHelp(): Promise<void>;
}

interface Command {
  /** Works anywhere in the Lab and in its views, unless a control uses it. */
  key?: string;
  /** The key works as long as it is down: `detail` says whether it goes down or up. */
  isHeld?: true;
  /** `detail`: that of the event. */
  // biome-ignore lint/suspicious/noExplicitAny: each command has a detail of its own, and views send what it needs
  run(page: Commanded, detail?: any): unknown;
}

/** Puts a model of another view on the stage. */
async function stageModel(app: App, { text, name, made }: StagedModel): Promise<void> {
  try {
    if (await openAnyModel(app, name, await text, made)) app.settings.change({ view: "play" });
  } catch (problem) {
    app.notices.addError(lab().files.notTakenUp, messageOf(problem));
  }
}

/** Shows the QR code of the present state. */
async function showCode(app: App): Promise<void> {
  try {
    await (await import("./code-dialog")).showCode(app, app.stateFragment);
  } catch {
    app.notices.addError("QR", app.words.now.frame.notLoaded);
  }
}

export const COMMANDS: Readonly<Record<string, Command>> = {
  "toggle-play": { key: " ", run: ({ clock }) => clock?.togglePlay() },
  back: { key: "ArrowLeft", run: ({ clock }) => clock?.step(-1) },
  forward: { key: "ArrowRight", run: ({ clock }) => clock?.step(1) },
  "reset-couplings": { key: "0", run: ({ app }) => app.isPlayView && app.model.couplings.resetAll() },
  "hold-coupling-by-key": { key: "c", isHeld: true, run: ({ lab }, held: boolean) => lab?.holdByKey(held) },
  projector: {
    key: "p",
    run: ({ app: { settings } }) => settings.change({ large: !settings.values.large }),
  },
  share: { key: "q", run: ({ app }) => showCode(app) },
  "show-help": { key: "?", run: (page) => page.openHelp() },
  "show-method": { run: ({ app }) => app.settings.change({ view: "method" }) },
  "show-series": { run: ({ app }) => app.settings.change({ view: "series" }) },
  "show-place": { run: ({ lab }, place: string) => lab?.showPlace(place) },
  "stage-model": { run: ({ app }, model: StagedModel) => stageModel(app, model) },
  "study-made": { run: ({ app }, text: string) => app.openStudy(text, true) },
  "open-files": { run: ({ app }, files: File[]) => openFiles(app, files, null) },
};
