// A drawing of one hand or of two, and the model that goes on with it.
import { isOff } from "../couplings/weights";
import type { TrainedSeries } from "../engine/series-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { SeriesStore } from "../series/series-store";
import { TablesStore } from "../series/tables-store";
import type { SettingsStore } from "../settings/settings-store";
import { ProgressStore } from "../training/progress-store";
import { drawingWords } from "./view-words";
import { circle, drawnBy, eight } from "./example";
import type { GoesOn, goesOn } from "./goes-on";
import {
  type Drawing,
  DRAWING_SETTINGS,
  drawingOf,
  drawnBeside,
  HEIGHT,
  LONGEST,
  onPad,
  placeInRound,
  READS_A_SECOND,
  type Rows,
  ROWS_A_SECOND,
  type Sample,
  WIDTH,
} from "./hand";

/** The names of the parts: the pads from left to right. */
export const HANDS = ["left", "right"] as const;
export type Pad = 0 | 1;

/** After letting go, a hand has as many milliseconds for another stroke. */
const NEXT_STROKE = 400;
/** The frames of a rollout: 20 seconds of a drawing with the most rows a second. */
const AT_A_TIME = 20 * ROWS_A_SECOND;

/** The table of a drawing, as a file. */
export function drawingFile({ rows, rate }: Pick<Drawing, "rows" | "rate">, pads: readonly Pad[]): File {
  const names = pads.flatMap((pad) => [`${HANDS[pad]}_x`, `${HANDS[pad]}_y`]);
  const lines = rows.map((row, i) => [i / rate, ...row].map((value) => value.toFixed(3)).join(","));
  return new File([["time", ...names].join(","), "\n", lines.join("\n"), "\n"], "drawing.csv");
}

export class DrawingStore extends ProgressStore<TrainedSeries> {
  readonly model: SeriesStore;
  /** The strokes of the pads that are drawn on now. */
  readonly #strokes = new Map<Pad, Sample[][]>();
  /** The pads that a pen touches now. */
  readonly #touched = new Set<Pad>();
  /** When the drawing began, in milliseconds, and the timer that ends it. */
  #began = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The drawing that the model on show learned, and its pads; null before the first. */
  #drawn: { drawing: Drawing; pads: readonly Pad[] } | null = null;
  #goesOn: typeof goesOn | null = null;
  #tooLittle = false;
  #badLink = false;
  #woken = false;
  #lost: Pad | undefined;
  /** Counts the drawings: a training that ends after the next one began is of no use. */
  #newest = 0;

  constructor(private readonly workers: WholeWorkers) {
    super();
    this.model = new SeriesStore(workers, new TablesStore(workers), AT_A_TIME);
    this.model.on(() => this.changed());
  }

  get drawn(): { drawing: Drawing; pads: readonly Pad[] } | null {
    return this.#drawn;
  }

  /** The strokes on a pad while it is drawn on; null: it is not. */
  strokes(pad: Pad): readonly (readonly Sample[])[] | null {
    return this.#strokes.get(pad) ?? null;
  }

  get isDrawing(): boolean {
    return this.#strokes.size > 0;
  }

  /** Begins a stroke on a pad, at a time in milliseconds. The first stroke begins a drawing. */
  begin(pad: Pad, x: number, y: number, now: number): void {
    this.#forgetTraining();
    this.#wake();
    if (!this.isDrawing) this.#began = now;
    this.#touched.add(pad);
    const strokes = this.#strokes.get(pad) ?? [];
    strokes.push([]);
    this.#strokes.set(pad, strokes);
    this.move(pad, x, y, now);
  }

  move(pad: Pad, x: number, y: number, now: number): void {
    const stroke = this.#strokes.get(pad)?.at(-1);
    const seconds = (now - this.#began) / 1000;
    const inside = (value: number, most: number) => Math.min(most, Math.max(0, value));
    if (!stroke || seconds > LONGEST) return;
    stroke.push({ seconds, x: inside(x, WIDTH), y: inside(y, HEIGHT) });
    this.changed();
  }

  /** The program arrives while a hand draws. */
  #wake(): void {
    if (this.#woken) return;
    this.#woken = true;
    // The training itself says what went wrong.
    this.workers.pool.run(async () => {}).catch(() => {});
    this.workers.desk.run(async () => {}).catch(() => {});
  }

  #forgetTraining(): void {
    clearTimeout(this.#timer);
    this.#newest += 1;
    this.cancel();
    [this.#tooLittle, this.#badLink] = [false, false];
  }

  /** Ends a stroke. Without another one soon, on no pad, the model learns the drawing. */
  end(pad: Pad): void {
    clearTimeout(this.#timer);
    this.#touched.delete(pad);
    if (this.#touched.size > 0) return;
    this.#timer = setTimeout(() => void this.finish(), NEXT_STROKE);
  }

  /** The model learns what was drawn. */
  async finish(): Promise<void> {
    clearTimeout(this.#timer);
    const found = this.#joined();
    this.#strokes.clear();
    this.#touched.clear();
    this.#tooLittle = found === null;
    this.changed();
    if (found) await this.learn(found.drawing, found.pads);
  }

  /** The drawing on both pads. A pad that was not drawn on plays what it has. */
  #joined(): { drawing: Drawing; pads: readonly Pad[] } | null {
    const { drawing, pads: before = [] } = this.#drawn ?? {};
    const pads = ([0, 1] as const).filter((pad) => this.#strokes.has(pad) || before.includes(pad));
    const drawn = pads.filter((pad) => this.#strokes.has(pad));
    const own = drawingOf(drawn.map((pad) => this.#strokes.get(pad) ?? []));
    const played =
      drawn.length < pads.length ? drawing?.rounds[before.indexOf(drawn[0] === 0 ? 1 : 0)] : null;
    return own && { drawing: played ? drawnBeside(played, own, drawn[0] ?? 0) : own, pads };
  }

  async learn(drawing: Drawing, pads: readonly Pad[]): Promise<void> {
    const file = drawingFile(drawing, pads);
    const parts = pads.map((pad) => ({ name: HANDS[pad], columns: [`${HANDS[pad]}_x`, `${HANDS[pad]}_y`] }));
    const tables = [{ name: file.name, file, without: [] }];
    const job = { tables, settings: { ...DRAWING_SETTINGS, framesPerSecond: drawing.rate, parts } };
    this.#forgetTraining();
    const now = this.#newest;
    // An earlier training is about to stop.
    while (this.busy) await new Promise((passed) => setTimeout(passed, 20));
    if (now !== this.#newest) return;
    // The measure arrives while the model learns: a first visit does without it.
    const measure = import("./goes-on");
    const found = await this.run(async (report, signal) => {
      const trained = this.workers.pool.run((worker) => worker.trainSeries(job, report, signal), signal);
      [this.#goesOn] = await Promise.all([measure.then(({ goesOn }) => goesOn), trained]);
      return trained;
    });
    if (!found || now !== this.#newest) return;
    await this.model.takeTrained(found);
    this.#drawn = { drawing, pads };
    this.#badLink = false;
    this.#lost = this.#findLost();
    this.model.clock.seek(0);
    this.model.clock.play();
    this.changed();
  }

  /** Where the pen of a pad is: that of the model, or while the other pad is drawn on, that of the drawing. */
  pen(pad: Pad, now: number): readonly number[] | null {
    const place = this.#placeOf(pad);
    if (!this.#drawn || place < 0) return null;
    if (this.isDrawing)
      return placeInRound(this.#drawn.drawing.rounds[place] ?? [], Math.max(0, now - this.#began) / 1000);
    const frame = this.model.clock.frame;
    const [a, b] = [this.#at(place, Math.floor(frame)), this.#at(place, Math.ceil(frame))];
    return a && b ? a.map((value, i) => value + (frame % 1) * ((b[i] ?? value) - value)) : a;
  }

  /** The last places of the model's pen on a pad, the oldest first. */
  trail(pad: Pad, frames: number): (readonly number[])[] {
    const place = this.#placeOf(pad);
    if (place < 0 || this.isDrawing) return [];
    const now = Math.floor(this.model.clock.frame);
    return Array.from({ length: frames }, (_, i) => this.#at(place, now - frames + 1 + i)).filter(
      (found) => found !== null,
    );
  }

  /** Sets a hand back by a quarter of its round. */
  setBack(pad: Pad): void {
    const { drawing, pads = [] } = this.#drawn ?? {};
    const quarter = (round: Rows) => Math.round(((drawing?.rate ?? 0) * round.length) / READS_A_SECOND / 4);
    this.model.setBack(pads.map((own, place) => (own === pad ? quarter(drawing?.rounds[place] ?? []) : 0)));
    this.model.clock.play();
  }

  /** The rows that the model learned of a pad; empty: it was not drawn on. */
  rows(pad: Pad): number[][] {
    const place = this.#placeOf(pad);
    return this.#drawn && place >= 0 ? onPad(this.#drawn.drawing.rows, place) : [];
  }

  /** The place of a pad among those that the model learned; -1: it is none of them. */
  #placeOf(pad: Pad): number {
    return this.#drawn?.pads.indexOf(pad) ?? -1;
  }

  #at(place: number, frame: number): number[] | null {
    const values = this.model.rollout?.values;
    const width = this.model.opened?.info.columns.length ?? 0;
    const at = frame * width + 2 * place;
    return values && frame >= 0 && at + 1 < values.length ? [values[at] ?? 0, values[at + 1] ?? 0] : null;
  }

  /** A sentence: whether the model learns, goes on as drawn, or cannot learn this. Empty before the first drawing. */
  get words(): string {
    const words = drawingWords();
    if (this.#tooLittle) return words.tooLittle;
    if (this.#badLink) return words.badLink;
    if (this.busy) return words.learning;
    if (this.ending.failed) return this.ending.words;
    if (!this.#drawn) return "";
    if (this.#lost !== undefined) return words.lost(words.hands[this.#lost] ?? "");
    const { once, tempo } = this.#drawn.drawing;
    const on = once ? words.once : words.goesOn;
    if (tempo === null && !this.#isCoupled) return `${on} ${words.apart}`;
    const percent = Math.round(100 * Math.abs(1 - (tempo ?? 1)));
    return percent > 0 ? `${on} ${words.paced(percent)}` : on;
  }

  /** Whether training found a coupling between the hands. */
  get #isCoupled(): boolean {
    const { couplings } = this.model;
    return [0, 1].some((source) => !isOff(couplings.learnedWeight(source, 1 - source)));
  }

  /** The hand that does not go on as it was drawn; undefined: all do. */
  #findLost(): Pad | undefined {
    return this.#drawn?.pads[this.compared(this.model.learned?.values).findIndex(({ goesOn }) => !goesOn)];
  }

  /** Each hand of a rollout, compared with its drawing. */
  compared(values: Float64Array | undefined): GoesOn[] {
    const { drawing, pads } = this.#drawn ?? {};
    const compare = this.#goesOn;
    if (!values || !drawing || !pads || !compare) return [];
    const width = 2 * pads.length;
    const rows = Array.from({ length: values.length / width }, (_, i) =>
      Array.from(values.subarray(i * width, (i + 1) * width)),
    );
    return pads.map((_, place) => compare(onPad(drawing.rows, place), onPad(rows, place), drawing.lap));
  }

  /** An eight, and on the second pad a circle, by formulas, as if they were drawn now. */
  async example(pads: readonly Pad[] = [0, 1]): Promise<void> {
    const drawing = drawingOf(pads.map((pad) => [drawnBy(pad === 0 ? eight : circle)]));
    if (drawing) await this.learn(drawing, pads);
  }

  /** The drawing of a link cannot be read. */
  refuse(): void {
    this.#badLink = true;
    this.changed();
  }

  clear(): void {
    this.#forgetTraining();
    this.#strokes.clear();
    this.#touched.clear();
    this.#drawn = null;
    this.changed();
  }
}

type Keep = { keepInAddress(store: DrawingStore, settings: SettingsStore): void };

/** Keeps drawings in the address: a first visit loads what this needs when a hand begins to draw. */
export function linkDrawings(store: DrawingStore, settings: SettingsStore, load: () => Promise<Keep>): void {
  let link: Promise<void> | null = null;
  const look = () => {
    if (link || !(settings.values.drawing || store.isDrawing || store.busy)) return;
    link = load().then(({ keepInAddress }) => keepInAddress(store, settings));
    link.catch(() => {
      link = null;
    });
  };
  store.on(look);
  settings.on(look);
  look();
}
