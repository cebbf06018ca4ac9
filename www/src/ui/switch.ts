import { Store } from "./store";

/** Something that is on or off. */
export class Switch extends Store {
  #isOn = false;

  get isOn(): boolean {
    return this.#isOn;
  }

  turn(on: boolean): void {
    if (on === this.#isOn) return;
    this.#isOn = on;
    this.changed();
  }
}
