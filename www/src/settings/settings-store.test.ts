import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeAddressBar } from "./address.fake";
import { SettingsStore } from "./settings-store";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

it("changes settings within their limits, and calls its listeners", () => {
  const settings = new SettingsStore(new FakeAddressBar("#latent=2"));
  const listener = vi.fn();
  settings.on(listener);
  settings.change({ latent: 900, order: Number.NaN });
  expect([settings.values.latent, settings.values.order]).toEqual([6, 2]);
  expect(listener).toHaveBeenCalledTimes(1);
});

it("keeps couplings exactly, and writes them rounded to the address, after the change and at most every 300 ms", () => {
  const bar = new FakeAddressBar();
  const settings = new SettingsStore(bar);
  for (let i = 1; i <= 61; i++) {
    settings.change({ alpha: { "0.1": 1.23456789 * i } });
    vi.advanceTimersByTime(10);
  }
  expect(settings.values.alpha).toEqual({ "0.1": 1.23456789 * 61 });
  expect(bar.writes).toBe(3);
  vi.advanceTimersByTime(300);
  expect(bar.pages).toEqual(["alpha=0.1:75.31"]);
  settings.change({ alpha: { "0.1": 2 } });
  expect(bar.writes).toBe(4);
  vi.advanceTimersByTime(300);
  expect(bar.writes).toBe(5);
});

it("begins a history entry for another view, and the previous entry keeps its address", () => {
  const bar = new FakeAddressBar("latent=2");
  const settings = new SettingsStore(bar);
  settings.change({ order: 3 });
  settings.change({ view: "compare" });
  // The visitor may press Back before the next write.
  expect(bar.pages).toEqual(["latent=2&order=3", "view=compare&latent=2&order=3"]);
  vi.advanceTimersByTime(300);
  expect(bar.pages).toEqual(["latent=2&order=3", "view=compare&latent=2&order=3"]);
});

it("follows the address, and drops the write that waits", () => {
  const bar = new FakeAddressBar("latent=2");
  const settings = new SettingsStore(bar);
  settings.change({ latent: 4 });
  bar.pages.push("latent=1&seed=5");
  // The browser says later that the visitor has followed a link.
  vi.advanceTimersByTime(300);
  settings.readAddress();
  vi.advanceTimersByTime(300);
  expect([settings.values.latent, settings.values.seed]).toEqual([1, 5]);
  expect(bar.read()).toBe("latent=1&seed=5");
});

it("begins a history entry for each chapter, and keeps the settings of the Lab for the way back", () => {
  const bar = new FakeAddressBar("latent=2");
  const settings = new SettingsStore(bar);
  settings.change({ chapter: 1 });
  settings.change({ chapter: 2 });
  expect(bar.pages).toEqual(["latent=2", "story=1", "story=2"]);
  expect(settings.labFragment).toBe("latent=2");
  bar.pages.pop();
  settings.readAddress();
  expect([settings.values.chapter, settings.values.latent]).toEqual([1, 2]);
  settings.change({ chapter: 0 });
  expect(bar.read()).toBe("latent=2");
});
