// The stores of the view of time series.
import type { WholeWorkers } from "../engine/whole-workers";
import type { SettingsStore } from "../settings/settings-store";
import { SeriesStore } from "./series-store";
import { TablesStore } from "./tables-store";
import type { TrainedSeries } from "../engine/series-protocol";
import { pointsOf } from "../settings/settings";
import { ProgressStore } from "../training/progress-store";
import { mayLose } from "../unsaved/unsaved";
import { seriesWords } from "./view-words";

class SeriesTrainingStore extends ProgressStore<TrainedSeries> {
  constructor(
    private readonly whole: WholeWorkers,
    private readonly settings: Pick<SettingsStore, "values">,
    private readonly tables: TablesStore,
    private readonly series: SeriesStore,
  ) {
    super();
  }

  /** The reason why training cannot start now; empty if it can. */
  get whyNot(): string {
    const { ticked, clash } = this.tables;
    if (ticked.length === 0) return seriesWords().openFirst;
    return clash ? seriesWords().clash : "";
  }

  /** Trains a model and shows it instead of the current one. */
  async train(): Promise<void> {
    if (this.busy || this.whyNot || !(await mayLose(this.series.unsaved))) return;
    const { latent, order, framesPerSecond, seed, maxIterations } = this.settings.values;
    const { dynamicsIps, poseIps } = pointsOf(this.settings.values);
    const parts = this.tables.parts.filter(({ columns }) => columns.length > 0);
    const job = {
      tables: this.tables.ticked.map(({ source }) => source),
      settings: { parts, latent, dynamicsIps, poseIps, order, framesPerSecond, seed, maxIterations },
    };
    const found = await this.run((report, signal) =>
      this.whole.pool.run((worker) => worker.trainSeries(job, report, signal), signal),
    );
    if (found) await this.series.takeTrained(found);
  }
}

/** All stores of the view. */
export type Series = ReturnType<typeof openSeries>;

export function openSeries(whole: WholeWorkers, settings: SettingsStore) {
  const tables = new TablesStore(whole);
  const model = new SeriesStore(whole, tables);
  return { tables, model, training: new SeriesTrainingStore(whole, settings, tables, model) };
}
