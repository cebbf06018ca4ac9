// The settings now, and the address of the page in step with them.
import { Store } from "../ui/store";
import { Address, type AddressBar } from "./address";
import { limited, readSettings, type Settings } from "./settings";

export class SettingsStore extends Store {
  #values: Settings;
  readonly address: Address;

  constructor(bar: AddressBar) {
    super();
    this.address = new Address(bar);
    this.#values = readSettings(this.address.fragment);
  }

  get values(): Readonly<Settings> {
    return this.#values;
  }

  /**
   * Changes settings, each within its limits; a value that is not valid leaves its setting as it was. Another view is another page to whoever
   * presses Back, and so is what `turnsPage`.
   */
  change(change: Partial<Settings>, turnsPage = false): void {
    const next = { ...this.#values, ...limited(change) };
    const isOther = turnsPage || next.view !== this.#values.view;
    this.#values = next;
    if (isOther) this.address.push(next);
    else this.address.writeSoon(next);
    this.changed();
  }

  /** Takes over what another address says. */
  takeFragment(fragment: string): void {
    this.#values = readSettings(fragment);
    this.address.writeSoon(this.#values);
    this.changed();
  }

  /** Takes over what the address says, after a visitor has followed a link or pressed Back. */
  readAddress(): void {
    this.#values = readSettings(this.address.read());
    this.changed();
  }
}
