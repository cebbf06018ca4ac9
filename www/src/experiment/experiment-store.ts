// The synthetic experiments of this visit: the data of the one that is looked at, and the trainings on them.
import { Latest } from "../engine/latest";
import type { WholeWorkers } from "../engine/whole-workers";
import type { Experiment, SyntheticTruth } from "../engine/whole-protocol";
import type { SettingsStore } from "../settings/settings-store";
import { endingWords } from "../training/words";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { type ExperimentRun, isSame, newRun } from "./experiments";

export class ExperimentStore extends Store {
  readonly #settings: Pick<SettingsStore, "values" | "on">;
  readonly #whole: WholeWorkers;
  readonly #drawing: Latest<Experiment, SyntheticTruth>;
  #runs: readonly ExperimentRun[] = [];
  #asked: readonly ExperimentRun[] = [];
  #status: "idle" | "running" | "cancelling" = "idle";
  #problem = "";
  /** The experiment whose data were asked for last, and the one whose data are there. */
  #wanted: Experiment | null = null;
  #drawn: { experiment: Experiment; truth: SyntheticTruth } | null = null;
  #stop = new AbortController();
  #width = 1;

  constructor(settings: Pick<SettingsStore, "values" | "on">, whole: WholeWorkers) {
    super();
    this.#settings = settings;
    this.#whole = whole;
    this.#drawing = new Latest(
      (experiment) => whole.desk.run((worker) => worker.drawExperiment(experiment)),
      (truth, experiment) => {
        this.#drawn = { experiment, truth };
        this.#problem = "";
        this.changed();
      },
      (problem) => {
        this.#problem = messageOf(problem);
        this.changed();
      },
    );
  }

  /** All trainings of this visit. */
  get runs(): readonly ExperimentRun[] {
    return this.#runs;
  }

  /** The trainings that the last press of a button asked for. */
  get asked(): readonly ExperimentRun[] {
    return this.#asked;
  }

  get status(): "idle" | "running" | "cancelling" {
    return this.#status;
  }

  get busy(): boolean {
    return this.#status !== "idle";
  }

  /** Why the data could not be drawn; empty when they could. */
  get problem(): string {
    return this.#problem;
  }

  /** How many trainings run at once. */
  get width(): number {
    return this.#width;
  }

  /** The experiment that the settings name. */
  get experiment(): Experiment {
    const { drawn: seed, driving } = this.#settings.values;
    return { seed, driving };
  }

  /** The training on it; null when there is none. */
  get shown(): ExperimentRun | null {
    return this.#find(this.experiment) ?? null;
  }

  /** Its data, and the truth about them; null until they are there. */
  get truth(): SyntheticTruth | null {
    return this.#drawn && isSame(this.#drawn.experiment, this.experiment) ? this.#drawn.truth : null;
  }

  /** Those of these experiments that were not trained to the end. */
  open(experiments: readonly Experiment[]): Experiment[] {
    return experiments.filter((experiment) => this.#find(experiment)?.state !== "done");
  }

  /**
   * Draws the experiment that the settings name, whenever it is another one, until the answer is called.
   * Loads the program.
   */
  follow(): () => void {
    const draw = () => {
      if (!this.#wanted || !isSame(this.#wanted, this.experiment)) this.draw();
    };
    draw();
    return this.#settings.on(draw);
  }

  draw(): void {
    this.#wanted = this.experiment;
    this.#problem = "";
    this.#drawing.request(this.#wanted);
    this.changed();
  }

  /**
   * Trains those of these experiments that were not trained to the end: a training would find the same again.
   */
  async train(experiments: readonly Experiment[]): Promise<void> {
    const runs = this.open(experiments).map(newRun);
    if (this.busy || runs.length === 0) return;
    this.#runs = [...this.#runs.filter((before) => !runs.some((run) => isSame(run, before))), ...runs];
    this.#asked = runs;
    this.#stop = new AbortController();
    this.#status = "running";
    this.changed();
    await Promise.all(runs.map((run) => this.#carryOut(run, this.#stop.signal)));
    this.#status = "idle";
    this.changed();
  }

  /** Stops; what is under way keeps its best so far. */
  cancel(): void {
    if (this.#status !== "running") return;
    this.#status = "cancelling";
    this.#stop.abort();
    this.changed();
  }

  #find(experiment: Experiment): ExperimentRun | undefined {
    return this.#runs.find((run) => isSame(run, experiment));
  }

  /** Carries one training out. Its failure is its own. */
  async #carryOut(run: ExperimentRun, signal: AbortSignal): Promise<void> {
    const { seed, driving } = run;
    try {
      const { pool } = this.#whole;
      this.#width = pool.width;
      const outcome = await pool.run((worker) => {
        run.state = "running";
        return worker.trainExperiment(
          { seed, driving },
          ({ progress: { iteration, fraction }, elapsed, found }) => {
            Object.assign(run, { iteration, fraction, elapsed });
            if (found) run.findings = found;
            this.changedSoon();
            return true;
          },
          signal,
        );
      }, signal);
      run.state = outcome.cancelled ? "cancelled" : "done";
      run.ending = endingWords(outcome);
    } catch (problem) {
      // What was cancelled before it began is as if it had not been asked for.
      if (problem === signal.reason) this.#runs = this.#runs.filter((other) => other !== run);
      else [run.state, run.ending] = ["failed", messageOf(problem)];
    }
    this.changedSoon();
  }
}
