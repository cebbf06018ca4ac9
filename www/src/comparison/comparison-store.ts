// Comparing models: start, follow, cancel; open and save results.
import type { App } from "../app/app";
import { comparing } from "../engine/whole-engine";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { partsFor } from "../clips/parts";
import type { Comparison, Evaluated, Job, PartSpec, Results, TrainingClip } from "../engine/protocol";
import { isCoupled, jobKey, jobs, openJobs, sameSetting, type Study, type StudyJob, studyKey } from "./jobs";

/** Studies that are kept, so that settings can be changed to and fro. */
const MOST_STUDIES = 4;
/** Motions that are kept of a study: some hundred kilobytes each. */
const MOST_MOTIONS = 400;

/** What the settings ask to compare on. */
interface Asked {
  clips: TrainingClip[];
  parts: PartSpec[];
  framesPerSecond: number;
  key: string;
  jobs: Job[];
}

/** The comparison of this visit, and how it is going. */
export class Studying {
  study: Study | null = null;
  comparison: Comparison | null = null;
  status: "idle" | "starting" | "running" | "cancelling" = "idle";
  /** How it ended, or why it could not start. */
  ending = "";
  failed = false;
  /** What is looked at: the trial held out (0: the first there is), the models (null: the first of each kind), and whether it plays. */
  readonly look: { fold: number; picked: string[] | null; playing: boolean | null } = {
    fold: 0,
    picked: null,
    playing: null,
  };
  private readonly studies = new Map<string, { study: Study; comparison: Comparison | null }>();
  private stop = new AbortController();
  private counting: Promise<void> | null = null;
  private workers = 1;

  constructor(private readonly app: App) {}

  get busy(): boolean {
    return this.status !== "idle";
  }

  /** How many jobs are done at once. */
  get width(): number {
    return this.workers;
  }

  /** Why Compare cannot be pressed now; empty when it can. */
  whyNot(): string {
    const { app } = this;
    if (app.engineState === "loading") return "Getting ready";
    if (!app.engine) return "The models cannot run in this browser";
    if (!app.samplesLoaded) return "Getting the sample clips ready";
    const { models, heldOut } = app.settings;
    const ticked = app.tickedClips().length;
    if (ticked < 2) return "Tick at least two clips: one is held out, the others are trained on";
    if (app.clash) return app.clash;
    if (heldOut > ticked) return `There is no trial ${heldOut}: ${ticked} clips are ticked`;
    if (models.length === 0) return "Tick at least one model";
    if (models.every(isCoupled) && this.parts().length < 2) return "The ticked models need two parts or more";
    return "";
  }

  private parts(): PartSpec[] {
    const [clip] = this.app.tickedClips();
    const { parts, split } = this.app.settings;
    return clip ? partsFor(clip.loaded.info, parts, split) : [];
  }

  private asked(): Asked {
    const { app } = this;
    const ticked = app.tickedClips();
    const clips = ticked.map(({ loaded, source, first, end }): TrainingClip => ({ id: loaded.id, source, first, end }));
    const parts = this.parts();
    const { framesPerSecond } = app.settings;
    return {
      clips,
      parts,
      framesPerSecond,
      key: studyKey(clips, parts, framesPerSecond),
      jobs: jobs(app.settings, clips.length, parts.length),
    };
  }

  /** What a press of Compare would do: how many trainings there are, how many of them are open, and whether it goes on with what is shown. */
  outlook(): { all: number; open: number; goesOn: boolean } {
    const asked = this.asked();
    const known = this.studies.get(asked.key)?.study ?? null;
    return {
      all: asked.jobs.length,
      open: openJobs(asked.jobs, known).length,
      goesOn: !this.study || this.study.key === asked.key,
    };
  }

  /** Does all jobs that the settings ask for and that are not finished; what is finished on the same trials is kept. */
  async begin(): Promise<void> {
    if (this.busy || this.whyNot()) return;
    this.status = "starting";
    [this.ending, this.failed, this.stop] = ["", false, new AbortController()];
    const { signal } = this.stop;
    this.app.tell("study");
    try {
      const { pool, desk } = await comparing();
      this.workers = pool.width;
      const asked = this.asked();
      const { clips, parts, framesPerSecond } = asked;
      const empty = await desk.run((worker) => worker.emptyResults(clips, { parts, framesPerSecond }), signal);
      signal.throwIfAborted();
      const study = this.takeUp(asked, empty);
      study.jobs = openJobs(asked.jobs, study).map((job) => ({
        job,
        state: "waiting",
        fraction: 0,
        elapsed: 0,
        why: "",
      }));
      this.status = "running";
      this.app.tell("study");
      await Promise.all(study.jobs.map((one) => this.carryOut(study, one, signal)));
      await this.counting;
      this.ending = summary(study.jobs);
    } catch (problem) {
      const stopped = signal.aborted;
      [this.ending, this.failed] = stopped ? ["You cancelled before it began.", false] : [messageOf(problem), true];
    }
    this.status = "idle";
    this.app.tell("study");
  }

  /** The study of what is asked for: as it was left, with the results of an opened file, or a new one. */
  private takeUp({ clips, parts, framesPerSecond, key }: Asked, empty: Results): Study {
    const known = this.studies.get(key);
    const opened =
      this.study?.clips.length === 0 && sameSetting(this.study.results.setting, empty.setting) ? this.study : null;
    const ticked = this.app.tickedClips();
    const { figure, joints } = ticked[0]!.loaded.info;
    const study = known?.study ?? {
      key,
      clips,
      framesPerSecond,
      titles: ticked.map(({ title }) => title),
      body: { figure, joints: joints.map(({ name }) => name), parts },
      results: opened?.results ?? empty,
      jobs: [],
      predictions: new Map(),
      actual: new Map(),
    };
    if (this.study?.key !== key) this.comparison = known?.comparison ?? (opened ? this.comparison : null);
    this.study = study;
    this.keep();
    return study;
  }

  /** The newest studies stay, so that settings can be changed to and fro. */
  private keep(): void {
    const { study, comparison } = this;
    if (!study || study.clips.length === 0) return;
    this.studies.delete(study.key);
    this.studies.set(study.key, { study, comparison });
    for (const key of [...this.studies.keys()].slice(0, -MOST_STUDIES)) this.studies.delete(key);
  }

  private async carryOut(study: Study, one: StudyJob, signal: AbortSignal): Promise<void> {
    const { job } = one;
    try {
      const { pool } = await comparing();
      const evaluated = await pool.run((worker) => {
        one.state = "running";
        const start = performance.now();
        const report = (fraction: number) => {
          one.fraction = fraction;
          one.elapsed = (performance.now() - start) / 1000;
          this.app.tellSoon("study");
        };
        const { clips, framesPerSecond } = study;
        const { candidate, held_out: heldOut, training_trials: trainingTrials, seed } = job;
        const settings = { parts: study.body!.parts, framesPerSecond };
        return worker.evaluate({ clips, settings, candidate, heldOut, trainingTrials, seed }, report, signal);
      }, signal);
      one.state = evaluated ? "done" : "cancelled";
      if (evaluated) this.finish(study, job, evaluated);
    } catch (problem) {
      // Only what came of a training is a result; one that was stopped or could not be done may be asked for again.
      one.state = signal.aborted ? "cancelled" : "failed";
      one.why = messageOf(problem);
    }
    this.app.tellSoon("study");
  }

  private finish(study: Study, job: Job, { outcome, predicted, actual, frameTime }: Evaluated): void {
    const key = jobKey(job);
    const { results, predictions } = study;
    if (job.training_trials === results.setting.trials.length - 1) {
      predictions.set(key, { positions: predicted, frameTime });
      study.actual.set(job.held_out, { positions: actual, frameTime });
      if (predictions.size > MOST_MOTIONS) predictions.delete(predictions.keys().next().value!);
    }
    const before = results.finished.findIndex((finished) => jobKey(finished.job) === key);
    if (before >= 0 && results.finished[before]!.outcome) return; // done again for its motion
    if (before >= 0) results.finished.splice(before, 1);
    results.finished.push({ job, engine: `vcgpdm ${this.app.version}`, outcome, failure: null });
    this.counting ??= this.count(study);
  }

  /** Asks what the results say, again while more come in. */
  private async count(study: Study): Promise<void> {
    try {
      const { desk } = await comparing();
      for (let told = -1; told !== study.results.finished.length; ) {
        told = study.results.finished.length;
        const comparison = await desk.run((worker) => worker.compare(study.results));
        if (this.study === study) this.comparison = comparison;
      }
      this.keep();
    } catch (problem) {
      this.app.notify({ kind: "error", title: "The tables could not be made", text: messageOf(problem), at: null });
    } finally {
      this.counting = null;
      this.app.tellSoon("study");
    }
  }

  /** Stops; finished folds are kept. */
  cancel(): void {
    if (this.status !== "running" && this.status !== "starting") return;
    this.status = "cancelling";
    this.stop.abort();
    this.app.tell("study");
  }

  /** Shows the results that come with the page: all models on ten recorded walks. */
  async openWalks(): Promise<void> {
    const answer = await fetch(new URL("comparison/walks.results.json", document.baseURI));
    if (!answer.ok) throw new Error(`the host answered ${answer.status} for ${answer.url}`);
    await this.open(await answer.text());
  }

  /** Shows the results that a file holds: from this page or from the terminal. */
  async open(text: string): Promise<void> {
    if (this.busy) throw new Error("A comparison is running: cancel it before opening results.");
    const results = readResults(text);
    const { desk } = await comparing();
    const comparison = await desk.run((worker) => worker.compare(results));
    const { trials, frames_per_second: framesPerSecond } = results.setting;
    this.study = {
      key: "",
      clips: [],
      titles: trials.map(({ name }) => name),
      body: null,
      framesPerSecond,
      results,
      jobs: [],
      predictions: new Map(),
      actual: new Map(),
    };
    this.comparison = comparison;
    [this.ending, this.failed] = [`${results.finished.length} results opened.`, false];
    this.app.tell("study");
  }

  save(): void {
    if (this.study)
      download(
        "comparison.results.json",
        new Blob([`${JSON.stringify(this.study.results)}\n`], { type: "application/json" }),
      );
  }
}

function summary(all: readonly StudyJob[]): string {
  if (all.length === 0) return "All of this was finished before.";
  const count = (state: StudyJob["state"]) => all.filter((one) => one.state === state).length;
  const failed = count("failed") > 0 ? `, ${count("failed")} failed` : "";
  return `${count("done")} of ${all.length} trainings done${failed}${count("cancelled") === 0 ? "." : "; the others were cancelled."}`;
}

function readResults(text: string): Results {
  try {
    return JSON.parse(text) as Results;
  } catch (problem) {
    throw new Error(`Expected the results of an evaluation as JSON: ${messageOf(problem)}`);
  }
}

const all = new WeakMap<App, Studying>();

/** The comparison of this page's visit. */
export function studying(app: App): Studying {
  let one = all.get(app);
  if (!one) all.set(app, (one = new Studying(app)));
  return one;
}
