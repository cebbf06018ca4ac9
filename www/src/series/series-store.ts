// The model of tables that is looked at: its couplings as the sliders have them, and its rollout.
import { CouplingsStore } from "../couplings/couplings-store";
import { Latest } from "../engine/latest";
import type { SeriesInfo, SeriesRequest, SeriesRollout, TrainedSeries } from "../engine/series-protocol";
import { OpenDocument } from "../engine/open-document";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { mayLose, type Work } from "../ui/unsaved";
import { SeriesClock } from "./series-clock";
import type { TableEntry, TablesStore } from "./tables-store";

/**
 * A rollout goes on for so long, as a share of the table that it begins as: what comes after the recording is
 * worth seeing too.
 */
const AS_LONG = 1.5;

interface OpenModel {
  text: string;
  info: SeriesInfo;
  /** Latent means of the training rows of each part; null for a model from a file. */
  training: Float64Array[] | null;
  /** Whether it was trained here, and not saved since. */
  unsaved: boolean;
}

interface Rolled {
  asked: SeriesRequest;
  rollout: SeriesRollout;
  /** The same start as learned. */
  learned: SeriesRollout;
}

export class SeriesStore extends Store {
  readonly clock = new SeriesClock();
  /** Empty for a model of another kind than vCGPDM and vGPDM. */
  readonly couplings = new CouplingsStore(() => this.#request());
  readonly #document: OpenDocument<WholeCalls, SeriesInfo>;
  readonly #tables: TablesStore;
  readonly #rollouts: Latest<SeriesRequest, Rolled>;
  #opened: OpenModel | null = null;
  #sequence = 0;
  #rolled: Rolled | null = null;
  #problem = "";

  constructor({ desk }: Pick<WholeWorkers, "desk">, tables: TablesStore) {
    super();
    this.#document = new OpenDocument(desk, (worker, text) => worker.openSeries(text));
    this.#tables = tables;
    // The table that a rollout begins as may have been opened, or be gone.
    tables.on(() => this.changed());
    this.#rollouts = new Latest(
      (asked) => this.#roll(asked),
      (rolled) => this.#show(rolled),
      (problem) => {
        this.#problem = messageOf(problem);
        this.changed();
      },
    );
  }

  get opened(): OpenModel | null {
    return this.#opened;
  }

  /** The rollout with the couplings as they are; null before the first. */
  get rollout(): SeriesRollout | null {
    return this.#rolled?.rollout ?? null;
  }

  get learned(): SeriesRollout | null {
    return this.#rolled?.learned ?? null;
  }

  /** Why the newest couplings could not be rolled out; empty when they could. */
  get problem(): string {
    return this.#problem;
  }

  /** The training table that the rollout begins as. */
  get sequence(): number {
    return this.#sequence;
  }

  /** The table that the rollout begins as, where it is open: the model's file does not hold it. */
  get recorded(): TableEntry | null {
    const { sha256 } = this.#opened?.info.sequences[this.#sequence] ?? {};
    return this.#tables.all.find(({ info }) => info.sha256 === sha256) ?? null;
  }

  /** The model, where leaving it would lose it. */
  get unsaved(): Work | null {
    return this.#opened?.unsaved
      ? { what: "the model of tables that was trained here", save: () => this.save() }
      : null;
  }

  /** Saves the model to the visitor's disk. */
  save(): void {
    if (!this.#opened) return;
    download("series.model.json", new Blob([this.#opened.text], { type: "application/json" }));
    this.#opened = { ...this.#opened, unsaved: false };
    this.changed();
  }

  /**
   * Takes a model from a file up, and says whether; the one before stays where that fails, or where the
   * visitor keeps it.
   */
  async open(text: string): Promise<boolean> {
    const read = await this.#read(text, null);
    if (!(await mayLose(this.unsaved))) return false;
    this.#takeUp(read);
    return true;
  }

  /** Takes a model up that was trained here. */
  async takeTrained({ text, latents }: TrainedSeries): Promise<void> {
    this.#takeUp(await this.#read(text, latents));
  }

  async #read(
    text: string,
    training: TrainedSeries["latents"] | null,
  ): Promise<{ opened: OpenModel; rolled: Rolled }> {
    const info = await this.#document.open(text);
    const opened = { text, info, training, unsaved: training !== null };
    return { opened, rolled: await this.#roll(asLearned(info, 0), opened) };
  }

  #takeUp({ opened, rolled }: { opened: OpenModel; rolled: Rolled }): void {
    this.#rollouts.drop();
    this.#opened = opened;
    this.couplings.learn(opened.info.alpha ?? []);
    this.#sequence = 0;
    this.#rolled = null;
    this.#show(rolled);
  }

  setSequence(sequence: number): void {
    this.#sequence = sequence;
    this.#request();
  }

  /** The rollout that is shown as CSV: a row a frame, a column for each of the model's. */
  async csv(): Promise<string> {
    const [opened, rolled] = [this.#opened, this.#rolled];
    if (!opened || !rolled) throw new Error("There is no model yet: train one or open one.");
    return this.#document.ask(opened.text, (worker) => worker.seriesCsv(rolled.asked));
  }

  #request(): void {
    const { info } = this.#opened ?? {};
    this.changed();
    if (!info) return;
    const asked = asLearned(info, this.#sequence);
    const { alpha, altered, reading } = this.couplings;
    this.#rollouts.request(altered ? { ...asked, alpha, reading } : asked);
  }

  async #roll(asked: SeriesRequest, opened = this.#opened): Promise<Rolled> {
    if (!opened) throw new Error("There is no model yet: train one or open one.");
    const { text, info } = opened;
    const ask = (asked: SeriesRequest) => this.#document.ask(text, (worker) => worker.rolloutSeries(asked));
    const before =
      opened === this.#opened && this.#rolled?.asked.sequence === asked.sequence ? this.#rolled : null;
    const learned = before?.learned ?? (await ask(asLearned(info, asked.sequence)));
    return { asked, learned, rollout: asked.alpha ? await ask(asked) : learned };
  }

  #show(rolled: Rolled): void {
    this.#rolled = rolled;
    this.#problem = "";
    this.clock.load(rolled.asked.frames, this.#opened?.info.frameTime ?? 1);
    this.changed();
  }
}

function asLearned({ sequences }: SeriesInfo, sequence: number): SeriesRequest {
  const frames = Math.max(2, Math.round(AS_LONG * (sequences[sequence]?.frames ?? 0)));
  return { frames, sequence, alpha: null, reading: "as-learned" };
}
