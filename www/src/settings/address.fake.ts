// For tests: an address bar without a browser.
import type { AddressBar } from "./address";

export class FakeAddressBar implements AddressBar {
  /** The fragments of the history; the last is the current one. */
  readonly pages: string[];
  /** How often an address was written. */
  writes = 0;

  constructor(fragment = "") {
    this.pages = [fragment];
  }

  read(): string {
    return this.pages.at(-1) ?? "";
  }

  write(fragment: string): void {
    this.writes += 1;
    this.pages.splice(-1, 1, fragment);
  }

  push(): void {
    this.pages.push(this.read());
  }
}
