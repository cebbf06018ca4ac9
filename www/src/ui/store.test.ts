import { afterEach, expect, it, vi } from "vitest";
import { Store } from "./store";

class Counter extends Store {
  tell(): void {
    this.changed();
  }
  tellSoon(): void {
    this.changedSoon();
  }
}

afterEach(() => {
  vi.useRealTimers();
});

it("a store calls its listeners until they stop listening", () => {
  const counter = new Counter();
  const heard: string[] = [];
  const stop = counter.on(() => heard.push("a"));
  counter.on(() => heard.push("b"));
  counter.tell();
  stop();
  counter.tell();
  expect(heard.join("")).toBe("abb");
});

it("a store reports quick changes once in 100 ms", () => {
  vi.useFakeTimers();
  const counter = new Counter();
  const listener = vi.fn();
  counter.on(listener);
  for (let i = 0; i < 25; i++) {
    counter.tellSoon();
    vi.advanceTimersByTime(10);
  }
  expect(listener).toHaveBeenCalledTimes(2);
  vi.advanceTimersByTime(100);
  expect(listener).toHaveBeenCalledTimes(3);
});
