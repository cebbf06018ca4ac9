// What a visit holds is kept on this machine while it lasts; the next visit can bring it back, when the
// visitor asks for it.
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import {
  type About,
  countsInWords,
  type Holdings,
  isWorthKeeping,
  RecordWriter,
  readRecords,
} from "./records";
import type { Shelf } from "./shelf";

/** Milliseconds between two writings: what is lost in a crash is no older. */
const BETWEEN = 4000;

/** What the session has to know of the page. */
export interface Visit {
  holdings(): Holdings;
  takeUp(holdings: Holdings): Promise<void>;
  /** Says what could not be done. */
  tell(title: string, text: string): void;
}

/** Which visits are going on now, in this tab and in others. */
export interface OpenVisits {
  enter(visit: string): void;
  all(): Promise<readonly string[]>;
}

interface Offer {
  visit: string;
  about: About;
}

export class SessionStore extends Store {
  readonly #visit: Visit;
  readonly #shelf: Shelf;
  readonly #open: OpenVisits;
  readonly #name: string;
  readonly #records = new RecordWriter();
  #offer: Offer | null = null;
  #busy = false;
  #timer: ReturnType<typeof setTimeout> | null = null;
  /** Writings follow each other. */
  #writing: Promise<void> = Promise.resolve();
  #refused = false;
  #forgets = false;

  constructor(visit: Visit, shelf: Shelf, open: OpenVisits, name = `${Date.now()} ${Math.random()}`) {
    super();
    [this.#visit, this.#shelf, this.#open, this.#name] = [visit, shelf, open, name];
  }

  /** What an earlier visit has left, in words; null: nothing. */
  get offer(): { what: string; at: number } | null {
    return this.#offer && { what: countsInWords(this.#offer.about), at: this.#offer.about.at };
  }

  /** Whether the browser keeps what this visit holds. */
  get keeps(): boolean {
    return !this.#refused && !this.#forgets;
  }

  get busy(): boolean {
    return this.#busy;
  }

  /** Looks for the newest visit that was left; older ones are forgotten. */
  async begin(): Promise<void> {
    this.#open.enter(this.#name);
    const open = await this.#open.all();
    const left: Offer[] = [];
    for (const visit of await this.#shelf.visits()) {
      if (visit === this.#name || open.includes(visit)) continue;
      const about = (await this.#shelf.read(visit)).get("about") as About | undefined;
      if (about && isWorthKeeping(about)) left.push({ visit, about });
      else await this.#shelf.forget(visit);
    }
    left.sort((a, b) => b.about.at - a.about.at);
    const [newest, ...older] = left;
    for (const { visit } of older) await this.#shelf.forget(visit);
    this.#offer = newest ?? null;
    this.changed();
  }

  /** Something that is kept has changed. */
  touched(): void {
    if (!this.#forgets) this.#timer ??= setTimeout(() => void this.keepNow(), BETWEEN);
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
    const changes = this.#records.changes(this.#visit.holdings(), Date.now());
    if (!changes) return;
    try {
      await this.#shelf.write(this.#name, changes);
      this.#refused = false;
    } catch (problem) {
      this.#records.forget();
      // Once, not every few seconds.
      if (this.#refused) return;
      this.#refused = true;
      const why = messageOf(problem);
      this.#visit.tell(
        "This visit cannot be kept",
        `The browser does not store it (${why}). Save what you want to have after closing or reloading the page.`,
      );
    }
  }

  /** Takes up what the earlier visit held. It stays kept where that fails. */
  async bringBack(): Promise<void> {
    const offer = this.#offer;
    if (!offer || this.#busy) return;
    this.#busy = true;
    this.changed();
    try {
      const { holdings } = readRecords(await this.#shelf.read(offer.visit));
      await this.#visit.takeUp(holdings);
      this.#offer = null;
      await this.keepNow();
      if (!this.#refused) await this.#shelf.forget(offer.visit);
    } catch (problem) {
      this.#visit.tell("The earlier visit could not be brought back", messageOf(problem));
    }
    this.#busy = false;
    this.changed();
  }

  /** Forgets all visits that are kept, but those of other tabs; nothing of this one is kept from now on. */
  async forgetAll(): Promise<void> {
    this.#forgets = true;
    await this.#writing;
    const open = await this.#open.all();
    for (const visit of await this.#shelf.visits())
      if (visit === this.#name || !open.includes(visit)) await this.#shelf.forget(visit);
    this.#offer = null;
    this.changed();
  }
}
