// The tables and the settings of a training on them.
import { html, nothing } from "lit";
import { settingField } from "../settings/setting-field";
import type { SettingsStore } from "../settings/settings-store";
import { fileButton } from "../ui/file-button";
import type { NoticesStore } from "../ui/notices-store";
import { noticeCard } from "../ui/notices-view";
import { lab } from "../words/lab";
import { seriesWords } from "./view-words";
import type { Series } from "./series";
import "./tables-view";

/** The column of a table that holds seconds. */
const TIME_COLUMN = "time";

const COUNTS = ["latent", "dynamicsIps", "poseIps", "order", "maxIterations", "seed"] as const;

export interface SeriesSetup {
  series: Series;
  settings: SettingsStore;
  notices: NoticesStore;
  open(files: readonly File[]): void;
}

export function seriesSetup({ series: { tables, training, model }, settings, notices, open }: SeriesSetup) {
  const { busy } = training;
  const timeless = tables.ticked.some(({ info }) => info.frameTime === null);
  const from = model.opened?.info.provenance;
  const words = seriesWords();
  const [dropHere, seconds] = words.drop;
  const field = (name: (typeof COUNTS)[number] | "framesPerSecond") =>
    settingField(settings, name, { ...words.fields[name], testId: `series-${name}`, disabled: busy });
  return html`
    <header class="panel-head row"><h2>${words.tables}</h2>
      ${fileButton({
        label: words.open,
        meaning: words.openMeaning,
        testId: "open-series",
        accept: ".csv,.json,text/csv,application/json",
        multiple: true,
        disabled: busy,
        chosen: open,
      })}
    </header>
    ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
    <p class="hint">${dropHere} <code>${TIME_COLUMN}</code> ${seconds}</p>
    <pg-tables .tables=${tables} ?busy=${busy}></pg-tables>
    <div class="fields">
      ${COUNTS.map(field)}
      ${timeless ? field("framesPerSecond") : nothing}
    </div>
    ${from ? html`<p class="hint">${words.provenance(from.engine, from.iterations, from.settings.seed)}</p>` : nothing}`;
}
