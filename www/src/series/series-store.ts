// The shown model of tables: its current couplings, its given columns and its rollout.
import type { Coupled, LatentModel } from "../couplings/coupled";
import { CouplingsStore } from "../couplings/couplings-store";
import { Latest } from "../engine/latest";
import type {
  OpenedSeries,
  SeriesInfo,
  SeriesRequest,
  SeriesRollout,
  TrainedSeries,
} from "../engine/series-protocol";
import { OpenDocument } from "../engine/open-document";
import type { Future } from "../latents/outlook-drawing";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { mayLose, type Work } from "../unsaved/unsaved";
import { type Giver, GivenColumns } from "./given-columns";
import { goingOn } from "./going-on";
import type { TableEntry, TablesStore } from "./tables-store";
import { seriesWords } from "./view-words";
import { Clock } from "../stage/clock";

class SeriesClock extends Clock {
  /** Stays at the current frame if the new rollout has this frame, which is counted from `first` now. */
  load(frames: number, frameTime: number, first: number): void {
    this.player.frame = Math.max(0, this.player.frame - first);
    this.player.load(frames, frameTime, frames - 1);
    this.changed();
  }
}

/** A rollout is longer than its table, to show also the time after the recording. */
const longer = (rows: number) => Math.max(2, Math.round(1.5 * rows));

interface OpenModel extends OpenedSeries {
  text: string;
  /** Latent means of the training rows of each part; null for a model from a file. */
  trainingLatents: Float64Array[] | null;
  /** Whether the model was trained here and has not been saved. */
  unsaved: boolean;
}

export const FUTURES = 5;

/** A motion without an end goes on when this share of its rollout has been shown. */
const SHOWN = 0.7;

interface Asked {
  request: SeriesRequest;
  /** Whether the rollout goes on from the frame now. */
  goesOn: boolean;
  /** Frames by which each part is set back then. */
  back?: readonly number[];
}

interface Rolled extends Asked {
  /** The frame of the rollout before that is the first one now. */
  first: number;
  rollout: SeriesRollout;
  /** Sampled rollouts of the same frames. */
  futures: Future[];
  /** The rollout from the same start under the learned couplings. */
  learned: SeriesRollout;
}

export class SeriesStore extends Store implements Coupled {
  readonly clock = new SeriesClock();
  /** Only a vCGPDM or vGPDM has couplings; empty for other kinds of models. */
  readonly couplings = new CouplingsStore(() => this.#request());
  readonly #document: OpenDocument<WholeCalls, OpenedSeries>;
  readonly #rollouts: Latest<Asked, Rolled>;
  readonly #given = new GivenColumns();
  #opened: OpenModel | null = null;
  #sequence = 0;
  /** The seed of the first future; 0: there are none. */
  seed = 0;
  #rolled: Rolled | null = null;
  /** Whether the next frames of a motion without an end were asked for. */
  #asksNext = false;
  /** Whether a rollout was asked for that begins as the table did, and was not shown. */
  #begins = false;
  #problem = "";

  /** `endless`: the frames of each rollout of a motion that goes on without an end; null: a rollout ends. */
  constructor(
    { desk }: Pick<WholeWorkers, "desk">,
    private readonly tables: TablesStore,
    private readonly endless: number | null = null,
  ) {
    super();
    this.#document = new OpenDocument(desk, (worker, text) => worker.openSeries(text));
    // The visitor may have opened or removed the table that the rollout starts from.
    tables.on(() => (this.#given.isEmpty ? this.changed() : this.#request()));
    this.#rollouts = new Latest(
      (asked) => this.#roll(asked),
      (rolled) => this.#show(rolled),
      (problem) => {
        this.#problem = messageOf(problem);
        this.changed();
      },
    );
    if (endless) this.clock.on(() => this.#goOn());
  }

  get opened(): OpenModel | null {
    return this.#opened;
  }

  /** The model if it has latent spaces and couplings. */
  get model(): LatentModel | null {
    return this.#opened?.info.alpha ? (this.#opened as LatentModel) : null;
  }

  /** The rollout under the current couplings; null before the first rollout. */
  get rollout(): SeriesRollout | null {
    return this.#rolled?.rollout ?? null;
  }

  get learned(): SeriesRollout | null {
    return this.#rolled?.learned ?? null;
  }

  /** The reason why the rollout under the newest couplings failed; empty if it did not fail. */
  get problem(): string {
    return this.#problem;
  }

  /** The index of the training table that the rollout starts from. */
  get sequence(): number {
    return this.#sequence;
  }

  /**
   * The table that the rollout starts from; null if it is not open. The file of the model does not contain
   * the table.
   */
  get recorded(): TableEntry | null {
    const { sha256 } = this.#opened?.info.sequences[this.#sequence] ?? {};
    return this.tables.all.find(({ info }) => info.sha256 === sha256) ?? null;
  }

  /** The unsaved model, which would be lost; null if there is none. */
  get unsaved(): Work | null {
    return this.#opened?.unsaved ? { what: seriesWords().unsaved, save: () => this.save() } : null;
  }

  /** Saves the model as a file on the visitor's disk. */
  save(): void {
    if (!this.#opened) return;
    download("series.model.json", new Blob([this.#opened.text], { type: "application/json" }));
    this.#opened = { ...this.#opened, unsaved: false };
    this.changed();
  }

  /**
   * Opens a model from a file and returns true. If opening fails or the visitor keeps an unsaved model, the
   * earlier model stays.
   */
  async open(text: string): Promise<boolean> {
    const read = await this.#read(text, null);
    if (!(await mayLose(this.unsaved))) return false;
    this.#takeUp(read);
    return true;
  }

  /** Opens a model that was trained here. */
  async takeTrained({ text, latents }: TrainedSeries): Promise<void> {
    this.#takeUp(await this.#read(text, latents));
  }

  async #read(
    text: string,
    training: TrainedSeries["latents"] | null,
  ): Promise<{ opened: OpenModel; rolled: Rolled }> {
    const model = await this.#document.open(text);
    const opened = { text, ...model, trainingLatents: training, unsaved: training !== null };
    const asked = { request: this.#asLearned(model.info, 0), goesOn: false };
    return { opened, rolled: await this.#roll(asked, opened) };
  }

  #takeUp({ opened, rolled }: { opened: OpenModel; rolled: Rolled }): void {
    this.#rollouts.drop();
    this.#opened = opened;
    this.#given.clear();
    this.couplings.learn(opened.info.alpha ?? []);
    this.#sequence = 0;
    this.#rolled = null;
    this.#show(rolled);
  }

  /** Who moves a column; null: the model. */
  giverOf(column: string): Giver | null {
    return this.#given.giverOf(column);
  }

  /** Gives a column to the recording or to the visitor's hand, or back to the model: then it is missing. */
  give(column: string, giver: Giver | null): void {
    const { info } = this.#opened ?? {};
    const [place, width] = [info?.columns.indexOf(column) ?? -1, info?.columns.length ?? 1];
    const curve = this.rollout?.values.filter((_, i) => i % width === place) ?? new Float64Array();
    this.#given.give(column, giver, curve);
    this.#request();
  }

  /** Draws a line between two points, each a frame and a value, of a column by hand. */
  draw(column: string, from: readonly [number, number], to: readonly [number, number]): void {
    this.#given.draw(column, from, to);
    this.#request();
  }

  /** Bends a column by hand at the frame of the clock. */
  bend(column: string, by: number): void {
    this.#given.bend(column, Math.round(this.clock.frame), by);
    this.#request();
  }

  setSequence(sequence: number): void {
    this.#sequence = sequence;
    this.#request();
  }

  get futures(): readonly Future[] {
    return this.#rolled?.futures ?? [];
  }

  /** Shows five sampled rollouts of the seeds from this one on, without an end from now on; 0: none. */
  showFutures(seed: number): void {
    this.seed = seed;
    this.#request(this.endless !== null);
  }

  /** The shown rollout as CSV: one row for each frame, with the columns of the model. */
  async csv(): Promise<string> {
    const [opened, rolled] = [this.#opened, this.#rolled];
    if (!opened || !rolled) throw new Error(seriesWords().noModel);
    return this.#document.ask(opened.text, (worker) => worker.seriesCsv(rolled.request));
  }

  /** Asks for the next frames before the clock needs them. */
  #goOn(): void {
    if (this.#asksNext || this.clock.frame < SHOWN * this.clock.lastFrame) return;
    this.#asksNext = true;
    this.#request(true);
  }

  /** Sets parts back by frames, each by its own: the motion goes on from there. */
  setBack(back: readonly number[]): void {
    this.#request(true, back);
  }

  /** Without an end, changed couplings act from the frame now; those as learned begin as the table did. */
  #request(goesOn = this.endless !== null && this.couplings.altered, back: readonly number[] = []): void {
    const { info } = this.#opened ?? {};
    this.changed();
    if (!info) return;
    const learned = this.#asLearned(info, this.#sequence);
    const observed = this.#given.observed(info, learned.frames, this.recorded);
    const { alpha, altered, reading } = this.couplings;
    const request = { ...learned, observed, ...(altered ? { alpha, reading } : {}) };
    // A later request may replace one that begins before it was shown.
    this.#begins ||= !goesOn;
    this.#rollouts.request({ request, goesOn: !this.#begins, back });
  }

  async #roll({ request, goesOn, back }: Asked, opened = this.#opened): Promise<Rolled> {
    if (!opened) throw new Error(seriesWords().noModel);
    const { text, info } = opened;
    const ask = (asked: SeriesRequest) => this.#document.ask(text, (worker) => worker.rolloutSeries(asked));
    const now = opened === this.#opened ? this.#rolled : null;
    const { sequence, frames } = request;
    const isSame = now?.request.sequence === sequence && now.request.frames === frames;
    const learned = isSame ? now.learned : await ask(this.#asLearned(info, sequence));
    const { frame, lastFrame } = this.clock;
    const past = goesOn && now ? goingOn(now.rollout, [lastFrame + 1, frame, info.order ?? 1], back) : null;
    const asked = past ? { ...request, start: past.start } : request;
    const next = past || asked.alpha || asked.observed ? await ask(asked) : learned;
    const joined = past?.joined ?? ((next: SeriesRollout) => next);
    const rollout = joined(next);
    const sample = (worker: WholeCalls) => worker.sampleSeries(asked, FUTURES, this.seed);
    const sampled = this.seed > 0 ? await this.#document.ask(text, sample) : [];
    const length = rollout.values.length / info.columns.length;
    const futures = sampled.map((future) => ({ ...joined(future), request: { frames: length } }));
    return { request, goesOn, learned, rollout, futures, first: past?.first ?? 0 };
  }

  #show(rolled: Rolled): void {
    const { columns, frameTime } = this.#opened?.info ?? { columns: [], frameTime: 1 };
    [this.#rolled, this.#problem, this.#asksNext] = [rolled, "", false];
    if (!rolled.goesOn) this.#begins = false;
    this.clock.load(rolled.rollout.values.length / columns.length, frameTime, rolled.first);
    this.changed();
  }

  #asLearned({ sequences }: SeriesInfo, sequence: number): SeriesRequest {
    const frames = this.endless ?? longer(sequences[sequence]?.frames ?? 0);
    return { frames, sequence, alpha: null, reading: "as-learned", observed: null };
  }
}
