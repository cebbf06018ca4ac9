// Confusion rate, error and bound over the number of primitives or bases (figure 2 of Knopp et al. 2019).
import { html } from "lit";
import type { ModelKind, PerceptionResults } from "../engine/whole-protocol";
import { FigureElement } from "../figures/figure-element";
import { plain } from "../figures/numbers";
import { modelStyle } from "../figures/model-style";
import {
  type Answered,
  answeredSettings,
  type Measure,
  MSE_TITLE,
  measureOf,
  RATE_TITLES,
  rateFields,
  rateMeasure,
} from "./answered-settings";
import { perceptionWords } from "./view-words";
import { type Panel, type PanelPoint, panels } from "./panel";

/** The names of the building blocks that a model counts. */
const BLOCKS: Partial<Record<ModelKind, "primitives" | "bases">> = {
  tmp: "primitives",
  "dmp-discrete": "bases",
  "dmp-rhythmic": "bases",
};

interface Row {
  setting: Answered;
  blocks: number;
}

/** The models with such building blocks, each with its settings by their number. */
function counted(results: PerceptionResults): [ModelKind, Row[]][] {
  const byModel = new Map<ModelKind, Row[]>();
  for (const setting of answeredSettings(results)) {
    const blocks = setting.size.primitives ?? setting.size.bases;
    if (blocks === null) continue;
    byModel.set(setting.model, [...(byModel.get(setting.model) ?? []), { setting, blocks }]);
  }
  return [...byModel].map(([model, rows]) => [model, rows.sort((a, b) => a.blocks - b.blocks)]);
}

function panelOf(
  model: ModelKind,
  rows: readonly Row[],
  { name, axis, references, of }: Measure,
): Panel | null {
  const points = rows.flatMap(({ setting, blocks }): PanelPoint[] => {
    const value = of(setting);
    return value ? [{ model, x: blocks, ...value }] : [];
  });
  if (points.length === 0) return null;
  const words = perceptionWords().figures.rates;
  const kind = BLOCKS[model] ?? "bases";
  return {
    heading: html`<span class="name">${modelStyle(model).name}</span> <small>${name}</small>`,
    words: `${modelStyle(model).name}, ${name}: ${points.map(({ x, y }) => words.value(plain(y), x, kind)).join(", ")}`,
    x: { title: words.blocks[kind], kind: "linear", reach: [] },
    y: axis,
    points,
    lines: [{ model, places: points.map(({ x, y }) => [x, y] as const) }],
    references,
  };
}

export class RatesFigure extends FigureElement<PerceptionResults> {
  protected readonly words = () => perceptionWords().figures.rates;
  protected readonly file = "confusion-over-primitives-and-bases";

  protected missing(results: PerceptionResults): string | null {
    return counted(results).length === 0 ? perceptionWords().figures.needsBlocks : null;
  }

  protected table(results: PerceptionResults) {
    return {
      header: ["model", "primitives or bases", ...RATE_TITLES, MSE_TITLE, "bound (nats)"],
      rows: counted(results).flatMap(([model, rows]) =>
        rows.map(({ setting: { confusion, scores }, blocks }) => [
          ...[modelStyle(model).name, blocks, ...rateFields(confusion), scores.mse, scores.bound],
        ]),
      ),
    };
  }

  protected figure(results: PerceptionResults) {
    const words = perceptionWords().figures;
    const all = counted(results).flatMap(([model, rows]) =>
      [rateMeasure(), measureOf("mse"), measureOf("bound")].flatMap(
        (measure) => panelOf(model, rows, measure) ?? [],
      ),
    );
    return html`
      ${panels(all, this.width, this.type)}
      <figcaption>${words.bars} ${words.rates.caption}</figcaption>`;
  }
}
customElements.define("perception-rates", RatesFigure);
