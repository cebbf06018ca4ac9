// A small figure on the spot, drawn as thick lines, so that many figures are cheap.
import type { Motion, PartSpec } from "../engine/protocol";
import { type Shape, shapeOf } from "../scene/body-shape";
import type { Body } from "../scene/columns";
import { FADE, findLoop, HERE, type Loop, poseAt, blendInto, placeOnto } from "../scene/motion";
import { partOfJoints } from "../scene/joints";
import { floorOf, headingOf } from "../scene/stance";

/** Height of a body with a hand above its head, metres. */
const HEIGHT = 2.15;
/** Space below the feet, metres. */
const BELOW = 0.08;
/** The angle between heading and camera, radians. */
export const SIDE = 0.95;

/** A line of a figure, in pixels, with its part. */
export interface Stroke {
  part: number;
  x0: number;
  y0: number;
  x1: number;
  y1: number;
  width: number;
  /** Nearness to the camera. Far lines are drawn first. */
  depth: number;
}

/** The lines of a pose [nodes x 3], the farthest first. `floor`: height of the ground; `turn`: radians. */
export function strokesOf(
  shape: Shape,
  parts: Int16Array,
  pose: Float32Array,
  picture: { width: number; height: number; floor: number; turn: number },
): Stroke[] {
  const scale = picture.height / HEIGHT;
  const [c, s] = [Math.cos(picture.turn), Math.sin(picture.turn)];
  const [rootX = 0, , rootZ = 0] = pose;
  const at = (node: number) => {
    const [x = 0, y = 0, z = 0] = pose.subarray(3 * node);
    const [dx, dz] = [x - rootX, z - rootZ];
    return {
      x: picture.width / 2 + scale * (c * dx - s * dz),
      y: picture.height - scale * (y - picture.floor + BELOW),
      depth: s * dx + c * dz,
    };
  };
  const strokes = shape.capsules.map(({ from, to, r0, r1, joint }): Stroke => {
    const [a, b] = [at(from), at(to)];
    const width = Math.max(1.5, scale * (r0 + r1));
    return {
      part: parts[joint] ?? -1,
      x0: a.x,
      y0: a.y,
      x1: b.x,
      y1: b.y,
      width,
      depth: (a.depth + b.depth) / 2,
    };
  });
  for (const { node, towards, radius, joint } of shape.balls) {
    const a = at(node);
    const b = towards === null ? a : at(towards);
    const [x, y] = [(a.x + b.x) / 2, (a.y + b.y) / 2];
    strokes.push({
      part: parts[joint] ?? -1,
      x0: x,
      y0: y,
      x1: x,
      y1: y - 0.1,
      width: 2 * scale * radius,
      depth: a.depth,
    });
  }
  return strokes.sort((a, b) => a.depth - b.depth);
}

/** Draws the lines of a pose. `colourOf`: the colour of a part, -1 for no part. */
export function drawStrokes(
  draw: CanvasRenderingContext2D,
  strokes: readonly Stroke[],
  colourOf: (part: number) => string,
): void {
  draw.lineCap = "round";
  for (const { part, x0, y0, x1, y1, width } of strokes) {
    draw.strokeStyle = colourOf(part);
    draw.lineWidth = width;
    draw.beginPath();
    draw.moveTo(x0, y0);
    draw.lineTo(x1, y1);
    draw.stroke();
  }
}

/** A motion in a loop on the spot. */
export class SmallFigure {
  readonly #loop: Loop;
  readonly #shape: Shape;
  readonly #parts: Int16Array;
  readonly #floor: number;
  readonly #turn: number;
  readonly #pose: Float32Array;
  readonly #other: Float32Array;

  constructor(
    { figure, joints, parts }: Body,
    private readonly motion: Motion,
  ) {
    this.#loop = findLoop(motion);
    this.#pose = poseAt(motion, 0, HERE, new Float32Array(motion.nodes * 3));
    this.#other = this.#pose.slice();
    this.#shape = shapeOf(figure, joints, this.#pose);
    this.#parts = partOfJoints(joints.length, parts as PartSpec[]);
    this.#floor = floorOf(motion);
    this.#turn = headingOf(motion) + SIDE;
  }

  /** Draws the figure at a time. `colourOf`: the colour of a part, -1 for no part. */
  draw(
    draw: CanvasRenderingContext2D,
    size: { width: number; height: number },
    seconds: number,
    colourOf: (part: number) => string,
  ): void {
    const pose = this.#poseAfter(seconds);
    const picture = { ...size, floor: this.#floor, turn: this.#turn };
    drawStrokes(draw, strokesOf(this.#shape, this.#parts, pose, picture), colourOf);
  }

  /** The pose at a time. The end of a lap fades into the start of the next. */
  #poseAfter(seconds: number): Float32Array {
    const { end } = this.#loop;
    const frame = end > 0 ? (seconds / this.motion.frameTime) % end : 0;
    const pose = poseAt(this.motion, frame, HERE, this.#pose);
    if (frame < FADE && seconds / this.motion.frameTime >= end) {
      const before = poseAt(this.motion, end + frame, HERE, this.#other);
      const onto = placeOnto(before, pose);
      blendInto(pose, poseAt(this.motion, end + frame, onto, this.#other), 1 - frame / FADE);
    }
    return pose;
  }
}
