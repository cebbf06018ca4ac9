// Two shapes by formulas, for visitors who want to see a drawing first.
import { HEIGHT, type Sample, WIDTH } from "./hand";

/** Seconds of a round. */
const ROUND = 1.25;
/** Samples a second, and rounds of the example. */
const RATE = 60;
const ROUNDS = 4;

type Shape = (seconds: number) => [x: number, y: number];

const shape =
  (across: number, up: number, ups: number): Shape =>
  (seconds) => {
    const turn = (2 * Math.PI * seconds) / ROUND;
    return [
      WIDTH / 2 + across * Math.sin(turn),
      HEIGHT / 2 + up * Math.sin(ups * turn + (ups === 1 ? Math.PI / 2 : 0)),
    ];
  };

export const eight = shape(30, 22, 2);
export const circle = shape(28, 28, 1);

/** A shape as if a hand drew it. */
export const drawnBy = (place: Shape): Sample[] =>
  Array.from({ length: ROUNDS * ROUND * RATE }, (_, i) => {
    const [x, y] = place(i / RATE);
    return { seconds: i / RATE, x, y };
  });
