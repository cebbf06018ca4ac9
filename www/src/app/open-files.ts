// Files that a visitor drops or chooses: motion clips (.bvh), models, libraries, results of comparisons and
// studies (.json), tables of time series and answers to a study (.csv; and answers as .json).
import { LARGEST_FILE } from "../clips/clips-store";
import { messageOf, sentence } from "../ui/format";
import type { Place } from "../ui/notices-store";
import { stageWork } from "../couplings/model-work";
import { mayLose } from "../ui/unsaved";
import type { App } from "./app";

/**
 * Opens the files one after the other. What went wrong is said where they landed; null: in the list of clips.
 */
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
  const tables: File[] = [];
  for (const file of files) {
    try {
      if (file.size > LARGEST_FILE)
        throw new Error("This file has more than 200 MB; expected a motion clip or a model.");
      if (/\.csv$/i.test(file.name)) {
        ((await isAnswersTable(app, file)) ? answers : tables).push(file);
      } else if (/\.json$/i.test(file.name)) {
        const text = await file.text();
        if (isAnswers(text)) answers.push(file);
        else await openJson(app, file.name, text);
      } else if (/\.bvh$/i.test(file.name)) {
        opened += 1;
        await clips.open(file, opened === 1);
      } else {
        throw new Error("Expected a motion clip (.bvh), a model (.json) or a table (.csv).");
      }
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
  if (opened > 0) await clips.checkClash();
  if (answers.length > 0) await openAnswers(app, answers);
  if (tables.length > 0) await openTables(app, tables, refuse);
}

/** jsPsych's rows say what kind of trial each is; and where the study is shown, a table is to be answers. */
async function isAnswersTable(app: App, file: File): Promise<boolean> {
  if (app.settings.values.view === "perception") return true;
  const [header = ""] = (await file.slice(0, 2000).text()).split("\n");
  return /\btrial_type\b/.test(header);
}

/** A file with an error does not keep the others away. */
async function openTables(app: App, files: readonly File[], refuse: (title: string, text: string) => void) {
  app.settings.change({ view: "series" });
  const { tables } = await app.series.get();
  for (const file of files) {
    try {
      await tables.open(file);
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
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
    if (await (await app.comparison.get()).open(text)) app.settings.change({ view: "compare" });
    return;
  }
  if (/"kind"\s*:\s*"library"/.test(text.slice(0, 200))) {
    const { imports } = await app.primitives.get();
    app.settings.change({ view: "primitives" });
    await imports.openFile(text, name);
    return;
  }
  // A model says early what its columns are: a body's pose, or those of tables.
  if (/"columns"\s*:\s*\[\s*\{/.test(text.slice(0, 600))) {
    const { model } = await app.series.get();
    if (await model.open(text)) app.settings.change({ view: "series" });
    return;
  }
  await openModel(app, text);
}

/**
 * Puts a model on the stage, and says whether: the visitor may keep the one that is there. `made`: it was
 * made here, and is on no disk.
 */
export async function openModel(app: App, text: string, made = false): Promise<boolean> {
  const refuse = () => {
    if (app.training.busy) throw new Error("A training is running: cancel it before opening a model.");
  };
  refuse();
  if (!(await mayLose(stageWork(app.model, app.engine)))) return false;
  refuse();
  await app.model.open(text);
  if (made) app.model.markMadeHere();
  app.training.unchoose();
  return true;
}
