// The comparisons of this visit: the plan of a press of Compare, the progress of the trainings, the results,
// and the visitor's choices.
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import type { Evaluated, PlannedComparison, ResultsView } from "../engine/whole-protocol";
import type { SettingsStore } from "../settings/settings-store";
import type { CostWords } from "../training/cost";
import type { FirstMotion } from "../stage/first-motion.js";
import { messageOf } from "../ui/format";
import { Job } from "../ui/job";
import { mayLose } from "../unsaved/unsaved";
import {
  type ComparisonEntry,
  givenEntry,
  keepMotions,
  newEntry,
  type ReadonlyEntry,
  saveResults,
  withResult,
  workOf,
} from "./comparison-entry";
import { costOf, type JobProgress, openJobs, summary, waiting } from "./jobs";
import { type ComparisonRequest, comparisonRequest } from "./comparison-request";
import { studyRequestOf } from "./study-request";
import { compareWords } from "./view-words";
import { lab } from "../words/lab";

/** The most stored comparisons. They let the visitor change settings and return. */
const MOST_ENTRIES = 4;

/** The figure of learning time needs models trained on at least this many numbers of trials. */
const NUMBERS_OF_TRIALS = 3;

/** The plan of a press of Compare. */
export interface Outlook {
  /** The number of trainings that the settings ask for. */
  asked: number;
  /** The number of those that are not finished. */
  open: number;
  /** Whether it would continue the shown comparison. */
  goesOn: boolean;
  /** Whether the trainings would have enough numbers of trials to show the growth of their time. */
  growth: boolean;
  /** The cost of the unfinished trainings. */
  cost: CostWords;
}

/** The visitor's choices for the display. */
export interface Look {
  /** The held-out trial, counted from 0; null: the first one with predictions. */
  readonly fold: number | null;
  /** The models; null: the first of each kind. */
  readonly picked: readonly string[] | null;
  /** Null: as the visitor's system says. */
  readonly playing: boolean | null;
}

interface Asked {
  request: ComparisonRequest;
  /** The comparison that would continue. */
  stored: ComparisonEntry | null;
  /** The results at the time of this request. */
  text: string | null;
}

/** The other stores that a comparison needs. */
export type EngineState = Pick<EngineStore, "state" | "on">;
export type SettingsNow = Pick<SettingsStore, "values" | "on">;
export type ClipsNow = Pick<ClipsStore, "ticked" | "toTrainOn" | "parts" | "clash" | "samplesLoaded" | "on">;

export class ComparisonStore extends Job {
  readonly #entries = new Map<string, ComparisonEntry>();
  readonly #planning: Latest<Asked, PlannedComparison>;
  #shown: ComparisonEntry | null = null;
  #isPlanning = false;
  #width = 1;
  #look: Look = { fold: null, picked: null, playing: null };
  #asked: Asked | null = null;
  #planned: { asked: Asked; planned: PlannedComparison } | null = null;
  /** Why the plan is impossible. */
  #planProblem = "";
  /** Outcomes are added one after the other, each to the results with the previous one. */
  #adding: Promise<unknown> = Promise.resolve();
  /** Which results the worker holds: only the new outcome is sent to it. */
  readonly #states = new WeakMap<ResultsView, number>();

  constructor(
    private readonly engine: EngineState,
    private readonly settings: SettingsNow,
    private readonly clips: ClipsNow,
    private readonly whole: WholeWorkers,
  ) {
    super();
    this.#planning = new Latest(
      async (asked) => {
        this.#width = whole.pool.width;
        return whole.desk.run((worker) => plan(worker, asked));
      },
      (planned, asked) => this.#answered({ asked, planned }, ""),
      // A failed load or a dead worker says nothing about the plan, so that Compare stays enabled.
      (problem) => this.#answered(null, isRefusal(problem) ? messageOf(problem) : ""),
    );
  }

  get shown(): ReadonlyEntry | null {
    return this.#shown;
  }

  /** Whether the models are loaded, before the first training begins. */
  get isPlanning(): boolean {
    return this.#isPlanning;
  }

  /** Whether a study can be made of the movements of the shown comparison. */
  get canMakeStudy(): boolean {
    return this.#shown !== null && studyRequestOf(this.#shown) !== null;
  }

  /** The text of a study of these movements. Fails with the reason when there is none. */
  async makeStudy(): Promise<string> {
    const request = this.#shown && studyRequestOf(this.#shown);
    if (!request) throw new Error(compareWords().noModelYet);
    return this.whole.desk.run((worker) => worker.makeStudy(request));
  }

  /** The number of jobs that run at the same time. */
  get width(): number {
    return this.#width;
  }

  get look(): Look {
    return this.#look;
  }

  /** Null before the program has answered. */
  get outlook(): Outlook | null {
    if (!this.#planned) return null;
    const { asked, planned } = this.#planned;
    const stored = planned.goesOn ? asked.stored : null;
    const numbersOfTrials = new Set(planned.jobs.map(({ job }) => job.trainingTrials)).size;
    const open = openJobs(planned.jobs, stored?.predictions ?? new Map());
    return {
      asked: planned.jobs.length,
      open: open.length,
      goesOn: this.#shown === null || this.#shown.given || this.#shown === stored,
      growth: numbersOfTrials >= NUMBERS_OF_TRIALS,
      cost: costOf(open, planned, this.#width),
    };
  }

  /** Why Compare cannot be pressed now; empty when it can. */
  get whyNot(): string {
    const obstacle = this.#obstacle();
    if (obstacle !== "") return obstacle;
    if (this.#planned?.planned.jobs.length === 0) return compareWords().whyNot.twoParts;
    return this.#planProblem;
  }

  /** What is missing for a plan. */
  #obstacle(): string {
    const { state } = this.engine;
    const clips = this.clips;
    const { whyNot } = compareWords();
    if (state === "loading") return whyNot.gettingReady;
    if (state === "failed") return whyNot.cannotRun;
    if (!clips.samplesLoaded) return lab().learn.training.whyNot.samples;
    const { models, heldOut } = this.settings.values;
    const ticked = clips.ticked.length;
    if (ticked < 2) return whyNot.twoClips;
    if (clips.clash) return clips.clash;
    if (heldOut !== "each" && heldOut >= ticked) return whyNot.noTrial(heldOut + 1, ticked);
    return models.length === 0 ? whyNot.oneModel : "";
  }

  /** Updates the plan with settings and clips, until the returned function is called. */
  follow(): () => void {
    const stops = [this.engine, this.settings, this.clips].map((store) => store.on(() => this.#ask()));
    this.#ask();
    return () => {
      for (const stop of stops) stop();
    };
  }

  lookAt(change: Partial<Look>): void {
    this.#look = { ...this.#look, ...change };
    this.changed();
  }

  /** Does the unfinished jobs that the settings ask for. Finished jobs on the same trials are kept. */
  async begin(): Promise<void> {
    const asked = this.#request();
    if (this.busy || this.whyNot !== "" || !asked) return;
    this.#isPlanning = true;
    const signal = this.startJob();
    try {
      const { pool, desk } = this.whole;
      this.#width = pool.width;
      const planned = await desk.run((worker) => plan(worker, asked), signal);
      signal.throwIfAborted();
      if (!(await mayLose(...this.#lostTo(asked, planned).map(workOf)))) return this.#rest("");
      const entry = this.#takeUp(asked, planned);
      const jobs = openJobs(planned.jobs, entry.predictions).map(waiting);
      entry.jobs = jobs;
      this.#isPlanning = false;
      this.changed();
      await Promise.all(jobs.map((progress) => this.#carryOut(entry, asked.request, progress, signal)));
      this.#rest(summary(jobs));
    } catch (problem) {
      if (signal.aborted) this.#rest(compareWords().notBegun);
      else this.#rest(messageOf(problem), true);
    }
  }

  #rest(words: string, failed = false): void {
    this.#isPlanning = false;
    this.endJob(words, failed);
    this.#askAnew();
  }

  /** The machine is online again: drops the failure of loading the program. */
  reconnected(): void {
    if (this.busy) return;
    if (this.ending.failed) this.setEnding("");
    if (!this.#planned) this.#askAnew();
  }

  /** All results of this visit that are on no disk. */
  get unsaved(): readonly ReadonlyEntry[] {
    const entries = new Set(this.#entries.values());
    if (this.#shown) entries.add(this.#shown);
    return [...entries].filter((entry) => workOf(entry) !== null);
  }

  /** Saves the results that are shown to the visitor's disk. */
  save(): void {
    if (this.#shown) saveResults(this.#shown);
    this.changed();
  }

  /**
   * Shows the results of a file, from this page or from the terminal program. Returns false when the visitor
   * keeps the shown results instead. `onDisk`: the file is on the visitor's disk.
   */
  async open(text: string, onDisk = true): Promise<boolean> {
    this.#refuseWhileBusy();
    const results = await this.whole.desk.run((worker) => worker.openResults(text));
    if (!(await mayLose(workOf(this.#shown)))) return false;
    this.#refuseWhileBusy();
    this.#shown = newEntry(null, results, onDisk ? results.text : "");
    this.setEnding(compareWords().opened(results.finished.length));
    this.#askAnew();
    return true;
  }

  /** Shows the results that come with the page, if there are no others yet. */
  async showGiven(
    text: () => Promise<string>,
    motions: () => Promise<FirstMotion | null> = async () => null,
  ): Promise<void> {
    const isFree = () => this.#shown === null && !this.busy;
    if (!isFree()) return;
    const [given, moving] = await Promise.all([text(), motions()]);
    const results = await this.whole.desk.run((worker) => worker.openResults(given));
    if (!isFree()) return;
    this.#shown = givenEntry(results, moving);
    this.#askAnew();
  }

  #refuseWhileBusy(): void {
    if (this.busy) throw new Error(compareWords().running);
  }

  /** The request of the settings and the ticked clips. */
  #request(): Asked | null {
    const request = comparisonRequest(this.clips, this.settings.values);
    if (!request) return null;
    const opened = this.#shown?.request === null ? this.#shown : null;
    const stored = this.#entries.get(request.key) ?? opened;
    return { request, stored, text: stored?.results.text ?? null };
  }

  #ask(): void {
    const asked = this.#obstacle() === "" ? this.#request() : null;
    if (!asked) {
      this.#planning.drop();
      this.#asked = null;
      this.#answered(null, "");
      return;
    }
    if (this.#asked && isSame(this.#asked, asked)) return;
    this.#asked = asked;
    this.#planning.request(asked);
  }

  /** The results have changed, so that the plan is out of date. */
  #askAnew(): void {
    [this.#planned, this.#asked] = [null, null];
    this.#ask();
    this.changed();
  }

  #answered(planned: { asked: Asked; planned: PlannedComparison } | null, problem: string): void {
    this.#planned = planned;
    this.#planProblem = problem;
    this.changed();
  }

  /** The comparisons that would be neither shown nor stored any more. */
  #lostTo({ request, stored }: Asked, { goesOn }: PlannedComparison): ComparisonEntry[] {
    const others = [...this.#entries.values()].filter((entry) => entry.request?.key !== request.key);
    const oldest = others.slice(0, Math.max(0, others.length + 1 - MOST_ENTRIES));
    const shown = this.#shown;
    return shown?.request === null && !(goesOn && stored === shown) ? [...oldest, shown] : oldest;
  }

  /** Shows the requested comparison: the stored one, one with the results of an opened file, or a new one. */
  #takeUp({ request, stored }: Asked, { results, goesOn }: PlannedComparison): ComparisonEntry {
    const own = goesOn && stored?.request?.key === request.key ? stored : null;
    const entry = own ?? newEntry(request, results, (goesOn && stored?.onDisk) || "");
    entry.results = results;
    this.#shown = entry;
    this.#entries.delete(request.key);
    this.#entries.set(request.key, entry);
    for (const oldest of this.#entries.keys()) {
      if (this.#entries.size <= MOST_ENTRIES) break;
      this.#entries.delete(oldest);
    }
    return entry;
  }

  async #carryOut(
    entry: ComparisonEntry,
    request: ComparisonRequest,
    progress: JobProgress,
    signal: AbortSignal,
  ): Promise<void> {
    const { id, job } = progress;
    const end = (state: JobProgress["state"], why = "") => {
      [progress.state, progress.why] = [state, why];
      this.changedSoon();
    };
    let evaluated: Evaluated | null;
    try {
      evaluated = await this.#evaluate(request, progress, signal);
    } catch (problem) {
      // A stopped or failed training is no result, so that it can be asked for again.
      return end(signal.aborted ? "cancelled" : "failed", messageOf(problem));
    }
    if (!evaluated) return end("cancelled");
    try {
      await this.#add(entry, progress, evaluated);
      keepMotions(entry, id, job, evaluated);
      end("done");
    } catch (problem) {
      end("failed", messageOf(problem));
    }
  }

  async #evaluate(
    { clips, settings }: ComparisonRequest,
    progress: JobProgress,
    signal: AbortSignal,
  ): Promise<Evaluated | null> {
    return this.whole.pool.run((worker) => {
      progress.state = "running";
      const start = performance.now();
      const report = (fraction: number) => {
        progress.fraction = fraction;
        progress.elapsed = (performance.now() - start) / 1000;
        this.changedSoon();
      };
      return worker.evaluate({ clips, settings, ...progress.job }, report, signal);
    }, signal);
  }

  #add(entry: ComparisonEntry, { id, job }: JobProgress, { outcome }: Evaluated): Promise<void> {
    const added = this.#adding.then(async () => {
      const { results } = entry;
      if (results.finished.some((finished) => finished.id === id && finished.outcome)) return;
      const add = (from: number | string) =>
        this.whole.desk.run((worker) => worker.addOutcome(from, job, outcome));
      // The worker may have died; a new one needs the whole file.
      const held = await add(this.#states.get(results) ?? results.text).catch(() => null);
      const result = held ?? (await add(results.text));
      if (!result) return;
      entry.results = withResult(results, result);
      this.#states.set(entry.results, result.state);
    });
    this.#adding = added.catch(() => {});
    return added;
  }
}

function plan(worker: WholeCalls, { request, text }: Asked): Promise<PlannedComparison> {
  return worker.planComparison(request.clips, request.settings, request.plan, text);
}

function isSame(a: Asked, b: Asked): boolean {
  const words = ({ request: { key, plan } }: Asked) => JSON.stringify([key, plan]);
  return a.stored === b.stored && a.text === b.text && words(a) === words(b);
}

/** Whether the library itself refuses, and not the worker or the network. */
function isRefusal(problem: unknown): boolean {
  return problem instanceof Error && problem.name === "VcgpdmError";
}
