// Files that a visitor drops or chooses: motion clips (.bvh), models, libraries, results of comparisons and
// studies (.json), tables of time series and answers to a study (.csv; and answers as .json).
import { LARGEST_FILE } from "../clips/clips-store";
import { messageOf, sentence } from "../ui/format";
import type { Place } from "../ui/notices-store";
import { stageWork } from "../couplings/model-work";
import { mayLose } from "../unsaved/unsaved";
import type { DocumentKind } from "../engine/protocol";
import type { App } from "./app";
import { hasNoCouplings } from "../couplings/model-document";
import { lab } from "../words/lab";

/** In bytes. */
const LONGEST_HEADER = 100_000;

/**
 * Opens the files one after the other. A notice at the place of the drop says what failed; null: the notice
 * is in a corner of the page.
 */
export async function openFiles(app: App, files: readonly File[], at: Place | null): Promise<void> {
  const { notices, clips } = app;
  const { engine, problem } = app.engine;
  notices.clear();
  const refuse = (title: string, text: string) => notices.add({ kind: "error", title, text, at });
  if (!engine) {
    const text = sentence(problem) || lab().files.gettingReady;
    return refuse(lab().files.nothingOpened, text);
  }
  let opened = 0;
  const answers: File[] = [];
  const tables: File[] = [];
  for (const file of files) {
    try {
      if (file.size > LARGEST_FILE) throw new Error(lab().files.tooLarge);
      if (/\.csv$/i.test(file.name)) {
        ((await isAnswersTable(app, file)) ? answers : tables).push(file);
      } else if (/\.json$/i.test(file.name)) {
        const text = await file.text();
        const kind = await engine.documentKind(text);
        if (kind === "list") answers.push(file);
        else await openJson(app, kind, file.name, text);
      } else if (/\.bvh$/i.test(file.name)) {
        opened += 1;
        await clips.open(file, opened === 1);
      } else {
        throw new Error(lab().files.expected);
      }
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
  if (opened > 0) {
    app.settings.change({ panel: "learn" });
    await clips.checkClash();
  }
  if (answers.length > 0) await openAnswers(app, answers);
  if (tables.length > 0) await openTables(app, tables, refuse);
}

/** Tables of jsPsych have a column trial_type. In the view of the study every table is taken for answers. */
async function isAnswersTable(app: App, file: File): Promise<boolean> {
  if (app.settings.values.view === "perception") return true;
  const [header = ""] = (await file.slice(0, LONGEST_HEADER).text()).split(/[\r\n]/);
  return /\btrial_type\b/.test(header);
}

/** A file with an error does not stop the others. */
async function openTables(app: App, files: readonly File[], refuse: (title: string, text: string) => void) {
  app.settings.change({ view: "series" });
  const { tables } = await app.view("series").get();
  for (const file of files) {
    try {
      await tables.open(file);
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
}

/** Adds the answers of several participants to those that are open. */
async function openAnswers(app: App, files: readonly File[]): Promise<void> {
  app.settings.change({ view: "perception" });
  const { perception, analysis } = await app.view("perception").get();
  await perception.ready();
  const texts = await Promise.all(files.map(async (file) => ({ name: file.name, text: await file.text() })));
  if (perception.study) await analysis.add(perception.study.text, texts);
}

/** A document of no known kind is opened as a model, whose reader says what was expected. */
async function openJson(app: App, kind: DocumentKind, name: string, text: string): Promise<void> {
  if (kind === "study") {
    await app.openStudy(text);
  } else if (kind === "results") {
    if (await (await app.view("compare").get()).open(text)) app.settings.change({ view: "compare" });
  } else if (kind === "library") {
    const { library } = await app.view("primitives").get();
    app.settings.change({ view: "primitives" });
    await library.openFile(text, name);
  } else if (kind === "series-model") {
    const { model } = await app.view("series").get();
    if (await model.open(text)) app.settings.change({ view: "series" });
  } else {
    await openAnyModel(app, name, text);
  }
}

/** Puts a model of any kind on the stage, as `openModel`. `name`: that of its file. */
export async function openAnyModel(app: App, name: string, text: string, made = false): Promise<boolean> {
  if (!hasNoCouplings(text)) return openModel(app, text, made);
  await (await import("./any-model")).showAnyModel(app, { name, text, link: null });
  return true;
}

/**
 * Puts a model on the stage. Returns false when the visitor keeps the present one instead. `made`: the model
 * was made here and is on no disk.
 */
export async function openModel(app: App, text: string, made = false): Promise<boolean> {
  const refuse = () => {
    if (app.training.busy) throw new Error(lab().files.trainingRuns);
  };
  refuse();
  if (!(await mayLose(stageWork(app.model, app.engine)))) return false;
  refuse();
  await app.model.open(text);
  if (made) app.model.markMadeHere();
  app.training.unchoose();
  return true;
}
