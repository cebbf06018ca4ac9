// The trainings of this visit: starts, reports and cancels them, and puts one on the stage.
import type { ClipsStore } from "../clips/clips-store";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { TrainedModel, TrainingOutcome, Report, TrainingSettings } from "../engine/protocol";
import { pointsOf, type Settings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { messageOf, sentence } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Job } from "../ui/job";
import { Cost, type CostWords, costWords } from "./cost";
import { PausedRuns, type Send } from "./paused-runs";
import { bestBound, bestRun, isOver, type Run, seedsFrom } from "./runs";
import { Staging } from "./staging";
import { endingOfRuns, endingWords } from "./words";
import { lab } from "../words/lab";

/** The runs from a press of Train until all are over. */
interface Session {
  runs: Run[];
  /** Stops the runs; each keeps its best model. */
  signal: AbortSignal;
  /** A promise for each run, which ends with the run. */
  work: Promise<void>[];
  /** Whether the visitor has chosen a run since the session began. */
  picked: boolean;
  /** Whether a model of the session has been on the stage. */
  staged: boolean;
}

const newSession = (signal: AbortSignal): Session => ({
  runs: [],
  signal,
  work: [],
  picked: false,
  staged: false,
});

/** The most seeds that are trained by default, on a machine with as many cores. */
const MOST_UNASKED = 4;

/** The numbers of inducing points to try when a model does not keep moving. */
const POINTS = [20, 30, 40] as const;

/** Whether a training can continue. */
const isOpen = ({ cancelled, reason }: TrainingOutcome) => cancelled || reason === "iterations";

export class TrainingStore extends Job {
  readonly #staging: Staging;
  readonly #paused: PausedRuns;
  readonly #cost: Cost;
  #session = newSession(new AbortController().signal);
  #runs: readonly Run[] = [];
  #chosen: Run | null = null;
  #lastId = 0;

  constructor(
    private readonly engine: EngineStore,
    private readonly settings: SettingsStore,
    private readonly clips: ClipsStore,
    model: ModelStore,
    private readonly notices: NoticesStore,
    /** Whether models of trainings may replace the model on the stage. */
    private readonly mayTakeStage: () => Promise<boolean> = async () => true,
  ) {
    super();
    this.#staging = new Staging(model, notices);
    this.#paused = new PausedRuns(engine);
    this.#cost = new Cost(engine, settings, clips, () => this.changed());
  }

  /** All runs of this visit, until they are cleared. */
  get runs(): readonly Run[] {
    return this.#runs;
  }

  /** The runs of the last press of Train, and the runs that were added while they ran. */
  get asked(): readonly Run[] {
    return this.#session.runs;
  }

  /** The run whose model is on the stage, or will be; null: the model on the stage has no run. */
  get chosen(): Run | null {
    return this.#chosen;
  }

  /** The run that the charts draw. */
  get charted(): Run | null {
    return this.#chosen ?? this.#runs.at(-1) ?? null;
  }

  /** The run on the stage while it trains; null: it is over, or the model has no run. */
  get learning(): Run | null {
    return this.busy && this.#chosen && !isOver(this.#chosen) ? this.#chosen : null;
  }

  /** The number of runs that train at the same time. */
  get workers(): number {
    return this.engine.pool?.width ?? 1;
  }

  /** The number of trainings that a press of Train begins. */
  get count(): number {
    return this.settings.values.trainings || Math.min(MOST_UNASKED, this.workers);
  }

  /** How poses count in the next training. */
  get poseWeight(): Settings["poseWeight"] {
    const { asInPapers, poseWeight } = this.settings.values;
    return asInPapers ? 1 : poseWeight;
  }

  /** The cost of a press of Train; empty for short trainings. */
  get cost(): CostWords {
    return costWords(this.#cost.now, this.count, this.workers);
  }

  /** The inducing points that the library gives the ticked clips, and the seconds of the longest; undefined before the answer. */
  get usual(): { dynamicsIps: number; poseIps: number; longest: number } | undefined {
    const { now } = this.#cost;
    return now ? { ...now.usual, longest: now.longest } : undefined;
  }

  /** Why Train cannot be pressed now; empty when it can. */
  whyNot(): string {
    const words = lab().learn.training.whyNot;
    if (this.engine.state === "loading") return words.gettingReady;
    if (!this.engine.engine) return words.cannotRun;
    // The sample clips arrive one by one: an early press would train on some of them only.
    if (!this.clips.samplesLoaded) return words.samples;
    if (this.clips.ticked.length === 0) return words.tick;
    return this.clips.clash ? words.clash : "";
  }

  /**
   * Trains from as many seeds as the settings say, and puts the best on the stage. During a session the new
   * runs join it. For the first caller the promise ends with the session.
   */
  async start(): Promise<void> {
    if (!(await this.mayTakeStage()) || this.status === "cancelling" || this.whyNot()) return;
    const runs = this.#newRuns();
    const begins = !this.busy;
    if (begins) {
      this.#paused.releaseAll();
      this.#begin(runs);
    }
    this.#runs = [...this.#runs, ...runs];
    const session = this.#session;
    session.runs.push(...runs);
    this.changed();
    session.work.push(
      ...runs.map((run) => this.#carryOut(run, session.signal, (send) => this.#train(run, send))),
    );
    if (begins) await this.#finish(session);
  }

  /** Whether the run stopped before its bound had settled. */
  canContinue(run: Run): boolean {
    return !this.busy && run.open && this.#runs.includes(run);
  }

  /** How many iterations a run gets on top of its own when it continues: none if it has not used them all. */
  moreIterations({ state, portion }: Run): number {
    return state === "done" ? portion : 0;
  }

  /**
   * Continues a run in the worker that holds it. Without that worker the run is first trained again up to
   * where it stopped, with the same bits. Both end like a training that was never stopped.
   */
  async continue(run: Run): Promise<void> {
    if (!(await this.mayTakeStage()) || !this.canContinue(run)) return;
    const more = this.moreIterations(run);
    const paused = this.#paused.has(run);
    this.#begin([run]);
    const session = this.#session;
    session.runs.push(run);
    run.state = "waiting";
    run.catchingUp = !paused;
    run.settings = { ...run.settings, maxIterations: run.settings.maxIterations + more };
    this.changed();
    const work = (send: Send) => (paused ? this.#paused.goOn(run, more, send) : this.#train(run, send));
    session.work.push(this.#carryOut(run, session.signal, work));
    await this.#finish(session);
  }

  /** The next larger number of inducing points to try; null: the run has the largest. */
  morePoints(run: Run): number | null {
    const { dynamicsIps, poseIps } = run.settings;
    return POINTS.find((points) => points > Math.max(dynamicsIps, poseIps)) ?? null;
  }

  /** Starts a training with more inducing points than the run has. */
  async trainWithMorePoints(run: Run): Promise<void> {
    const points = this.morePoints(run);
    if (points === null || this.busy) return;
    this.settings.change({ dynamicsIps: points, poseIps: points });
    await this.start();
  }

  /** Starts trainings from the seeds after those of the last press of Train. */
  async trainOtherSeeds(): Promise<void> {
    if (this.busy) return;
    const last = this.#session.runs.at(-1)?.settings.seed ?? this.settings.values.seed;
    const [, next = 0] = seedsFrom(last, 2);
    this.settings.change({ seed: next });
    await this.start();
  }

  /** The visitor wants to see this run, also when another becomes better. */
  async choose(run: Run): Promise<void> {
    if (run.model && !(await this.mayTakeStage())) return;
    this.#session.picked = this.busy;
    if (run.model) void this.#stage(run, false);
    else this.#look(run);
  }

  /** A model without a run is on the stage. */
  unchoose(): void {
    this.#look(null);
  }

  /** Whether the run is over and its session too: the session chooses the best among its runs. */
  canRemove(run: Run): boolean {
    return isOver(run) && !(this.busy && this.#session.runs.includes(run));
  }

  remove(run: Run): void {
    if (!this.canRemove(run)) return;
    this.#paused.release(run);
    this.#runs = this.#runs.filter((other) => other !== run);
    if (this.#chosen === run) {
      this.#staging.release(run);
      this.#chosen = null;
      this.#session.picked = false;
    }
    this.changed();
  }

  /** Removes all runs that can be removed. */
  clear(): void {
    for (const run of this.#runs) this.remove(run);
  }

  /**
   * Adds runs of an earlier visit before those of this one. Runs that were not over then are cancelled and
   * can continue. `chosen`: the place of the run whose model goes on the stage; -1: none.
   */
  async takeUp(runs: readonly Run[], chosen: number): Promise<void> {
    const added = runs.map((run): Run => {
      this.#lastId += 1;
      const over = isOver(run)
        ? run
        : {
            ...run,
            state: "cancelled" as const,
            ending: lab().learn.ending.left,
            open: run.steps.length > 0,
          };
      return { ...over, id: this.#lastId, catchingUp: false };
    });
    this.#runs = [...added, ...this.#runs];
    this.changed();
    const run = added[chosen];
    if (run?.model && !this.busy) await this.#staging.stage(run, { couplings: "visitor", clip: true });
    if (run && !this.busy) this.#look(run);
  }

  async newSeed(): Promise<void> {
    const seed = await this.engine.engine?.freshSeed();
    if (seed !== undefined) this.settings.change({ seed });
  }

  #newRuns(): Run[] {
    const { latent, order, framesPerSecond, maxIterations, seed, asInPapers } = this.settings.values;
    const { poseWeight } = this;
    const { dynamicsIps, poseIps } = pointsOf(this.settings.values, this.usual);
    const { parts, toTrainOn: clips } = this.clips;
    return seedsFrom(seed, this.count).map((seed): Run => {
      const settings: TrainingSettings = {
        parts,
        latent,
        dynamicsIps,
        poseIps,
        order,
        framesPerSecond,
        seed,
        maxIterations,
        poseWeight,
        ...(asInPapers ? { ownRollouts: false } : {}),
      };
      this.#lastId += 1;
      const course = {
        state: "waiting" as const,
        steps: [],
        elapsed: 0,
        ending: "",
        open: false,
        catchingUp: false,
      };
      return { id: this.#lastId, settings, clips, ...course, model: null, portion: maxIterations };
    });
  }

  #begin(runs: readonly Run[]): void {
    this.#chosen = runs[0] ?? null;
    this.#session = newSession(this.startJob());
    this.clips.lock(true);
  }

  /** Trains on a free worker of the pool. */
  #train(run: Run, { report, signal, begun }: Send): Promise<TrainingOutcome> {
    const { pool } = this.engine;
    if (!pool) throw new Error(lab().learn.training.whyNot.cannotRun);
    const { frames } = this.settings.values;
    return pool.run(async (worker) => {
      begun();
      const { clips, settings, portion } = run;
      // A training that was extended is another one than a training that was longer from the beginning.
      const more = settings.maxIterations - portion;
      const job = { clips, settings: { ...settings, maxIterations: portion }, more, frames };
      const outcome = await worker.train(job, report, signal);
      // A worker that is not yet where the run stopped cannot continue the run.
      if (isOpen(outcome) && !run.catchingUp) this.#paused.keep(run, worker, bestBound(run));
      return outcome;
    }, signal);
  }

  /**
   * Carries out one run, from its beginning or from where it stopped. A failure does not end the other runs.
   */
  async #carryOut(
    run: Run,
    signal: AbortSignal,
    work: (send: Send) => Promise<TrainingOutcome>,
  ): Promise<void> {
    const before = run.elapsed;
    const trainsAgain = run.catchingUp;
    const reached = run.steps.at(-1)?.iteration ?? 0;
    const report: Report<TrainedModel> = ({ steps, elapsed, found, notices = [] }) => {
      if (run.state !== "running") return false;
      for (const notice of notices) this.#warn(notice);
      // The iterations of the earlier course come out the same again.
      run.steps.push(...steps.filter(({ iteration }) => iteration > reached));
      run.catchingUp &&= (steps.at(-1)?.iteration ?? 0) < reached;
      run.elapsed = trainsAgain ? Math.max(before, elapsed) : before + elapsed;
      if (found && !run.catchingUp) run.model = found;
      this.changedSoon();
      return this.#follow(run);
    };
    const begun = () => {
      run.state = "running";
      this.changed();
    };
    try {
      const outcome = await work({ report, signal, begun });
      run.state = outcome.cancelled ? "cancelled" : "done";
      run.open = isOpen(outcome);
      // The notices are in the list of clips already.
      run.ending = endingWords({ ...outcome, notices: [] }, run.steps.at(-1));
    } catch (problem) {
      const stopped = problem === signal.reason;
      run.state = stopped ? "cancelled" : "failed";
      // A run that has a model can be trained again up to that model.
      run.open = run.model !== null;
      const { ending } = lab().learn;
      run.ending = stopped ? (run.open ? ending.stopped : ending.notBegun) : messageOf(problem);
    }
    run.catchingUp = false;
    this.changed();
  }

  /** Says once, for all seeds, what no clip in the list says. */
  #warn(warning: string): void {
    const infos = this.clips.all.map(({ loaded }) => loaded.info);
    const shown = infos.flatMap(({ name, warnings }) => warnings.map((text) => `${name}: ${text}`));
    const text = sentence(warning);
    if (shown.includes(warning) || this.notices.all.some((notice) => notice.text === text)) return;
    this.notices.addError(lab().learn.training.about, text);
  }

  /** Waits for all runs, also for those that join meanwhile, and puts the best on the stage. */
  async #finish(session: Session): Promise<void> {
    for (let awaited = 0; awaited < session.work.length; ) {
      awaited = session.work.length;
      await Promise.all(session.work);
    }
    const trained = session.runs.filter(({ model }) => model !== null);
    const best =
      (await this.#bestToShow(trained.filter(({ state }) => state !== "failed"))) ?? bestRun(trained);
    const { picked } = session;
    if (best && !picked) await this.#stage(best, session.staged);
    const { words, failed } = endingOfRuns(session.runs, picked ? null : best);
    this.endJob(words, failed);
    this.clips.lock(false);
  }

  /** The run to show: the library chooses by the ends of the rollouts and by their errors on the clips. */
  async #bestToShow(runs: readonly Run[]): Promise<Run | null> {
    const ranks = runs.map(({ model }) => model?.health?.rank ?? 0);
    const place = await this.engine.engine?.bestToShow(
      ranks,
      runs.map(({ model }) => model?.error ?? Infinity),
    );
    return runs[place ?? -1] ?? null;
  }

  /**
   * Keeps the best run, or the one that the visitor chose, on the stage, with a new model about once a
   * second. Returns whether this run is to send a newer model.
   */
  #follow(run: Run): boolean {
    const session = this.#session;
    if (!this.busy || !this.#staging.isDue) return false;
    const leader = session.picked ? this.#chosen : bestRun(session.runs);
    if (!leader || leader.model === null || leader.model === this.#staging.staged) return leader === run;
    void this.#stage(leader, session.staged);
    return false;
  }

  /**
   * The first model of a session takes the stage; later ones keep a clip there, and the visitor's couplings.
   */
  #stage(run: Run, keep: boolean): Promise<void> {
    this.#session.staged = true;
    this.#look(run);
    return this.#staging.stage(run, { couplings: keep ? "visitor" : "none", clip: keep });
  }

  #look(run: Run | null): void {
    this.#chosen = run;
    this.changed();
  }
}
