// Notices about files and failures, until the visitor dismisses them.
import { Store } from "./store";

/** A place on the page, in pixels. */
export interface Place {
  x: number;
  y: number;
}

export interface Notice {
  id: number;
  kind: "error" | "done";
  title: string;
  text: string;
  /** Where a dropped file landed; null: in a corner of the page. */
  at: Place | null;
}

/** The most notices; older ones go first. */
const MOST = 6;

export class NoticesStore extends Store {
  #notices: readonly Notice[] = [];
  #lastId = 0;

  get all(): readonly Notice[] {
    return this.#notices;
  }

  /** A notice with the same words is replaced. */
  add(notice: Omit<Notice, "id">): void {
    this.#lastId += 1;
    const others = this.#notices.filter(({ title, text }) => title !== notice.title || text !== notice.text);
    this.#notices = [...others, { ...notice, id: this.#lastId }].slice(-MOST);
    this.changed();
  }

  /** Adds an error without a place. */
  addError(title: string, text: string): void {
    this.add({ kind: "error", title, text, at: null });
  }

  dismiss(id: number): void {
    this.#notices = this.#notices.filter((notice) => notice.id !== id);
    this.changed();
  }

  clear(): void {
    if (this.#notices.length === 0) return;
    this.#notices = [];
    this.changed();
  }
}
