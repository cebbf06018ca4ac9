// The trainings of this visit: start, follow, cancel; and which of them is on the stage.
import type { ClipsStore } from "../clips/clips-store";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { TrainedModel, TrainingOutcome, Report, TrainingSettings } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import { messageOf, sentence } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { Cost, type CostWords, costWords } from "./cost";
import { Kept, type Send } from "./kept";
import { bestBound, bestRun, isOver, type Run, seedsFrom } from "./runs";
import { Staging } from "./staging";
import { endingOfRuns, endingWords, LEFT, STOPPED } from "./words";

/** The runs from a press of Train until all are over. */
interface Session {
  runs: Run[];
  /** Stops the runs; each keeps its best so far. */
  stop: AbortController;
  /** Kept when each of the runs is over. */
  work: Promise<void>[];
  /** The visitor has chosen a run to look at since it began. */
  picked: boolean;
  /** A model of it has been on the stage. */
  staged: boolean;
}

const newSession = (): Session => ({
  runs: [],
  stop: new AbortController(),
  work: [],
  picked: false,
  staged: false,
});

/** So many seeds are trained from where nobody asks for a number, and there are as many cores. */
const MOST_UNASKED = 4;

/** So many inducing points are tried next where a model does not keep moving. */
const POINTS = [20, 30, 40] as const;

/** Whether a training can go on. */
const isOpen = ({ cancelled, reason }: TrainingOutcome) => cancelled || reason === "iterations";

export class TrainingStore extends Store {
  readonly #engine: EngineStore;
  readonly #settings: SettingsStore;
  readonly #clips: ClipsStore;
  readonly #notices: NoticesStore;
  readonly #staging: Staging;
  readonly #kept: Kept;
  readonly #cost: Cost;
  /** Whether models of trainings may take the place of the one on the stage. */
  readonly #mayTakeStage: () => Promise<boolean>;
  #status: "idle" | "running" | "cancelling" = "idle";
  #session = newSession();
  #ending = { words: "", failed: false };
  #runs: readonly Run[] = [];
  #chosen: Run | null = null;
  #lastId = 0;

  constructor(
    engine: EngineStore,
    settings: SettingsStore,
    clips: ClipsStore,
    model: ModelStore,
    notices: NoticesStore,
    mayTakeStage: () => Promise<boolean> = async () => true,
  ) {
    super();
    this.#mayTakeStage = mayTakeStage;
    this.#engine = engine;
    this.#settings = settings;
    this.#clips = clips;
    this.#notices = notices;
    this.#staging = new Staging(model, notices);
    this.#kept = new Kept(engine);
    this.#cost = new Cost(engine, settings, clips, () => this.changed());
  }

  get status(): "idle" | "running" | "cancelling" {
    return this.#status;
  }

  get busy(): boolean {
    return this.#status !== "idle";
  }

  /** All runs of this visit, until they are cleared. */
  get runs(): readonly Run[] {
    return this.#runs;
  }

  /** The runs that the last press of Train asked for, and what was added to them. */
  get asked(): readonly Run[] {
    return this.#session.runs;
  }

  /** How the last runs ended, or why they failed. */
  get ending(): { words: string; failed: boolean } {
    return this.#ending;
  }

  /** The run whose model is on the stage, or will be; null: a model from elsewhere. */
  get chosen(): Run | null {
    return this.#chosen;
  }

  /** The run that the charts draw. */
  get charted(): Run | null {
    return this.#chosen ?? this.#runs.at(-1) ?? null;
  }

  /** The run whose model on the stage is still learning; null: it is over, or from elsewhere. */
  get learning(): Run | null {
    return this.busy && this.#chosen && !isOver(this.#chosen) ? this.#chosen : null;
  }

  /** How many runs are done at once. */
  get workers(): number {
    return this.#engine.pool?.width ?? 1;
  }

  /** How many trainings a press of Train begins. */
  get count(): number {
    return this.#settings.values.trainings || Math.min(MOST_UNASKED, this.workers);
  }

  /** What a press of Train would cost, where that is worth a word. */
  get cost(): CostWords {
    return costWords(this.#cost.now, this.count, this.workers);
  }

  /** Why Train cannot be pressed now; empty when it can. */
  whyNot(): string {
    if (this.#engine.state === "loading") return "Getting ready";
    if (!this.#engine.engine) return "The model cannot run in this browser";
    // Ticked clips come one by one: pressed at once, it would train on fewer than the page is about to show.
    if (!this.#clips.samplesLoaded) return "Getting the sample clips ready";
    if (this.#clips.ticked.length === 0) return "Tick at least one clip to train on";
    return this.#clips.clash ? "The ticked clips do not go together; Clips says why" : "";
  }

  /**
   * Trains from as many seeds as the settings ask for, and takes the best up. While others train, these are
   * added to them. The promise is kept when all are over, for whoever began.
   */
  async start(): Promise<void> {
    if (!(await this.#mayTakeStage()) || this.#status === "cancelling" || this.whyNot()) return;
    const runs = this.#newRuns();
    const begins = !this.busy;
    if (begins) {
      this.#kept.letGoAll();
      this.#begin(runs);
    }
    this.#runs = [...this.#runs, ...runs];
    const session = this.#session;
    session.runs.push(...runs);
    this.changed();
    session.work.push(
      ...runs.map((run) => this.#carryOut(run, session.stop.signal, (send) => this.#train(run, send))),
    );
    if (begins) await this.#finish(session);
  }

  /** Whether the run stopped before its bound had settled. */
  canContinue(run: Run): boolean {
    return !this.busy && run.open && this.#runs.includes(run);
  }

  /**
   * How many more iterations a run is allowed when it goes on: none where it was cancelled before it had used
   * its own.
   */
  moreIterations({ state, portion }: Run): number {
    return state === "cancelled" ? 0 : portion;
  }

  /**
   * Goes on with a run where it stopped: in the worker that holds it; otherwise it is trained anew up to
   * there, which gives the same bits. Both end as a training that was never stopped.
   */
  async continue(run: Run): Promise<void> {
    if (!(await this.#mayTakeStage()) || !this.canContinue(run)) return;
    const more = this.moreIterations(run);
    const held = this.#kept.has(run);
    this.#begin([run]);
    const session = this.#session;
    session.runs.push(run);
    run.state = "waiting";
    run.catchingUp = !held;
    run.settings = { ...run.settings, maxIterations: run.settings.maxIterations + more };
    this.changed();
    const work = (send: Send) => (held ? this.#kept.goOn(run, more, send) : this.#train(run, send));
    session.work.push(this.#carryOut(run, session.stop.signal, work));
    await this.#finish(session);
  }

  /** The next larger number of inducing points to try; null where the run has the most. */
  morePoints(run: Run): number | null {
    const { dynamicsIps, poseIps } = run.settings;
    return POINTS.find((points) => points > Math.max(dynamicsIps, poseIps)) ?? null;
  }

  /** Trains anew with more inducing points than the run has. */
  async trainWithMorePoints(run: Run): Promise<void> {
    const points = this.morePoints(run);
    if (points === null || this.busy) return;
    this.#settings.change({ dynamicsIps: points, poseIps: points });
    await this.start();
  }

  /** Trains anew from the seeds after those of the last press of Train. */
  async trainOtherSeeds(): Promise<void> {
    if (this.busy) return;
    const last = this.#session.runs.at(-1)?.settings.seed ?? this.#settings.values.seed;
    const [, next = 0] = seedsFrom(last, 2);
    this.#settings.change({ seed: next });
    await this.start();
  }

  /** Stops all runs. Each that has begun keeps its best so far. */
  cancel(): void {
    if (this.#status !== "running") return;
    this.#status = "cancelling";
    this.#session.stop.abort();
    this.changed();
  }

  /** The visitor wants to see this run, whatever the others do. */
  async choose(run: Run): Promise<void> {
    if (run.model && !(await this.#mayTakeStage())) return;
    this.#session.picked = this.busy;
    if (run.model) void this.#stage(run, false);
    else this.#look(run);
  }

  /** A model from elsewhere is on the stage. */
  unchoose(): void {
    this.#look(null);
  }

  /**
   * Whether nothing needs the run any more: the best is chosen among all runs that were asked for together.
   */
  canRemove(run: Run): boolean {
    return isOver(run) && !(this.busy && this.#session.runs.includes(run));
  }

  remove(run: Run): void {
    if (!this.canRemove(run)) return;
    this.#kept.letGo(run);
    this.#runs = this.#runs.filter((other) => other !== run);
    if (this.#chosen === run) {
      this.#staging.letGo(run);
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
   * Takes runs of an earlier visit up, before those of this one. Those that were not over then are like
   * cancelled ones: they can go on. `chosen`: the place of the one whose model is on the stage; none: -1.
   */
  async takeUp(runs: readonly Run[], chosen: number): Promise<void> {
    const known = runs.map((run): Run => {
      this.#lastId += 1;
      const over = isOver(run)
        ? run
        : { ...run, state: "cancelled" as const, ending: LEFT, open: run.steps.length > 0 };
      return { ...over, id: this.#lastId, catchingUp: false };
    });
    this.#runs = [...known, ...this.#runs];
    this.changed();
    const run = known[chosen];
    if (run?.model && !this.busy) await this.#staging.stage(run, { couplings: "visitor", clip: true });
    if (run && !this.busy) this.#look(run);
  }

  async newSeed(): Promise<void> {
    const seed = await this.#engine.engine?.freshSeed();
    if (seed !== undefined) this.#settings.change({ seed });
  }

  #newRuns(): Run[] {
    const { latent, dynamicsIps, poseIps, order, framesPerSecond, maxIterations, seed } =
      this.#settings.values;
    const { parts, toTrainOn: clips } = this.#clips;
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
    this.#status = "running";
    this.#session = newSession();
    this.#ending = { words: "", failed: false };
    this.#chosen = runs[0] ?? null;
    this.#clips.lock(true);
  }

  /** Trains on a worker of the pool that is free. */
  #train(run: Run, { report, signal, begun }: Send): Promise<TrainingOutcome> {
    const { pool } = this.#engine;
    if (!pool) throw new Error("The model cannot run in this browser.");
    const { frames } = this.#settings.values;
    return pool.run(async (worker) => {
      begun();
      const outcome = await worker.train(
        { clips: run.clips, settings: run.settings, frames },
        report,
        signal,
      );
      if (isOpen(outcome)) this.#kept.keep(run, worker, bestBound(run));
      return outcome;
    }, signal);
  }

  /** Carries one run out, from its beginning or from where it stopped. Its failure is its own. */
  async #carryOut(
    run: Run,
    signal: AbortSignal,
    work: (send: Send) => Promise<TrainingOutcome>,
  ): Promise<void> {
    const before = run.elapsed;
    const anew = run.catchingUp;
    const known = run.steps.at(-1)?.iteration ?? 0;
    const report: Report<TrainedModel> = ({ steps, elapsed, found, notices = [] }) => {
      if (run.state !== "running") return false;
      for (const notice of notices) this.#warn(notice);
      // What is known of an earlier course comes out the same again.
      run.steps.push(...steps.filter(({ iteration }) => iteration > known));
      run.catchingUp &&= (steps.at(-1)?.iteration ?? 0) < known;
      run.elapsed = anew ? Math.max(before, elapsed) : before + elapsed;
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
      // One that goes on had begun before; another that has come to a model can be trained anew up to there.
      run.open = run.model !== null;
      run.ending = stopped ? (run.open ? STOPPED : "You cancelled before it began.") : messageOf(problem);
    }
    run.catchingUp = false;
    this.changed();
  }

  /** Says once, for all seeds, what no clip in the list says. */
  #warn(warning: string): void {
    const infos = this.#clips.all.map(({ loaded }) => loaded.info);
    const shown = infos.flatMap(({ name, warnings }) => warnings.map((text) => `${name}: ${text}`));
    const text = sentence(warning);
    if (shown.includes(warning) || this.#notices.all.some((notice) => notice.text === text)) return;
    this.#notices.addError("About this training", text);
  }

  /** When all runs are over, those that were added meanwhile too: the best is on the stage. */
  async #finish(session: Session): Promise<void> {
    for (let awaited = 0; awaited < session.work.length; ) {
      awaited = session.work.length;
      await Promise.all(session.work);
    }
    const kept = session.runs.filter(({ model }) => model !== null);
    const best = (await this.#bestToShow(kept.filter(({ state }) => state !== "failed"))) ?? bestRun(kept);
    const { picked } = session;
    if (best && !picked) await this.#stage(best, session.staged);
    this.#status = "idle";
    this.#ending = endingOfRuns(session.runs, picked ? null : best);
    this.#clips.lock(false);
    this.changed();
  }

  /**
   * Which of these runs is to be shown: the library chooses by how their rollouts end, and by their bounds.
   */
  async #bestToShow(runs: readonly Run[]): Promise<Run | null> {
    const ranks = runs.map(({ model }) => model?.health?.rank ?? 0);
    const place = await this.#engine.engine?.bestToShow(ranks, runs.map(bestBound));
    return runs[place ?? -1] ?? null;
  }

  /**
   * Keeps the best run under way on the stage, or the one that the visitor chose, with a new model about once
   * a second. Answers whether this run is to send a newer model.
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
   * After the first model of a training, a clip that is looked at may keep the stage, and the visitor's
   * couplings hold.
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
