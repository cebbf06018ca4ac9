// The two movements of a trial, side by side in one picture: one renderer and one camera for all trials.
import { type Body, type ColumnMotion, Columns } from "../scene/columns";
import type { Motion } from "../engine/protocol";
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";

/** What a trial is drawn on. */
export interface PairStage {
  /** Stands in the page while a trial is shown; between trials it is kept. */
  readonly element: HTMLElement;
  /** Takes up the movements of a trial, and draws their first pose. */
  take(trial: StudyTrial): void;
  /** Draws both at so many seconds after their beginning; `drawn` is told of each side: 0 left, 1 right. */
  draw(seconds: number, drawn: (side: number) => void): void;
  dispose(): void;
}

/** From this side figures with a heading of 0 degrees are seen: from their front. */
const CAMERA = 0;

/** Turned about the vertical axis, radians. */
export function turned(motion: Motion, angle: number): Motion {
  const positions = motion.positions.slice();
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  for (let i = 0; i < positions.length; i += 3) {
    const [x, z] = [positions[i]!, positions[i + 2]!];
    positions[i] = c * x + s * z;
    positions[i + 2] = c * z - s * x;
  }
  return { ...motion, positions };
}

export class CanvasPair implements PairStage {
  readonly element = document.createElement("div");
  readonly #columns: Columns;
  readonly #body: Body;
  readonly #motionOf: (stimulus: number) => Motion;
  readonly #rate: number;
  #before = 0;

  /** Throws where the browser has no WebGL. */
  constructor({ skeleton, look, framesPerSecond }: StudyInfo, motionOf: (stimulus: number) => Motion) {
    this.element.className = "pair-stage";
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    this.element.append(canvas);
    this.#columns = new Columns(canvas, { from: CAMERA, turns: false });
    const nodes = skeleton.parents.map((parent, joint) => ({
      ...{ joint, parent: parent < 0 ? null : parent, endSite: false },
    }));
    // Without parts a figure is grey.
    this.#body = { figure: { nodes }, joints: skeleton.names, parts: [], look };
    this.#motionOf = motionOf;
    this.#rate = framesPerSecond;
  }

  take({ left, right, headingDegrees }: StudyTrial): void {
    const angle = (headingDegrees * Math.PI) / 180;
    const motions = [left, right].map(
      (stimulus): ColumnMotion => ({ motion: turned(this.#motionOf(stimulus), angle), ghost: null }),
    );
    this.#columns.show(this.#body, motions);
    this.#before = performance.now();
    this.draw(0, () => {});
  }

  draw(seconds: number, drawn: (side: number) => void): void {
    const now = performance.now();
    this.#columns.draw(seconds * this.#rate, true, (now - this.#before) / 1000, true, drawn);
    this.#before = now;
  }

  dispose(): void {
    this.#columns.dispose();
    this.element.remove();
  }
}
