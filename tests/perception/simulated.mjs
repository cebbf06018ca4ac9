// The answers of a simulated participant, as jsPsych writes them, with the columns of this project.

/** Numbers from 0 to 1 that follow from the seed (Marsaglia's xorshift). */
function uniforms(/** @type {number} */ seed) {
  let state = (seed * 2654435761 + 1) >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 4294967296;
  };
}

/**
 * Answers to what this participant is shown: a generated movement is taken for the natural one the more often
 * the lower its error.
 * @param {import("vcgpdm").Study} study
 * @param {string} name
 * @param {number} seed
 * @param {{ withStudy?: boolean }} [options]
 */
export function simulatedAnswers(study, name, seed, { withStudy = true } = {}) {
  const { stimuli, hash } = study.info;
  const uniform = uniforms(seed);
  const rows = study.trials(seed).map(({ block, kind, left, right, naturalSide, headingDegrees }, k) => {
    const [a, b] = [stimuli[left], stimuli[right]];
    if (!a || !b) throw new Error("expected stimuli");
    const generated = a.kind === "generated" ? a : b;
    const rate =
      kind === "catch"
        ? 0.5
        : generated.failed
          ? 0
          : 0.5 / (1 + Math.exp(800 * (generated.scores?.dtwMse ?? 0) - 1));
    const fooled = uniform() < rate;
    // Of catch trials the left one, half of the time.
    const chosenLeft = kind === "catch" ? fooled : (naturalSide === "left") !== fooled;
    return {
      rt: 3600 + Math.round(900 * uniform()),
      trial_type: "side-by-side",
      trial_index: k + 3,
      participant: name,
      ...(withStudy ? { study: hash } : {}),
      block,
      kind,
      left: a.id,
      right: b.id,
      natural_side: naturalSide,
      response: chosenLeft ? "left" : "right",
      heading: headingDegrees,
      started_apart_ms: 0,
      lasted_ms: 3500,
    };
  });
  const quoted = (/** @type {unknown} */ value) => `"${String(value).replaceAll('"', '""')}"`;
  const lines = [Object.keys(rows[0] ?? {}), ...rows.map(Object.values)];
  return { rows, csv: lines.map((line) => `${line.map(quoted).join(",")}\r\n`).join("") };
}
