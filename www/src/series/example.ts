// The example of time series: two made-up machines, by a formula; the second follows the first.

const ROWS = 100;
const STEP = 0.05;
const NAMES = ["leader_a", "leader_b", "leader_c", "follower_d", "follower_e"];

function measured(recording: number, row: number): number[] {
  const phase = 0.25 * row + 1.5 * recording;
  return [
    10 + Math.sin(phase),
    2 * Math.cos(phase),
    Math.tanh(Math.sin(phase + 0.5)),
    5 + 0.8 * Math.sin(phase - 0.7),
    0.5 * Math.cos(2 * (phase - 0.7)),
  ];
}

/** Two recordings of the machines, as files. */
export function exampleFiles(): File[] {
  return [1, 2].map((number) => {
    const rows = Array.from({ length: ROWS }, (_, row) =>
      [row * STEP, ...measured(number - 1, row)].map((value) => value.toFixed(4)).join(","),
    );
    return new File([["time", ...NAMES].join(","), "\n", rows.join("\n"), "\n"], `machines-${number}.csv`);
  });
}
