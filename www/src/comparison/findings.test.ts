import { expect, it } from "vitest";
import { correlationFinding, errorFinding, foldWords, growthFinding, rankWords } from "./findings";
import { bestOf, isSkewed, type Measure, MEASURES, scaleOf } from "./measures";
import type { Correlation, ModelSummary } from "../engine/whole-protocol";

const correlation = (rank: number, settings = 5): Correlation => ({
  model: "vcgpdm",
  label: "",
  rank,
  settings,
  folds: 3,
  interval: null,
  points: [],
});
const spread = (mean: number, standardError: number | null = null) => ({ mean, standardError, count: 3 });
const summary = (mse: number, error: number, bound: number | null, folds = 3): ModelSummary => ({
  model: "tmp",
  candidate: { model: "tmp", primitives: null },
  label: "",
  mse: spread(mse, error),
  mseMedian: mse,
  trainingMse: null,
  variance: 0.03,
  bound: bound === null ? null : spread(bound),
  seconds: spread(1),
  storedNumbers: spread(10),
  converged: null,
  terms: null,
  partErrors: [],
  details: null,
  folds,
  runs: folds,
  standsFor: 1,
});
const [ERROR, BOUND] = MEASURES as [Measure, Measure];

it("writes a rank correlation", () => {
  expect(correlationFinding(correlation(-0.9))).toBe(
    "vCGPDM, error against bound: rank correlation −0.90 over 5 settings; a higher bound goes with a smaller error.",
  );
  expect(correlationFinding(correlation(0.8))).toContain("larger error");
  expect(correlationFinding(correlation(-0.2))).toContain("says little");
});

it("writes nothing for an undefined rank correlation", () => {
  expect(rankWords(correlation(1, 1))).toBe("no rank correlation over 1 setting");
  expect(rankWords(correlation(1, 4))).toBe("no rank correlation over 4 settings");
  expect(correlationFinding(correlation(Number.NaN))).toContain(
    "no rank correlation over 5 settings; too few",
  );
});

it("writes the growth of time", () => {
  const unknown = { interval: null, trainingExponent: null, trainingInterval: null, converged: null };
  const line = { label: "", points: [], ...unknown };
  expect(
    growthFinding([
      { ...line, model: "vgpdm", exponent: 1.014 },
      { ...line, model: "tmp", exponent: null },
    ]),
  ).toContain("vGPDM, exponent 1.01; TMP, no exponent.");
});

it("writes the number of trials of the means", () => {
  expect(foldWords([summary(1, 1, 1, 1)])).toMatch(/^One trial/);
  expect(foldWords([summary(1, 1, 1, 4), summary(1, 1, 1, 10)])).toContain("over 4 to 10 trials");
});

it("takes the least error and the greatest bound for the best, of the known ones", () => {
  const models = [summary(0.002, 0, null), summary(0.001, 0, 20), summary(Number.NaN, 0, 30)];
  expect(bestOf(ERROR, models)).toBe(0.001);
  expect(bestOf(BOUND, models.slice(0, 2))).toBeNull();
});

it("calls no error the best that differs from the next by less than their standard errors", () => {
  const close = [summary(0.00073, 0.0003, null), summary(0.00074, 0.00026, null)];
  expect(bestOf(ERROR, close)).toBeNull();
  expect(errorFinding(close)).toMatch(
    /^Which model has the lowest error here is undecided: TMP and TMP differ/,
  );
  const oneTrial = [summary(0.001, 0, null), summary(0.002, 0, null)].map((model) => ({
    ...model,
    mse: spread(model.mse.mean),
  }));
  expect(bestOf(ERROR, oneTrial)).toBeNull();
});

it("says that the model of the page loses here", () => {
  const own = { ...summary(0.00133, 0.0001, null), model: "vcgpdm" as const, label: "12 + 12" };
  const models = [own, summary(0.00076, 0.0001, null)];
  expect(errorFinding(models)).toBe(
    "TMP has the lowest mean error here, by more than both standard errors. The error of the vCGPDM is 1.75 times the lowest.",
  );
  expect(errorFinding([{ ...own, mse: spread(0.0008, 0.0001) }, summary(0.00076, 0.0001, null)])).toMatch(
    /1\.05 times the lowest, which is undecided too\.$/,
  );
  expect(errorFinding([own])).toBe("");
});

it("shows all means when an error bar comes near zero", () => {
  const scale = scaleOf(ERROR, [summary(0.001, 0.00099999, null), summary(0.002, 0.0001, null)], 120);
  expect(scale.low).toBeGreaterThan(0.0001);
  expect(scale.high).toBeGreaterThan(0.03);
  expect([scale.at(0), scale.at(1)]).toEqual([6, 114]);
});

it("recognises when one trial makes most of the error", () => {
  expect(isSkewed(summary(1, 0.1, null))).toBe(false);
  expect(isSkewed({ ...summary(1, 0.1, null), mseMedian: 0.1 })).toBe(true);
});
