// Made answers to a study.

/**
 * The rows of participants with these seeds: each takes every second movement for natural and passes the
 * attention checks.
 */
export const answersOf = (/** @type {import("vcgpdm").Study} */ study, /** @type {number[]} */ seeds) => {
  const { stimuli, hash } = study.info;
  const id = (/** @type {number} */ place) => stimuli[place]?.id;
  return seeds.flatMap((seed) =>
    study.trials(seed).map(({ kind, left, right, naturalSide }, i) => {
      const sides = { left: id(left), right: id(right) };
      const taken = kind === "comparison" && i % 2 === 0;
      const response = (naturalSide === "left") === taken ? "right" : "left";
      return { participant: `p${seed}`, study: hash, trial_index: i, kind, ...sides, response };
    }),
  );
};
