// A participant that the program plays, to try a study out: attentive, and the more often taken in, the
// smaller a model's error is.
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";
import type { Side } from "./trial-view";

const mean = (values: readonly number[]) =>
  values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);

/** How often the simulated participant takes each stimulus for the natural one: half the time at best. */
export function confusionOf({ stimuli }: StudyInfo): number[] {
  const errors = stimuli.map(({ scores }) => Math.log(scores?.mse ?? NaN));
  const known = errors.filter(Number.isFinite);
  const middle = mean(known);
  const spread = Math.sqrt(mean(known.map((error) => (error - middle) ** 2))) || 1;
  return errors.map((error) =>
    Number.isFinite(error) ? 0.5 / (1 + Math.exp((error - middle) / spread)) : 0.5,
  );
}

/** The answer to a trial. `chance`: from 0 to 1. */
export function simulatedAnswer(
  { naturalSide, kind, left, right }: StudyTrial,
  confusion: readonly number[],
  chance: number,
): Side {
  if (naturalSide === "none") return chance < 0.5 ? "left" : "right";
  const generated = naturalSide === "left" ? right : left;
  const taken = kind === "attention" ? 0 : (confusion[generated] ?? 0.5);
  const other: Side = naturalSide === "left" ? "right" : "left";
  return chance < taken ? other : naturalSide;
}
