// Stores the work of a visit in the browser. A later visit can bring it back when the visitor asks for it.
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { contentsText, type Counts, countsOf, type Holdings, RecordWriter, sumOf } from "./records";
import { type Recovered, recover } from "./recovery";
import type { VisitDatabase } from "./visit-database";
import { sessionWords } from "../words/sections";

/** Milliseconds between two writes: a crash loses no more. */
const BETWEEN_WRITES = 4000;

const NOTHING: Counts = { clips: 0, runs: 0, models: 0, results: 0, libraries: 0 };

/** The page as the session sees it. */
export interface Visit {
  holdings(): Holdings;
  /**
   * Takes up all pieces that it can, and returns a sentence for each other one. A refusal fails before that.
   */
  takeUp(holdings: Holdings): Promise<string[]>;
  showError(title: string, text: string): void;
}

/** Which tab has which visit. */
export interface VisitLocks {
  /** Whether tabs know of each other; without that, another tab may still be in any stored visit. */
  readonly tellTabsApart: boolean;
  /** Gives this tab the visit until the returned function is called; null: another tab has it. */
  hold(visit: string): Promise<(() => void) | null>;
  /** The visits that a tab has, this one included. */
  heldVisits(): Promise<readonly string[]>;
  /** Lets the other tabs know that visits were taken or removed. */
  announce(): void;
  listen(changed: () => void): void;
}

/** What an earlier visit left. */
export interface Offer extends Omit<Recovered, "holdings"> {
  visit: string;
  /** Another tab has it. */
  taken: boolean;
}

export class SessionStore extends Store {
  readonly #records = new RecordWriter();
  #left: readonly Offer[] = [];
  /** The visits that this tab has brought back. */
  readonly #broughtBack = new Set<string>();
  #busy = false;
  #timer: ReturnType<typeof setTimeout> | null = null;
  /** One write follows the other. */
  #writing: Promise<void> = Promise.resolve();
  /** So does one change of the list of visits. */
  #turn: Promise<unknown> = Promise.resolve();
  #refused = false;
  #forgets = false;

  constructor(
    private readonly visit: Visit,
    private readonly database: VisitDatabase,
    private readonly locks: VisitLocks,
    private readonly name: string,
  ) {
    super();
  }

  /** The earlier visits that can be brought back, the newest first. */
  get offers(): readonly Offer[] {
    return this.#left.filter(({ contents }) => contents !== "");
  }

  /** How many earlier visits cannot be read at all. */
  get unreadable(): number {
    return this.#left.length - this.offers.length;
  }

  /** Whether the browser stores what this visit holds. */
  get keeps(): boolean {
    return !this.#refused && !this.#forgets;
  }

  /** What "Forget everything" would remove, and how many earlier visits are part of it. */
  get forgettable(): { contents: string; earlierVisits: number } {
    const earlier = this.#left.filter(({ taken }) => !taken);
    const counts = [countsOf(this.visit.holdings()), ...earlier.map(({ counts }) => counts)];
    return { contents: contentsText(sumOf(counts)), earlierVisits: earlier.length };
  }

  get busy(): boolean {
    return this.#busy;
  }

  /** Looks for visits that were left. */
  async begin(): Promise<void> {
    await this.locks.hold(this.name);
    await this.#inTurn(() => this.#look());
    this.locks.listen(() => void this.#inTurn(() => this.#look()).catch(() => {}));
  }

  #inTurn<Result>(work: () => Promise<Result>): Promise<Result> {
    const result = this.#turn.then(work);
    this.#turn = result.catch(() => {});
    return result;
  }

  async #look(): Promise<void> {
    const stored = await this.database.visits();
    // Asked after the database: a visit of another tab has its lock before its first record.
    const held = await this.locks.heldVisits();
    const before = new Map(this.#left.map((offer) => [offer.visit, offer]));
    const left: Offer[] = [];
    for (const visit of new Set([...before.keys(), ...stored])) {
      const offered = before.get(visit);
      if (visit === this.name || this.#broughtBack.has(visit)) continue;
      if (held.includes(visit)) {
        if (offered) left.push({ ...offered, taken: true });
      } else if (stored.includes(visit)) {
        left.push({ ...(offered ?? (await this.#read(visit))), taken: false });
      }
    }
    const isEmpty = ({ contents, whole }: Offer) => contents === "" && whole;
    if (this.locks.tellTabsApart) for (const offer of left) if (isEmpty(offer)) await this.#remove(offer);
    this.#left = left.filter((offer) => !isEmpty(offer)).sort((a, b) => (b.at ?? 0) - (a.at ?? 0));
    this.changed();
  }

  async #read(visit: string): Promise<Offer> {
    try {
      const { at, contents, counts, whole } = recover(await this.database.read(visit, false));
      return { visit, at, contents, counts, whole, taken: false };
    } catch {
      return { visit, at: null, contents: "", counts: NOTHING, whole: false, taken: false };
    }
  }

  /** Schedules a write: something that is stored has changed. */
  touched(): void {
    if (!this.#forgets) this.#timer ??= setTimeout(() => void this.keepNow(), BETWEEN_WRITES);
  }

  /** Writes what has changed since the last time. */
  keepNow(): Promise<void> {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    this.#writing = this.#writing.then(() => this.#write());
    return this.#writing;
  }

  async #write(): Promise<void> {
    if (this.#forgets) return;
    try {
      const changes = this.#records.changes(this.visit.holdings(), Date.now());
      if (!changes) return;
      await this.database.write(this.name, changes);
      this.#records.wereWritten();
      this.#refused = false;
    } catch (problem) {
      // Once, not every few seconds.
      if (this.#refused) return;
      this.#refused = true;
      this.visit.showError(sessionWords().notKept, sessionWords().notKeptWhy(storageProblem(problem)));
    }
  }

  /** Takes up an earlier visit, which stays stored until this visit has stored all of it. */
  async bringBack(offer: Offer): Promise<void> {
    if (this.#busy) return;
    this.#busy = true;
    this.changed();
    try {
      await this.#inTurn(() => this.#bringBack(offer));
    } catch (problem) {
      this.visit.showError(sessionWords().notBroughtBack, messageOf(problem));
    }
    this.#busy = false;
    this.changed();
  }

  async #bringBack(offer: Offer): Promise<void> {
    const { visit } = offer;
    const release = await this.locks.hold(visit);
    if (!release) return this.#markTaken(visit);
    try {
      this.locks.announce();
      const { contents, holdings, whole } = recover(await this.database.read(visit, true));
      if (contents === "") {
        this.#drop(visit);
        throw new Error(sessionWords().otherTab);
      }
      const problems = await this.visit.takeUp(holdings);
      this.#broughtBack.add(visit);
      this.#drop(visit);
      await this.keepNow();
      if (problems.length > 0) this.visit.showError(sessionWords().notAllBroughtBack, problems.join(" "));
      const isStoredAgain = this.keeps && whole && problems.length === 0;
      if (isStoredAgain && this.locks.tellTabsApart) await this.database.forget(visit);
    } catch (problem) {
      if (!this.#broughtBack.has(visit)) release();
      throw problem;
    } finally {
      this.locks.announce();
    }
  }

  #markTaken(visit: string): void {
    this.#left = this.#left.map((offer) => (offer.visit === visit ? { ...offer, taken: true } : offer));
  }

  #drop(visit: string): void {
    this.#left = this.#left.filter((offer) => offer.visit !== visit);
  }

  /** Removes what one earlier visit left, and nothing else. */
  async forget(offer: Offer): Promise<void> {
    await this.#inTurn(() => this.#remove(offer));
    this.changed();
  }

  /** Removes the earlier visits of which nothing can be read. */
  async forgetUnreadable(): Promise<void> {
    await this.#inTurn(async () => {
      for (const offer of this.#left) if (offer.contents === "") await this.#remove(offer);
    });
    this.changed();
  }

  async #remove({ visit }: Offer): Promise<void> {
    const release = await this.locks.hold(visit);
    if (!release) return this.#markTaken(visit);
    await this.database.forget(visit);
    this.#drop(visit);
    release();
    this.locks.announce();
  }

  /**
   * Removes everything that this browser stores of visits, but those of other tabs. Nothing of this visit is
   * stored from now on. The result brings all of it back: the records are in memory until the page is left.
   */
  async forgetAll(): Promise<() => Promise<void>> {
    this.#forgets = true;
    await this.#writing;
    const own = [this.name, ...this.#broughtBack];
    const others = (await this.locks.heldVisits()).filter((visit) => !own.includes(visit));
    const removed = await this.database.forgetAllBut(others).catch((problem: unknown) => {
      this.#forgets = false;
      throw problem;
    });
    this.#left = [];
    this.locks.announce();
    this.changed();
    return async () => {
      await this.database.restore(removed);
      this.#forgets = false;
      this.locks.announce();
      await this.#inTurn(() => this.#look());
      this.touched();
    };
  }
}

/** The browser's own message is often empty. */
function storageProblem(problem: unknown): string {
  const { name } = problem as { name?: unknown };
  if (name === "QuotaExceededError") return sessionWords().full;
  return messageOf(problem).replace(/\.$/, "") || String(name);
}
