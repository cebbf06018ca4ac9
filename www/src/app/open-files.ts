// Files that a visitor drops or chooses: motion clips (.bvh), models, libraries, results of comparisons and studies (.json), answers to a
// study (.csv; and .json where the graphics Turing test is shown).
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
  const answers: File[] = [];
  for (const file of files) {
    try {
      if (file.size > LARGEST_FILE)
        throw new Error("This file has more than 200 MB; expected a motion clip or a model.");
      if (/\.csv$/i.test(file.name)) {
        answers.push(file);
      } else if (/\.json$/i.test(file.name)) {
        const text = await file.text();
        if (isAnswers(text)) answers.push(file);
        else await openJson(app, file.name, text);
      } else if (/\.bvh$/i.test(file.name)) {
        opened += 1;
        await clips.open(file, opened === 1);
      } else {
        throw new Error("Expected a motion clip (.bvh), a model (.json) or answers to a study (.csv).");
      }
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
  if (opened > 0) await clips.checkClash();
  if (answers.length > 0) await openAnswers(app, answers);
}

/** jsPsych's data are a list; no other file of ours is. */
const isAnswers = (text: string) => /^\s*\[/.test(text.slice(0, 200));

/** The answers of several participants are analysed together, beside those that are open. */
async function openAnswers(app: App, files: readonly File[]): Promise<void> {
  app.settings.change({ view: "perception" });
  const [perception, analysis] = await Promise.all([app.perception.get(), app.analysis.get()]);
  await perception.ready();
  const texts = await Promise.all(files.map(async (file) => ({ name: file.name, text: await file.text() })));
  if (perception.study) await analysis.add(perception.study.text, texts);
}

/** Results of a comparison, studies and libraries say so themselves; anything else is to be a model. */
async function openJson(app: App, name: string, text: string): Promise<void> {
  if (/"format"\s*:\s*"vcgpdm study"/.test(text.slice(0, 200))) {
    await app.openStudy(text);
    return;
  }
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
