// The exercises for a class, and the rules by which the page says that one is solved. No rendering.
import type { BodyReports } from "../couplings/body-store";
import { stepOf } from "../couplings/measures-text";
import type { Couplings } from "../engine/protocol";
import type { TeachWords } from "../words/sections";

/** The exercises of the Lab. That of the view *Draw* has the address of its dare. */
export type ExerciseName = Exclude<keyof TeachWords["exercises"]["tasks"], "hands">;

/** In their order: exercise N has the address `#exercise=N`. */
export const EXERCISE_NAMES: readonly ExerciseName[] = ["pace", "pose", "ratio", "idle", "halt", "few"];

/** Shares of the learned swing: at least half; as good as none; the walk goes on. */
const HALF = 0.5;
const NO_SWING = 0.1;
const WALKS_ON = 0.8;
/** A relative difference from the learned motion that counts as none. */
const SAME = 0.05;
/** Factors of a changed coupling. A slider moves in steps, so that the factor may be a little less. */
const DOUBLED = 1.95;
const HUNDREDFOLD = 95;
/** Points for the dynamics of a part. */
const FEW_POINTS = 6;

/** The places of the parts of the first model. */
const [LEGS, ARMS] = [0, 1] as const;

/** What the page measures of the model on the stage. */
export interface Facts {
  /** Whether the model is the one that the page opens with. */
  isStartModel: boolean;
  learned: Couplings;
  alpha: Couplings;
  reports: BodyReports;
  /** The largest distance between the same joint of the motion and of the learned one, millimetres. */
  apart: number;
  /** The largest number of inducing points of a dynamics map. */
  points: number;
}

/** A measured sentence: its name in the words, and its numbers. */
export type Finding = {
  [Name in keyof FoundWords]: { name: Name; values: Parameters<FoundWords[Name]> };
}[keyof FoundWords];

type FoundWords = {
  [Name in keyof TeachWords["exercises"]["found"]]: TeachWords["exercises"]["found"][Name] extends (
    ...values: infer Values
  ) => string
    ? (...values: Values) => string
    : () => string;
};

export interface Verdict {
  isSolved: boolean;
  findings: readonly Finding[];
}

/** The couplings that differ from the learned ones, with their factors. */
export function changesOf({ learned, alpha }: Pick<Facts, "learned" | "alpha">) {
  return learned.flatMap((row, source) =>
    row.flatMap((value, target) => {
      const factor = (alpha[source]?.[target] ?? value) / value;
      return Math.abs(Math.log(factor)) < 0.01 ? [] : [{ source, target, factor }];
    }),
  );
}

const atLeast = (factor: number, least: number) => Math.max(factor, 1 / factor) >= least;

/** The swing of a part as a multiple of the learned one. */
function swing({ now, learned }: BodyReports, part: number): number {
  const [is, was] = [now.measures.parts[part]?.swing, learned.measures.parts[part]?.swing];
  return is == null || !was ? Number.NaN : is / was;
}

const isNear = (value: number) => Math.abs(value - 1) <= SAME;

function isSamePace({ now, learned }: BodyReports, part: number): boolean {
  const [is, was] = [now.measures.parts[part]?.period, learned.measures.parts[part]?.period];
  return is != null && was != null && isNear(is / was);
}

/**
 * Whether couplings are at least doubled, and all couplings into a part by one factor: then its weights stay. A
 * pointer does not meet a factor exactly, and the motion then differs a little.
 */
function keepsRatios({ learned, alpha }: Facts): boolean {
  const into = learned.map((_, target) =>
    learned.map((row, source) => (alpha[source]?.[target] ?? Number.NaN) / row[target]!),
  );
  const isOne = (factors: readonly number[]) => Math.max(...factors) / Math.min(...factors) <= 1 + SAME;
  return into.every(isOne) && into.some(([first = 1]) => atLeast(first, DOUBLED));
}

/** Whether the model on the stage solves the exercise, and what was measured. */
export function judge(exercise: ExerciseName, facts: Facts): Verdict {
  const { reports, isStartModel, apart, points } = facts;
  if (exercise === "few") {
    if (isStartModel) return { isSolved: false, findings: [{ name: "ownModel", values: [] }] };
    const movesOn = reports.now.health.state === "moves-on";
    return {
      isSolved: movesOn && points <= FEW_POINTS,
      findings: [
        { name: "model", values: [points] },
        { name: movesOn ? "moves" : "stands", values: [] },
      ],
    };
  }
  if (!isStartModel) return { isSolved: false, findings: [{ name: "startModel", values: [] }] };
  const [legs, arms] = [swing(reports, LEGS), swing(reports, ARMS)];
  const changes = changesOf(facts);
  const swings: Finding = { name: "parts", values: [legs, arms] };
  const factors: Finding = { name: "factors", values: [factorsText(changes)] };
  switch (exercise) {
    case "pace": {
      const { period: ofLegs } = reports.now.measures.parts[LEGS] ?? {};
      const { locking, period } = reports.now.measures.parts[ARMS] ?? {};
      const isApart = locking != null && stepOf(locking) === "out of step";
      const paces: Finding[] =
        ofLegs != null && period != null ? [{ name: "pace", values: [ofLegs, period] }] : [];
      const steps: Finding[] = locking != null ? [{ name: "inStep", values: [locking] }] : [];
      return {
        isSolved: isApart && legs >= HALF && arms >= HALF,
        findings: [swings, ...paces, ...steps],
      };
    }
    case "pose":
      return { isSolved: legs >= WALKS_ON && arms <= NO_SWING, findings: [swings] };
    case "ratio": {
      const isAsLearned = reports.now.request.reading === "as-learned";
      const all: Finding[] = [factors, { name: "apart", values: [apart] }];
      return {
        isSolved: isAsLearned && keepsRatios(facts),
        findings: isAsLearned ? all : [...all, { name: "reading", values: [] }],
      };
    }
    case "idle": {
      const [only, ...others] = changes;
      const isSame = [LEGS, ARMS].every((part) => isNear(swing(reports, part)) && isSamePace(reports, part));
      return {
        isSolved: only !== undefined && others.length === 0 && atLeast(only.factor, HUNDREDFOLD) && isSame,
        findings: [factors, swings],
      };
    }
    case "halt":
      return {
        isSolved: changes.length === 1 && legs <= NO_SWING && arms <= NO_SWING,
        findings: [factors, swings],
      };
  }
}

/** Factors such as "2 ×" and "1/100 ×"; the arrows of the table name the couplings. */
const factorsText = (changes: ReturnType<typeof changesOf>) =>
  changes.map(({ factor }) => (factor >= 1 ? `× ${rounded(factor)}` : `÷ ${rounded(1 / factor)}`)).join(", ");

const rounded = (factor: number) => String(Number(factor.toPrecision(2)));
