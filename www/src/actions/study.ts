// Comparing models: start, follow, cancel; open and save results.
import type { App } from "../app";
import { comparing } from "../comparing";
import { download } from "../download";
import { partsFor } from "../parts";
import type { Comparison, Job, Results, TrainingClip } from "../protocol";
import { find, jobKey, jobs, type Study, type StudyJob } from "../study";
import { messageOf } from "./couplings";

/** Milliseconds between two redraws of what workers report. */
const TELL_EVERY = 150;

/** The comparison of this visit, and how it is going. */
export class Studying {
  study: Study | null = null;
  comparison: Comparison | null = null;
  status: "idle" | "starting" | "running" | "cancelling" = "idle";
  /** How it ended, or why it could not start. */
  ending = "";
  failed = false;
  private stop = new AbortController();
  private telling = false;
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
    if (app.tickedClips().length < 2) return "Tick at least two clips: one is held out, the others are trained on";
    if (app.clash) return app.clash;
    return app.settings.models.length === 0 ? "Tick at least one model" : "";
  }

  /** The jobs that the settings ask for now. */
  asked(): Job[] {
    return jobs(this.app.settings, this.app.tickedClips().length);
  }

  /** Does all jobs that the settings ask for and that are not finished; what is finished on the same trials is kept. */
  async begin(): Promise<void> {
    if (this.busy || this.whyNot()) return;
    const { app } = this;
    this.status = "starting";
    [this.ending, this.failed, this.stop] = ["", false, new AbortController()];
    this.app.tell("study");
    try {
      const { pool, desk } = await comparing();
      this.workers = pool.width;
      const ticked = app.tickedClips();
      const clips = ticked.map(({ loaded, source, first, end }): TrainingClip => ({ id: loaded.id, source, first, end }));
      const { parts, split, framesPerSecond } = app.settings;
      const specs = partsFor(ticked[0]!.loaded.info, parts, split);
      const settings = { parts: specs, framesPerSecond };
      const empty = await desk.run((worker) => worker.emptyResults(clips, settings), this.stop.signal);
      const before = this.study;
      // Pieces of a clip have the whole clip's name and checksum: what is cut counts too.
      const same = before !== null && JSON.stringify([before.results.setting, before.clips.map(cutOf)]) === JSON.stringify([empty.setting, clips.map(cutOf)]);
      const results = same ? before.results : empty;
      const open = this.asked().filter((job) => !find(results, job));
      this.study = {
        clips, parts: specs, framesPerSecond, results,
        titles: ticked.map(({ title }) => title),
        jobs: open.map((job) => ({ job, state: "waiting", fraction: 0, elapsed: 0 })),
        predictions: same ? before.predictions : new Map(),
      };
      if (!same) this.comparison = null;
      this.status = "running";
      app.tell("study");
      await Promise.all(this.study.jobs.map((one) => this.carryOut(one)));
      this.ending = this.summary();
    } catch (problem) {
      const stopped = problem === this.stop.signal.reason;
      [this.ending, this.failed] = stopped ? ["You cancelled before it began.", false] : [messageOf(problem), true];
    }
    this.status = "idle";
    app.tell("study");
  }

  private summary(): string {
    const all = this.study!.jobs;
    if (all.length === 0) return "All of this was finished before.";
    const count = (state: StudyJob["state"]) => all.filter((one) => one.state === state).length;
    const failed = count("failed") > 0 ? `, ${count("failed")} failed` : "";
    const whole = count("cancelled") === 0;
    return `${count("done")} of ${all.length} trainings done${failed}${whole ? "." : "; the others were cancelled."}`;
  }

  private async carryOut(one: StudyJob): Promise<void> {
    const study = this.study!;
    const { signal } = this.stop;
    const { job } = one;
    const finish = (outcome: Results["finished"][number]["outcome"], failure: string | null) => {
      study.results.finished.push({ job, engine: `vcgpdm ${this.app.version}`, outcome, failure });
    };
    try {
      const { pool } = await comparing();
      const evaluated = await pool.run((worker) => {
        one.state = "running";
        const start = performance.now();
        const report = (fraction: number) => {
          one.fraction = fraction;
          one.elapsed = (performance.now() - start) / 1000;
          this.tellSoon();
        };
        const { clips, parts, framesPerSecond } = study;
        const { candidate, held_out, training_trials, seed } = job;
        const settings = { parts, framesPerSecond };
        return worker.evaluate({ clips, settings, candidate, heldOut: held_out, trainingTrials: training_trials, seed }, report, signal);
      }, signal);
      one.state = evaluated ? "done" : "cancelled";
      if (evaluated) {
        study.predictions.set(jobKey(job), evaluated);
        finish(evaluated.outcome, null);
        await this.compare(study.results);
      }
    } catch (problem) {
      one.state = problem === signal.reason ? "cancelled" : "failed";
      if (one.state === "failed") finish(null, messageOf(problem));
    }
    this.tellSoon();
  }

  /** What results say; the newest count, in whatever order the answers come. */
  private async compare(results: Results): Promise<void> {
    const told = results.finished.length;
    const { desk } = await comparing();
    const comparison = await desk.run((worker) => worker.compare(results));
    if (this.study?.results === results && told === results.finished.length) this.comparison = comparison;
  }

  private tellSoon(): void {
    if (this.telling) return;
    this.telling = true;
    setTimeout(() => {
      this.telling = false;
      this.app.tell("study");
    }, TELL_EVERY);
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
    const titles = results.setting.trials.map(({ name }) => name);
    const { parts, frames_per_second } = results.setting;
    this.study = { clips: [], titles, parts, framesPerSecond: frames_per_second, results, jobs: [], predictions: new Map() };
    this.comparison = comparison;
    [this.ending, this.failed] = [`${results.finished.length} results opened.`, false];
    this.app.tell("study");
  }

  save(): void {
    if (this.study) download("comparison.results.json", new Blob([`${JSON.stringify(this.study.results)}\n`], { type: "application/json" }));
  }
}

const cutOf = ({ id, first, end }: TrainingClip) => [id, first, end];

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
