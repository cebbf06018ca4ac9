// For tests: small clips of a body of two joints, which sways once a second.
import type { TrainingClip } from "../engine/protocol";

const FRAMES = 24;

function bvh(phase: number): string {
  const wave = (frame: number, degrees: number) =>
    (degrees * Math.sin((2 * Math.PI * frame) / 10 + phase)).toFixed(3);
  const row = (_: unknown, frame: number) =>
    `0 1 ${frame / 10} ${wave(frame, 5)} 0 0 ${wave(frame, 20)} ${wave(frame, 10)} 0`;
  return `HIERARCHY
ROOT Hips {
  OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine { OFFSET 0 1 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 1 0 } }
}
MOTION
Frames: ${FRAMES}
Frame Time: 0.1
${Array.from({ length: FRAMES }, row).join("\n")}
`;
}

/** The clip of this number. Numbers with the same last digit have the same motion. */
export const smallClip = (id: number): TrainingClip => ({
  ...{ id, first: 0, end: FRAMES },
  source: { name: `clip ${id}.bvh`, file: new Blob([bvh(id % 10)]) },
});
