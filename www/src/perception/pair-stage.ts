// The two movements of a trial, side by side in one picture: one renderer and one camera for all trials.
import { type Body, Columns } from "../scene/columns";
import { underWay } from "../scene/under-way";
import type { Motion } from "../engine/protocol";
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";

/** The surface that a trial is drawn on. */
export interface PairStage {
  /** On the page during a trial; all trials share it. */
  readonly element: HTMLElement;
  /** Takes the movements of a trial and draws their first poses. */
  take(trial: StudyTrial): void;
  /** Draws both movements at a time in seconds; calls `drawn` for each side: 0 left, 1 right. */
  draw(seconds: number, drawn: (side: number) => void): void;
  dispose(): void;
}

/** The camera's direction: it sees figures with a heading of 0 degrees from the front. */
const CAMERA = 0;

export class CanvasPair implements PairStage {
  readonly element = document.createElement("div");
  readonly #columns: Columns;
  readonly #body: Body;
  readonly #speedOf: (stimulus: number) => number;
  readonly #rate: number;
  #before = 0;

  /** Throws where the browser has no WebGL. */
  constructor(
    { skeleton, look, framesPerSecond, stimuli }: StudyInfo,
    private readonly motionOf: (stimulus: number) => Motion,
  ) {
    this.element.className = "pair-stage";
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    this.element.append(canvas);
    this.#columns = new Columns(canvas, { from: CAMERA, turns: false });
    const nodes = skeleton.parents.map((parent, node) => ({
      // The joint at the start of a bone turns its end.
      joint: node < skeleton.joints ? node : parent,
      parent: parent < 0 ? null : parent,
      endSite: node >= skeleton.joints,
    }));
    // A figure without parts is grey.
    this.#body = { figure: { nodes }, joints: skeleton.names, parts: [] };
    if (look === "points") this.#body.lights = skeleton.dots;
    this.#speedOf = (stimulus) => stimuli[stimulus]?.speed ?? 0;
    this.#rate = framesPerSecond;
  }

  take({ left, right, headingDegrees }: StudyTrial): void {
    const heading = (headingDegrees * Math.PI) / 180;
    const motions = [left, right].map((stimulus) =>
      underWay(this.motionOf(stimulus), this.#speedOf(stimulus), heading),
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
