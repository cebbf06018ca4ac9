// The settings in the address of the page, so that a link brings them back.
import { Store } from "../ui/store";
import { type Settings, writeSettings } from "./settings";

/** Milliseconds. Browsers limit the history writes in a second; a slider would make more. */
const BETWEEN_WRITES = 300;

/** The part of the browser that holds the address. */
export interface AddressBar {
  /** With or without "#". */
  read(): string;
  write(fragment: string): void;
  /** Begins a new entry of the browser's history. */
  push(): void;
}

export const browserAddressBar: AddressBar = {
  read: () => location.hash,
  write(fragment) {
    history.replaceState(
      history.state,
      "",
      `${location.pathname}${location.search}${fragment ? `#${fragment}` : ""}`,
    );
  },
  push: () => history.pushState(null, ""),
};

/** Writes settings to the address after their changes, at most every 300 ms. Listeners hear of each write. */
export class Address extends Store {
  #waiting: Settings | null = null;
  #written = -Infinity;
  #fragment: string;
  /** What the bar had after the last reading or writing. */
  #seen: string;

  constructor(private readonly bar: AddressBar) {
    super();
    this.#fragment = this.#seen = bar.read();
  }

  /** The fragment that was read or written last. */
  get fragment(): string {
    return this.#fragment;
  }

  read(): string {
    this.#waiting = null;
    this.#fragment = this.#seen = this.bar.read();
    return this.#fragment;
  }

  /** Writes after the caller has returned: the request to the model goes first. */
  writeSoon(settings: Settings): void {
    const scheduled = this.#waiting !== null;
    this.#waiting = settings;
    if (scheduled) return;
    // After Back, or a link, the page hears of the new entry a little later: its address stays.
    const write = () => void (this.bar.read() === this.#seen && this.#write());
    setTimeout(write, Math.max(0, this.#written + BETWEEN_WRITES - performance.now()));
  }

  /**
   * Begins a history entry with these settings and writes it at once. The previous entry keeps its address.
   */
  push(settings: Settings): void {
    this.#write();
    this.bar.push();
    this.#waiting = settings;
    this.#write();
  }

  #write(): void {
    if (this.#waiting === null) return;
    this.#fragment = writeSettings(this.#waiting);
    this.#waiting = null;
    this.#written = performance.now();
    this.bar.write(this.#fragment);
    this.#seen = this.bar.read();
    this.changed();
  }
}
