import { expect, it } from "vitest";
import { Tally } from "./lecture";

it("counts hands for each question, takes the last one back, and knows the favourite", () => {
  const tally = new Tally();
  expect([tally.favourite("arms"), tally.total("arms")]).toEqual([null, 0]);
  for (const answer of ["stop", "pace", "stop", "step"]) tally.add("arms", answer);
  tally.add("loop", "steps");
  expect([tally.count("arms", "stop"), tally.total("arms"), tally.favourite("arms")]).toEqual([2, 4, "stop"]);
  tally.takeBack("arms");
  expect(tally.total("arms")).toBe(3);
  tally.add("arms", "pace");
  expect(tally.favourite("arms"), "a tie").toBeNull();
  expect(tally.total("loop")).toBe(1);
  tally.takeBack("none");
  expect(tally.total("none")).toBe(0);
});
