// Files that a visitor drops or chooses: motion clips (.bvh), models, libraries and results of comparisons (.json).
import { LARGEST_FILE } from "../clips/clips-store";
import { messageOf, sentence } from "../ui/format";
import type { Place } from "../ui/notices-store";
import type { App } from "./app";

/** Opens the files one after the other. What went wrong is said where they landed; null: in the list of clips. */
export async function openFiles(app: App, files: readonly File[], at: Place | null): Promise<void> {
  const { engine, notices, clips } = app;
  notices.clear();
  const refuse = (title: string, text: string) => notices.add({ kind: "error", title, text, at });
  if (!engine.engine) {
    const text = sentence(engine.problem) || "The page is still getting ready; try again in a moment.";
    return refuse("Nothing was opened", text);
  }
  let opened = 0;
  for (const file of files) {
    try {
      if (file.size > LARGEST_FILE)
        throw new Error("This file has more than 200 MB; expected a motion clip or a model.");
      if (/\.json$/i.test(file.name)) {
        await openJson(app, file.name, await file.text());
      } else if (/\.bvh$/i.test(file.name)) {
        opened += 1;
        await clips.open(file, opened === 1);
      } else {
        throw new Error("Expected a motion clip (.bvh) or a model (.json).");
      }
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
  if (opened > 0) await clips.checkClash();
}

/** Results of a comparison and libraries say so themselves; anything else is to be a model. */
async function openJson(app: App, name: string, text: string): Promise<void> {
  if (/"format"\s*:\s*"vcgpdm-evaluation"/.test(text.slice(0, 200))) {
    await (await app.comparison.get()).open(text);
    app.settings.change({ view: "compare" });
    return;
  }
  if (/"kind"\s*:\s*"library"/.test(text.slice(0, 200))) {
    const { library } = await app.primitives.get();
    await library.open(text, name);
    app.settings.change({ view: "primitives" });
    return;
  }
  await openModel(app, text);
}

/** Puts a model on the stage. */
export async function openModel(app: App, text: string): Promise<void> {
  if (app.training.busy) throw new Error("A training is running: cancel it before opening a model.");
  await app.model.open(text);
  app.training.unchoose();
}
