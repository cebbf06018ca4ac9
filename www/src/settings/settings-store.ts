// The settings now, and the address of the page in step with them.
import { Store } from "../ui/store";
import { Address, type AddressBar } from "./address";
import { limited, readSettings, type Settings } from "./settings";

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

  /** What an address says: the settings now, and in their place those of a link that still wait. */
  get written(): Readonly<Settings> {
    return { ...this.#values, ...this.#waiting };
  }

  /**
   * Keeps settings of a link in the address that cannot hold yet; without any, the address says what holds.
   */
  holdBack(waiting: Partial<Settings>): void {
    this.#waiting = waiting;
    this.address.writeSoon(this.written);
  }

  /**
   * Changes settings, each within its limits; a value that is not valid leaves its setting as it was. Another
   * view is another page to whoever presses Back, and so is what `turnsPage`.
   */
  change(change: Partial<Settings>, turnsPage = false): void {
    const next = { ...this.#values, ...limited(change) };
    const isOther = turnsPage || next.view !== this.#values.view;
    this.#values = next;
    if (isOther) this.address.push(this.written);
    else this.address.writeSoon(this.written);
    this.changed();
  }

  /** Takes over what another address says. */
  takeFragment(fragment: string): void {
    this.#take(fragment);
    this.address.writeSoon(this.#values);
    this.changed();
  }

  /** Takes over what the address says, after a visitor has followed a link or pressed Back. */
  readAddress(): void {
    this.#take(this.address.read());
    this.changed();
  }

  #take(fragment: string): void {
    this.#values = readSettings(fragment);
    this.#waiting = {};
  }
}
