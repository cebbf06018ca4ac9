import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeAddressBar } from "./address.fake";
import { SettingsStore } from "./settings-store";
import { lastChapter, openDoor } from "./door";

let stored: Map<string, string>;
beforeEach(() => {
  stored = new Map();
  vi.stubGlobal("localStorage", {
    getItem: (name: string) => stored.get(name) ?? null,
    setItem: (name: string, value: string) => stored.set(name, value),
  });
  vi.useFakeTimers();
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

/** Opens the page at an address; the settings, and the address that the page then has. */
function opened(fragment: string, embedded = false) {
  const bar = new FakeAddressBar(fragment);
  const settings = new SettingsStore(bar);
  openDoor(settings, embedded);
  vi.runAllTimers();
  return { settings, chapter: settings.values.chapter, bar };
}

it("opens the first chapter at the first visit, without a new entry of the history", () => {
  const { chapter, bar } = opened("");
  expect(chapter).toBe(1);
  expect(bar.pages).toEqual(["story=1"]);
});

it("opens the chapter where the visitor was, and the Lab for a visitor who has chosen it", () => {
  const { settings } = opened("");
  settings.change({ chapter: 4 });
  expect(opened("").chapter).toBe(4);
  settings.change({ chapter: 0 });
  expect(opened("").chapter).toBe(0);
  expect(lastChapter()).toBe(4);
});

it("obeys an address, also that of the Lab, which is no choice for the next visit", () => {
  expect(opened("#story=3").chapter).toBe(3);
  for (const address of ["#alpha=0.1:4", "#view=play", "#model=0123abcd"])
    expect(opened(address).chapter).toBe(0);
  expect(opened("").chapter).toBe(1);
});

it("opens the Lab in a frame of another page, and keeps nothing of it", () => {
  const { settings, chapter } = opened("", true);
  expect(chapter).toBe(0);
  settings.change({ chapter: 2 });
  expect(stored.size).toBe(0);
});

it("ignores a kept chapter that is no number", () => {
  stored.set("vcgpdm chapter", "garage");
  expect(opened("").chapter).toBe(1);
});
