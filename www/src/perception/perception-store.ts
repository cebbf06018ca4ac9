// The graphics Turing test of this visit: the study, the participations on this machine, and the active one.
import type { WholeWorkers } from "../engine/whole-workers";
import type { StudyChange, StudyInfo, StudyView } from "../engine/whole-protocol";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { mayLose, type Work } from "../unsaved/unsaved";
import {
  type AnswerDatabase,
  answered,
  columnsOf,
  isComplete,
  type StoredParticipation,
  freeName,
  newName,
  newParticipation,
  newSeed,
  type Row,
  sessionCount,
} from "./participation";
import { perceptionWords } from "./view-words";
import { codesOf } from "./class-code";
import { type Step, stepsOf, trialColumns } from "./steps";

/** The participant who answers now. */
export interface ActiveParticipation {
  participation: StoredParticipation;
  study: StudyInfo;
  steps: readonly Step[];
  columns: Row;
  /** Positions of the figure's nodes in each movement [frames x nodes x 3]. */
  movements: readonly Float32Array[];
}

export class PerceptionStore extends Store {
  #study: StudyView | null = null;
  /** The text of the study that is on the visitor's disk; empty: the study was made here. */
  #onDisk = "";
  #participations: readonly StoredParticipation[] = [];
  /** The studies of this visit's participants, by the keys of the participations. */
  readonly #texts = new Map<string, string>();
  #active: ActiveParticipation | null = null;
  /** Gives the active participation back to all tabs. */
  #unlock: (() => void) | null = null;
  #busy = false;
  #problem = "";
  #storageProblem = "";
  /** One change follows the other. */
  #changing: Promise<void> = Promise.resolve();

  /** Without a database the answers end with the visit. */
  constructor(
    private readonly whole: WholeWorkers,
    private readonly database: AnswerDatabase | null,
    private readonly studyOfThePage: () => Promise<string>,
  ) {
    super();
  }

  get study(): StudyView | null {
    return this.#study;
  }

  /** All participations on this machine, the newest first. */
  get participations(): readonly StoredParticipation[] {
    return this.#participations;
  }

  get active(): ActiveParticipation | null {
    return this.#active;
  }

  /** Whether a study or its movements are being read. */
  get busy(): boolean {
    return this.#busy;
  }

  /** Why a study could not be opened or changed, or why an experiment could not begin. */
  get problem(): string {
    return this.#problem;
  }

  /** Why answers are not stored beyond this visit; empty when they are. */
  get storageProblem(): string {
    return this.database === null ? perceptionWords().participants.keepsNothing : this.#storageProblem;
  }

  /** Adds the participations of earlier visits. */
  async loadStored(): Promise<void> {
    this.#add((await this.database?.all()) ?? []);
  }

  /** Waits until a study is open; when there is no other, opens the one that comes with the page. */
  ready(): Promise<void> {
    return this.#inTurn(async () => {
      if (!this.#study) await this.#open(this.studyOfThePage);
    });
  }

  /** `made`: the study was made here and is on no disk. The visitor may keep the open one instead. */
  openStudy(text: () => Promise<string>, made = false): Promise<void> {
    return this.#inTurn(() => this.#open(text, made));
  }

  async #open(text: () => Promise<string>, made = false): Promise<void> {
    const opened = await text();
    const study = await this.whole.desk.run((worker) => worker.openStudy(opened));
    if (!(await mayLose(this.unsaved))) return;
    this.#study = study;
    this.#onDisk = made ? "" : study.text;
  }

  /** The study, if it was made or changed here and not saved since. */
  get unsaved(): Work | null {
    const study = this.#study;
    if (!study || study.text === this.#onDisk) return null;
    return {
      what: perceptionWords().study.unsaved(study.info.title),
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
    return this.#inTurn(async () => {
      const { text } = this.#study ?? {};
      if (text !== undefined)
        this.#study = await this.whole.desk.run((worker) => worker.changeStudy(text, change));
    });
  }

  /** Positions of the figure's nodes in each movement of the open study [frames x nodes x 3]. */
  async movements(): Promise<readonly Float32Array[]> {
    const { text } = this.#study ?? {};
    return text === undefined ? [] : this.whole.desk.run((worker) => worker.movements(text));
  }

  /** Begins the experiment with a new participant. */
  begin(name: string, simulated: boolean): Promise<void> {
    return this.#inTurn(async () => {
      const { text, info } = this.#study ?? {};
      if (text === undefined || !info || this.#active) return;
      const seed = newSeed();
      const trials = await this.whole.desk.run((worker) => worker.drawTrials(text, seed));
      const free = freeName(
        name.trim() || newName(),
        new Set(this.#participations.map(({ participant }) => participant)),
      );
      const participation = newParticipation(info, {
        participant: free,
        trials: trials.length,
        seed,
        simulated,
      });
      const movements = await this.whole.desk.run((worker) => worker.movements(text));
      this.#texts.set(participation.key, text);
      await this.#tryToStore(() => this.database?.begin(participation, text));
      this.#participations = [{ ...participation, rows: [] }, ...this.#participations];
      await this.#lock(participation.key);
      this.#activate(participation.key, info, stepsOf(info, trials, 0), movements);
    });
  }

  /** A participant continues the experiment, with the study as it was. */
  resume(key: string): Promise<void> {
    return this.#inTurn(async () => {
      if (this.#active) return;
      if (!(await this.#lock(key))) throw new Error(perceptionWords().run.otherTab);
      // Another tab may have added answers meanwhile.
      const now = (await this.database?.all())?.find((other) => other.key === key);
      if (now && !this.#storageProblem) this.#replace(now);
      const participation = this.#participations.find((other) => other.key === key);
      if (!participation || isComplete(participation)) {
        this.#release();
        return;
      }
      const { seed } = participation;
      const text = this.#texts.get(key) ?? (await this.database?.study(key));
      try {
        if (typeof text !== "string") throw new Error(perceptionWords().run.noStudy);
        const { info } = await this.whole.desk.run((worker) => worker.openStudy(text));
        const trials = await this.whole.desk.run((worker) => worker.drawTrials(text, seed));
        const movements = await this.whole.desk.run((worker) => worker.movements(text));
        this.#activate(key, info, stepsOf(info, trials, answered(participation)), movements);
      } catch (problem) {
        this.#release();
        throw problem;
      }
    });
  }

  /**
   * The answers of a class to the open study, from codes, one in each line. A code that comes twice counts once.
   * Throws with the line of a code that cannot be read.
   */
  async fromCodes(text: string): Promise<StoredParticipation[]> {
    const { study } = this;
    if (!study) throw new Error(perceptionWords().study.none);
    const { info } = study;
    const coded = codesOf(info.hash, text);
    const trials = await this.whole.desk.run((worker) =>
      Promise.all(coded.map(({ seed }) => worker.drawTrials(study.text, seed))),
    );
    return coded.map(({ seed, simulated, answers }, i) => {
      const drawn = trials[i] ?? [];
      const participation = newParticipation(info, {
        participant: `code-${seed.toString(36)}`,
        trials: drawn.length,
        seed,
        simulated,
      });
      const columns = columnsOf(participation, 1);
      const rows = drawn.slice(0, answers.length).map((trial, position) => ({
        ...columns,
        ...trialColumns(info, { position, trial }),
        response: answers[position],
        trial_index: position,
      }));
      return { ...participation, rows };
    });
  }

  /** Adds a row of the active participant. Ends when the row is stored. */
  async addRow(row: Row): Promise<void> {
    const { participation } = this.#active ?? {};
    if (!participation) return;
    const place = participation.rows.length;
    const placed = { ...row, trial_index: place };
    this.#replace({ ...participation, rows: [...participation.rows, placed] });
    await this.#tryToStore(() => this.database?.add(participation.key, place, placed));
  }

  /** The participant has answered everything or has left. */
  leave(): void {
    this.#active = null;
    this.#release();
    this.changed();
  }

  async forget(key: string): Promise<void> {
    await this.#tryToStore(() => this.database?.forget(key));
    this.#texts.delete(key);
    this.#participations = this.#participations.filter((other) => other.key !== key);
    this.changed();
  }

  /** The database was emptied, except for the active participation. The result lists the others again. */
  dropStored(): () => void {
    const isActive = ({ key }: StoredParticipation) => key === this.#active?.participation.key;
    const dropped = this.#participations.filter((participation) => !isActive(participation));
    this.#participations = this.#participations.filter(isActive);
    this.changed();
    return () => this.#add(dropped);
  }

  #add(added: readonly StoredParticipation[]): void {
    const present = new Set(this.#participations.map(({ key }) => key));
    this.#participations = [...this.#participations, ...added.filter(({ key }) => !present.has(key))].sort(
      (a, b) => b.at - a.at,
    );
    this.changed();
  }

  /** Takes the participation for this tab; false: another tab has it. */
  async #lock(key: string): Promise<boolean> {
    if (!this.database) return true;
    this.#unlock = await this.database.hold(key);
    return this.#unlock !== null;
  }

  #release(): void {
    this.#unlock?.();
    this.#unlock = null;
  }

  #activate(key: string, study: StudyInfo, steps: readonly Step[], movements: readonly Float32Array[]): void {
    const participation = this.#participations.find((other) => other.key === key);
    if (!participation) return;
    const columns = columnsOf(participation, sessionCount(participation) + 1);
    this.#active = { participation, study, steps, columns, movements };
  }

  #replace(participation: StoredParticipation): void {
    this.#participations = this.#participations.map((other) =>
      other.key === participation.key ? participation : other,
    );
    if (this.#active) this.#active = { ...this.#active, participation };
    this.changed();
  }

  /** Answers that cannot be stored do not end an experiment: the visitor can still save them. */
  async #tryToStore(write: () => Promise<void> | undefined): Promise<void> {
    try {
      await write();
      this.#storageProblem = "";
    } catch (problem) {
      this.#storageProblem = messageOf(problem);
    }
  }

  #inTurn(work: () => Promise<void>): Promise<void> {
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
