// The settings of a model of a drawing. They were chosen on thirty made drawings and judged on thirty others:
// tests/node/drawings.test.mjs.
import { ROWS_A_SECOND } from "./hand";

export const DRAWING_SETTINGS = {
  latent: 2,
  dynamicsIps: 16,
  poseIps: 16,
  order: 2,
  framesPerSecond: ROWS_A_SECOND,
  seed: 0,
  maxIterations: 150,
};
