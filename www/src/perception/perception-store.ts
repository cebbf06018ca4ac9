// The graphics Turing test of this visit: the study, who has answered on this machine, and who is answering
// now.
import type { WholeWorkers } from "../engine/whole-workers";
import type { StudyChange, StudyInfo, StudyView } from "../engine/whole-protocol";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { mayLose, type Work } from "../ui/unsaved";
import {
  type AnswerShelf,
  answered,
  columnsOf,
  isComplete,
  type KeptParticipation,
  freeName,
  newName,
  newParticipation,
  newSeed,
  type Row,
  sittings,
} from "./participation";
import { type Step, stepsOf } from "./steps";

/** A participant who is answering now. */
export interface Sitting {
  participation: KeptParticipation;
  study: StudyInfo;
  steps: readonly Step[];
  columns: Row;
  /** Places of the figure's nodes in each movement [frames x nodes x 3]. */
  movements: readonly Float32Array[];
}

export class PerceptionStore extends Store {
  readonly #whole: WholeWorkers;
  readonly #shelf: AnswerShelf | null;
  readonly #studyOfThePage: () => Promise<string>;
  #study: StudyView | null = null;
  /** The text of the study when it was opened or saved; empty: it was made here. */
  #onDisk = "";
  #kept: readonly KeptParticipation[] = [];
  /** The studies of participants of this visit, by their keys. */
  readonly #texts = new Map<string, string>();
  #sitting: Sitting | null = null;
  /** Lets other tabs have the participation again. */
  #held: (() => void) | null = null;
  #busy = false;
  #problem = "";
  #unkept = "";
  /** Changes of a study follow each other. */
  #changing: Promise<void> = Promise.resolve();

  /** Without a shelf answers last as long as the visit. */
  constructor(whole: WholeWorkers, shelf: AnswerShelf | null, studyOfThePage: () => Promise<string>) {
    super();
    [this.#whole, this.#shelf, this.#studyOfThePage] = [whole, shelf, studyOfThePage];
  }

  get study(): StudyView | null {
    return this.#study;
  }

  /** Who has answered on this machine, the newest first. */
  get kept(): readonly KeptParticipation[] {
    return this.#kept;
  }

  get sitting(): Sitting | null {
    return this.#sitting;
  }

  /** A study or its movements are being read. */
  get busy(): boolean {
    return this.#busy;
  }

  /** Why a study could not be opened or changed, or an experiment not begun. */
  get problem(): string {
    return this.#problem;
  }

  /** Why answers are not kept beyond this visit; empty when they are. */
  get unkept(): string {
    return this.#shelf === null ? "this browser keeps nothing" : this.#unkept;
  }

  /** Brings what earlier visits have left. */
  async arrive(): Promise<void> {
    const found = (await this.#shelf?.all()) ?? [];
    const known = new Set(this.#kept.map(({ key }) => key));
    this.#kept = [...this.#kept, ...found.filter(({ key }) => !known.has(key))].sort((a, b) => b.at - a.at);
    this.changed();
  }

  /** Kept when a study is open: without another that of the page. */
  ready(): Promise<void> {
    return this.#next(async () => {
      if (!this.#study) await this.#open(this.#studyOfThePage);
    });
  }

  /** `made`: it was made here, and is on no disk. The one before stays where the visitor keeps it. */
  openStudy(text: () => Promise<string>, made = false): Promise<void> {
    return this.#next(() => this.#open(text, made));
  }

  async #open(text: () => Promise<string>, made = false): Promise<void> {
    const opened = await text();
    const study = await this.#whole.desk.run((worker) => worker.openStudy(opened));
    if (!(await mayLose(this.unsaved))) return;
    this.#study = study;
    this.#onDisk = made ? "" : study.text;
  }

  /** The study, where it was made or changed here and not saved since. */
  get unsaved(): Work | null {
    const study = this.#study;
    if (!study || study.text === this.#onDisk) return null;
    return {
      what: `the study “${study.info.title}” as it was made or changed here`,
      save: () => this.saveStudy(),
    };
  }

  /** Saves the study to the visitor's disk. */
  saveStudy(): void {
    if (!this.#study) return;
    const { info, text } = this.#study;
    const name = info.title.replace(/[^\p{L}\p{N}._-]+/gu, "-") || "study";
    download(`${name}.study.json`, new Blob([text], { type: "application/json" }));
    this.#onDisk = text;
    this.changed();
  }

  change(change: StudyChange): Promise<void> {
    return this.#next(async () => {
      const { text } = this.#study ?? {};
      if (text !== undefined)
        this.#study = await this.#whole.desk.run((worker) => worker.changeStudy(text, change));
    });
  }

  /** Places of the figure's nodes in each movement of the study that is open [frames x nodes x 3]. */
  async movements(): Promise<readonly Float32Array[]> {
    const { text } = this.#study ?? {};
    return text === undefined ? [] : this.#whole.desk.run((worker) => worker.movements(text));
  }

  /** A new participant of the study. */
  begin(name: string, simulated: boolean): Promise<void> {
    return this.#next(async () => {
      const { text, info } = this.#study ?? {};
      if (text === undefined || !info || this.#sitting) return;
      const seed = newSeed();
      const trials = await this.#whole.desk.run((worker) => worker.drawTrials(text, seed));
      const free = freeName(
        name.trim() || newName(),
        new Set(this.#kept.map(({ participant }) => participant)),
      );
      const participation = newParticipation(info, {
        participant: free,
        trials: trials.length,
        seed,
        simulated,
      });
      const movements = await this.#whole.desk.run((worker) => worker.movements(text));
      this.#texts.set(participation.key, text);
      await this.#kindly(() => this.#shelf?.begin(participation, text));
      this.#kept = [{ ...participation, rows: [] }, ...this.#kept];
      await this.#hold(participation.key);
      this.#sit(participation.key, info, stepsOf(info, trials, 0), movements);
    });
  }

  /** A participant takes the experiment up again, with the study as it was. */
  resume(key: string): Promise<void> {
    return this.#next(async () => {
      if (this.#sitting) return;
      if (!(await this.#hold(key))) throw new Error("Another tab of this browser goes on with it.");
      // Another tab may have gone on meanwhile.
      const now = (await this.#shelf?.all())?.find((kept) => kept.key === key);
      if (now && !this.#unkept) this.#replace(now);
      const participation = this.#kept.find((kept) => kept.key === key);
      if (!participation || isComplete(participation)) {
        this.#release();
        return;
      }
      const { seed } = participation;
      const text = this.#texts.get(key) ?? (await this.#shelf?.study(key));
      try {
        if (typeof text !== "string")
          throw new Error("The study that it belongs to is not on this machine any more.");
        const { info } = await this.#whole.desk.run((worker) => worker.openStudy(text));
        const trials = await this.#whole.desk.run((worker) => worker.drawTrials(text, seed));
        const movements = await this.#whole.desk.run((worker) => worker.movements(text));
        this.#sit(key, info, stepsOf(info, trials, answered(participation)), movements);
      } catch (problem) {
        this.#release();
        throw problem;
      }
    });
  }

  /** Keeps a row of the participant who is answering; it is on disk when this is kept. */
  async keep(row: Row): Promise<void> {
    const { participation } = this.#sitting ?? {};
    if (!participation) return;
    const place = participation.rows.length;
    const placed = { ...row, trial_index: place };
    this.#replace({ ...participation, rows: [...participation.rows, placed] });
    await this.#kindly(() => this.#shelf?.add(participation.key, place, placed));
  }

  /** The participant has left, or has answered all. */
  stand(): void {
    this.#sitting = null;
    this.#release();
    this.changed();
  }

  async forget(key: string): Promise<void> {
    await this.#kindly(() => this.#shelf?.forget(key));
    this.#texts.delete(key);
    this.#kept = this.#kept.filter((kept) => kept.key !== key);
    this.changed();
  }

  /** All that was kept is gone; who is answering now goes on. */
  forgotten(): void {
    this.#kept = this.#kept.filter(({ key }) => key === this.#sitting?.participation.key);
    this.changed();
  }

  /** Whether no other tab has the participation; it is held until it is released. */
  async #hold(key: string): Promise<boolean> {
    if (!this.#shelf) return true;
    this.#held = await this.#shelf.hold(key);
    return this.#held !== null;
  }

  #release(): void {
    this.#held?.();
    this.#held = null;
  }

  #sit(key: string, study: StudyInfo, steps: readonly Step[], movements: readonly Float32Array[]): void {
    const participation = this.#kept.find((kept) => kept.key === key);
    if (!participation) return;
    const columns = columnsOf(participation, sittings(participation) + 1);
    this.#sitting = { participation, study, steps, columns, movements };
  }

  #replace(participation: KeptParticipation): void {
    this.#kept = this.#kept.map((kept) => (kept.key === participation.key ? participation : kept));
    if (this.#sitting) this.#sitting = { ...this.#sitting, participation };
    this.changed();
  }

  /** Answers that cannot be kept are no reason to end an experiment: they can still be saved. */
  async #kindly(keeping: () => Promise<void> | undefined): Promise<void> {
    try {
      await keeping();
      this.#unkept = "";
    } catch (problem) {
      this.#unkept = messageOf(problem);
    }
  }

  #next(work: () => Promise<void>): Promise<void> {
    const done = this.#changing.then(async () => {
      [this.#busy, this.#problem] = [true, ""];
      this.changed();
      try {
        await work();
      } catch (problem) {
        this.#problem = messageOf(problem);
      }
      this.#busy = false;
      this.changed();
    });
    this.#changing = done;
    return done;
  }
}
