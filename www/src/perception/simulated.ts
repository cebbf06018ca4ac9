// A simulated participant, to try a study out. It passes every attention check, and takes a movement for
// natural the more often, the smaller the error of its model is.
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";
import type { Side } from "./trial-view";

const mean = (values: readonly number[]) =>
  values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);

/** The probability that the simulated participant takes each stimulus for the natural one; at most 0.5. */
export function confusionOf({ stimuli }: StudyInfo): number[] {
  const errors = stimuli.map(({ scores }) => Math.log(scores?.mse ?? NaN));
  const finite = errors.filter(Number.isFinite);
  const middle = mean(finite);
  const spread = Math.sqrt(mean(finite.map((error) => (error - middle) ** 2))) || 1;
  return errors.map((error) =>
    Number.isFinite(error) ? 0.5 / (1 + Math.exp((error - middle) / spread)) : 0.5,
  );
}

/** The answer to a trial. `chance`: a random number from 0 to 1. */
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
