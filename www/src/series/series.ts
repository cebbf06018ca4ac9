// The stores of the view of time series.
import type { WholeWorkers } from "../engine/whole-workers";
import type { SettingsStore } from "../settings/settings-store";
import { SeriesStore } from "./series-store";
import { SeriesTrainingStore } from "./series-training-store";
import { TablesStore } from "./tables-store";

/** All stores of the view. */
export type Series = ReturnType<typeof openSeries>;

export function openSeries(whole: WholeWorkers, settings: SettingsStore) {
  const tables = new TablesStore(whole);
  const model = new SeriesStore(whole, tables);
  return { tables, model, training: new SeriesTrainingStore(whole, settings, tables, model) };
}
