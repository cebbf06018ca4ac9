// The settings, which the address of the page follows.
import { Store } from "../ui/store";
import { Address, type AddressBar } from "./address";
import { limited, readSettings, type Settings, writeSettings } from "./settings";

/** A change of one of these begins an entry in the browser's history. */
const PAGES = ["view", "chapter", "teach"] as const;

/** The settings of an address in the Lab. */
export const IN_LAB = { chapter: 0, teach: false, cut: "" } as const satisfies Partial<Settings>;

export class SettingsStore extends Store {
  #values: Settings;
  #waiting: Partial<Settings> = {};
  readonly address: Address;

  constructor(bar: AddressBar) {
    super();
    this.address = new Address(bar);
    this.#values = readSettings(this.address.fragment);
  }

  get values(): Readonly<Settings> {
    return this.#values;
  }

  /** The settings for an address: those of a link that still wait replace the present ones. */
  get written(): Readonly<Settings> {
    return { ...this.#values, ...this.#waiting };
  }

  /** The address of the Lab or another view with these settings, also while a chapter is open. */
  get labFragment(): string {
    return writeSettings({ ...this.written, ...IN_LAB });
  }

  /** Whether the address brings a model: in itself, or in a file of the page's host. */
  get bringsModel(): boolean {
    return this.#values.modelFile !== "" || this.#values.packedModel !== "";
  }

  /** Whether the browser's address brings a model, and another one than these settings. */
  bringsOtherModel(): boolean {
    const { modelFile, packedModel } = readSettings(this.address.read());
    const isSame = modelFile === this.#values.modelFile && packedModel === this.#values.packedModel;
    return !isSame && (modelFile !== "" || packedModel !== "");
  }

  /** Keeps settings of a link in the address that do not apply yet; `{}`: there are none. */
  holdBack(waiting: Partial<Settings>): void {
    this.#waiting = waiting;
    this.address.writeSoon(this.written);
  }

  /**
   * Changes settings within their limits; an invalid value leaves its setting as it was. A change of the view
   * or the chapter begins a history entry, and so does `turnsPage`.
   */
  change(change: Partial<Settings>, turnsPage = false): void {
    const next = { ...this.#values, ...limited(change) };
    const isOther = turnsPage || PAGES.some((name) => next[name] !== this.#values[name]);
    this.#values = next;
    if (isOther) this.address.push(this.written);
    else this.address.writeSoon(this.written);
    this.changed();
  }

  /** Takes the settings of another address. */
  takeFragment(fragment: string): void {
    this.#take(fragment);
    this.address.writeSoon(this.#values);
    this.changed();
  }

  /** Takes the settings of the address, after the visitor has followed a link or pressed Back. */
  readAddress(): void {
    this.#take(this.address.read());
    this.changed();
  }

  #take(fragment: string): void {
    const read = readSettings(fragment);
    const { chapter, teach, camera, time, cut } = read;
    // These addresses do not have the settings of the Lab, which waits as it is.
    if (chapter > 0 || teach) {
      this.#values = { ...this.#values, chapter: teach ? 0 : chapter, teach, camera, time, cut };
      return;
    }
    this.#values = read;
    this.#waiting = {};
  }
}
