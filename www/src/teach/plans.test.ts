import { expect, it } from "vitest";
import { words } from "../words/en";
import { words as teach } from "../words/en/teach";
import { ORDER } from "../settings/chapters";
import { PLANS, timesOf } from "./plans";

for (const length of [45, 90] as const)
  it(`fills ${length} minutes, with chapters in their order`, () => {
    const times = timesOf(length);
    expect(times.at(-1)?.to).toBe(length);
    expect(times.every(({ from, to }) => to > from)).toBe(true);
    const places = times.map(({ step }) => (ORDER as readonly string[]).indexOf(step));
    const chapters = places.filter((place) => place >= 0);
    expect(chapters).toEqual([...chapters].sort((a, b) => a - b));
  });

it("has words for each chapter and each step of a plan", () => {
  const steps = [
    ...Object.keys(words.chapters),
    ...Object.values(PLANS).flatMap((plan) => plan.map(([step]) => step)),
  ];
  expect(steps.filter((step) => !(step in teach.steps))).toEqual([]);
});
