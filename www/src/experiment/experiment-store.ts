// The synthetic experiment: draw one, train on it, cancel.
import type { App } from "../app/app";
import { comparing } from "../engine/whole-engine";
import { messageOf } from "../ui/format";
import { Latest } from "../engine/latest";
import { isSame, newTry, type Try } from "./experiments";
import type { ExperimentJob, SyntheticTruth } from "../engine/whole-protocol";

/** The experiments of this visit, and how they are going. */
export class Lesson {
  tries: Try[] = [];
  status: "idle" | "running" | "cancelling" = "idle";
  /** Why the experiment could not be drawn; empty when it could. */
  problem = "";
  /** What the last press of a button asked for. */
  asked: Try[] = [];
  private drawn: { job: ExperimentJob; truth: SyntheticTruth } | null = null;
  private wanted: ExperimentJob | null = null;
  private stop = new AbortController();
  private workers = 1;
  private readonly drawing: Latest<ExperimentJob, SyntheticTruth>;

  constructor(private readonly app: App) {
    this.drawing = new Latest(
      async (job) => (await comparing()).desk.run((worker) => worker.draw(job)),
      (truth, job) => this.drew(job, truth, ""),
      (problem) => this.drew(null, null, messageOf(problem)),
    );
  }

  get busy(): boolean {
    return this.status !== "idle";
  }

  /** How many trainings run at once. */
  get width(): number {
    return this.workers;
  }

  /** The experiment that the settings name. */
  get job(): ExperimentJob {
    const { drawn: seed, driving } = this.app.settings;
    return { seed, driving };
  }

  /** What was tried of it. */
  get shown(): Try | null {
    return this.find(this.job) ?? null;
  }

  /** Its data, and the truth about them; null until they are there. */
  get truth(): SyntheticTruth | null {
    return this.drawn && isSame(this.drawn.job, this.job) ? this.drawn.truth : null;
  }

  private find(job: ExperimentJob): Try | undefined {
    return this.tries.find((one) => isSame(one, job));
  }

  /** Draws the experiment that the settings name, if it is another one than before. Loads the program at the first time. */
  draw(): void {
    if (this.wanted && isSame(this.wanted, this.job)) return;
    this.wanted = this.job;
    this.problem = "";
    this.drawing.request(this.job);
  }

  drawAgain(): void {
    this.wanted = null;
    this.draw();
    this.app.tell("lesson");
  }

  private drew(job: ExperimentJob | null, truth: SyntheticTruth | null, problem: string): void {
    if (job && truth) this.drawn = { job, truth };
    this.problem = problem;
    this.app.tell("lesson");
  }

  /** Those of these experiments that were not trained to the end. */
  open(jobs: readonly ExperimentJob[]): ExperimentJob[] {
    return jobs.filter((job) => this.find(job)?.state !== "done");
  }

  /** Trains those of these experiments that were not trained to the end: it would find the same again. */
  async train(jobs: readonly ExperimentJob[]): Promise<void> {
    if (this.busy) return;
    const fresh = this.open(jobs).map(newTry);
    if (fresh.length === 0) return;
    this.tries = [...this.tries.filter((one) => !fresh.some((other) => isSame(one, other))), ...fresh];
    this.asked = fresh;
    this.stop = new AbortController();
    this.status = "running";
    this.app.tell("lesson");
    await Promise.all(fresh.map((one) => this.carryOut(one)));
    this.status = "idle";
    this.app.tell("lesson");
  }

  /** Carries one training out. Its failure is its own. */
  private async carryOut(one: Try): Promise<void> {
    const { signal } = this.stop;
    try {
      const { pool } = await comparing();
      this.workers = pool.width;
      const { cancelled, reason } = await pool.run((worker) => {
        one.state = "running";
        return worker.experiment(
          { seed: one.seed, driving: one.driving },
          ({ progress, elapsed, findings }) => {
            Object.assign(one, { iteration: progress.iteration, fraction: progress.fraction, elapsed, findings });
            this.app.tellSoon("lesson");
          },
          signal,
        );
      }, signal);
      one.state = cancelled ? "cancelled" : "done";
      one.ending = reason;
    } catch (problem) {
      // What was cancelled before it began was not tried.
      if (problem === signal.reason) this.tries = this.tries.filter((other) => other !== one);
      else [one.state, one.ending] = ["failed", messageOf(problem)];
    }
    this.app.tellSoon("lesson");
  }

  /** Stops; what is under way keeps its best so far. */
  cancel(): void {
    if (this.status !== "running") return;
    this.status = "cancelling";
    this.stop.abort();
    this.app.tell("lesson");
  }
}

const all = new WeakMap<App, Lesson>();

/** The synthetic lesson of this page's visit. */
export function lessonOf(app: App): Lesson {
  let one = all.get(app);
  if (!one) all.set(app, (one = new Lesson(app)));
  return one;
}
