// Files that a visitor drops or chooses: motion clips (.bvh), models and results of comparisons (.json).
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
        await openJson(app, await file.text());
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

/** The results of a comparison say so themselves; anything else is to be a model. */
async function openJson(app: App, text: string): Promise<void> {
  if (/"format"\s*:\s*"vcgpdm-evaluation"/.test(text.slice(0, 200))) {
    await (await app.comparison.get()).open(text);
    app.settings.change({ view: "compare" });
    return;
  }
  if (app.training.busy) throw new Error("A training is running: cancel it before opening a model.");
  await app.model.open(text);
  app.training.unchoose();
}
