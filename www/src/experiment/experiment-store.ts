// The synthetic experiments of this visit: the data of the chosen one, and the trainings on them.
import { Latest } from "../engine/latest";
import type { WholeWorkers } from "../engine/whole-workers";
import type { Experiment, SyntheticTruth } from "../engine/whole-protocol";
import type { SettingsStore } from "../settings/settings-store";
import { messageOf } from "../ui/format";
import { Job } from "../ui/job";
import { type ExperimentRun, isSame, newRun } from "./experiments";

export class ExperimentStore extends Job {
  readonly #drawing: Latest<Experiment, SyntheticTruth>;
  #runs: readonly ExperimentRun[] = [];
  #asked: readonly ExperimentRun[] = [];
  #problem = "";
  /** The experiment whose data were requested last, and the one whose data have arrived. */
  #wanted: Experiment | null = null;
  #riddle: Experiment | null = null;
  #drawn: { experiment: Experiment; truth: SyntheticTruth } | null = null;
  #width = 1;

  constructor(
    private readonly settings: Pick<SettingsStore, "values" | "on">,
    private readonly whole: WholeWorkers,
  ) {
    super();
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

  /** The trainings of this visit with as many inducing points as the experiment on screen. */
  get runs(): readonly ExperimentRun[] {
    return this.#runs.filter(({ points }) => points === this.experiment.points);
  }

  /** The trainings of the last press of a button. */
  get asked(): readonly ExperimentRun[] {
    return this.#asked;
  }

  /** Why the data could not be drawn; empty when they could. */
  get problem(): string {
    return this.#problem;
  }

  /** The number of trainings that run at the same time. */
  get width(): number {
    return this.#width;
  }

  /** The experiment on screen: that of the riddle, else the one that the settings name. */
  get experiment(): Experiment {
    const { drawn: seed, driving, drawnPoints: points } = this.settings.values;
    return this.#riddle ?? { seed, driving, points };
  }

  /** Whether the experiment is behind a curtain, and in no address. */
  get isRiddle(): boolean {
    return this.#riddle !== null;
  }

  /** Shows an experiment without its name; null: the one that the settings name again. */
  setRiddle(experiment: Experiment | null): void {
    this.#riddle = experiment;
    this.draw();
  }

  /** The training on that experiment; null: there is none. */
  get shown(): ExperimentRun | null {
    return this.#find(this.experiment) ?? null;
  }

  /** The data of that experiment with the true couplings; null before they arrive. */
  get truth(): SyntheticTruth | null {
    return this.#drawn && isSame(this.#drawn.experiment, this.experiment) ? this.#drawn.truth : null;
  }

  /** The experiments that were not trained to the end. */
  open(experiments: readonly Experiment[]): Experiment[] {
    return experiments.filter((experiment) => this.#find(experiment)?.state !== "done");
  }

  /**
   * Draws the data of the experiment that the settings name, at each change, until the returned function is
   * called. Loads the program.
   */
  follow(): () => void {
    const draw = () => {
      if (!this.#wanted || !isSame(this.#wanted, this.experiment)) this.draw();
    };
    draw();
    return this.settings.on(draw);
  }

  draw(): void {
    this.#wanted = this.experiment;
    this.#problem = "";
    this.#drawing.request(this.#wanted);
    this.changed();
  }

  /** Trains the experiments that were not trained to the end; another training would find the same again. */
  async train(experiments: readonly Experiment[]): Promise<void> {
    const runs = this.open(experiments).map(newRun);
    if (this.busy || runs.length === 0) return;
    this.#runs = [...this.#runs.filter((before) => !runs.some((run) => isSame(run, before))), ...runs];
    this.#asked = runs;
    const signal = this.startJob();
    await Promise.all(runs.map((run) => this.#carryOut(run, signal)));
    this.endJob();
  }

  #find(experiment: Experiment): ExperimentRun | undefined {
    return this.#runs.find((run) => isSame(run, experiment));
  }

  /** Carries out one training. A failure does not end the others. */
  async #carryOut(run: ExperimentRun, signal: AbortSignal): Promise<void> {
    const { seed, driving, points } = run;
    try {
      const { pool } = this.whole;
      this.#width = pool.width;
      const outcome = await pool.run((worker) => {
        run.state = "running";
        return worker.trainExperiment(
          { seed, driving, points },
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
      run.outcome = outcome;
    } catch (problem) {
      // A training that was cancelled before it began leaves the list.
      if (problem === signal.reason) this.#runs = this.#runs.filter((other) => other !== run);
      else [run.state, run.ending] = ["failed", messageOf(problem)];
    }
    this.changedSoon();
  }
}
