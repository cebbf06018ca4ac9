// The stage: the figure with its ghost, its futures and the poses of an inducing point.
import { Vector3 } from "three";
import type { Motion } from "../engine/protocol";
import type { FigureView } from "../scene/figure";
import { type Companion, FollowedFigure } from "../scene/followed-figure";
import { placeOnto, poseAt } from "../scene/motion";
import type { Playback } from "./playback";
import type { Fade, Marks, StageContent, StageStore } from "./stage-store";

export class Stage {
  readonly #walk: FollowedFigure;
  #marked: FigureView[] = [];
  /** The content that the marked poses were made for. */
  #markedOf: Marks | null = null;
  #faded: { opacity: number; part?: number } | null = null;

  /** Throws where the browser has no WebGL. */
  constructor(
    private readonly store: StageStore,
    private readonly playback: Playback,
    canvas: HTMLCanvasElement,
  ) {
    this.#walk = new FollowedFigure(canvas, playback, () => this.update());
    store.camera = this.#camera;
    this.update();
  }

  /** From where the camera looks; null before the first figure. */
  readonly #camera = () => this.#walk.look;

  /** Frees the graphics memory. */
  dispose(): void {
    if (this.store.camera === this.#camera) this.store.camera = () => null;
    this.#clearMarked();
    this.#walk.dispose();
  }

  /** Asks for another picture. */
  tick(): void {
    this.#walk.viewport.changed();
  }

  #clearMarked(): void {
    for (const figure of this.#marked) figure.dispose();
    [this.#marked, this.#markedOf] = [[], null];
  }

  /** Makes the figures of the stage's content. */
  update(): void {
    this.tick();
    const { content } = this.store;
    if (!content) return;
    if (this.#walk.show(content)) {
      this.#clearMarked();
      this.#faded = null;
    }
    const look = this.#walk.look && this.store.takeLook();
    if (look) this.#walk.lookFrom(look);
    this.#walk.accompany(this.#companions(content));
    this.#updateMarked(content);
    this.#fade(this.#marked.length > 0 ? { opacity: 0.12 } : this.store.fade);
  }

  /** The ghost and the futures. */
  #companions(content: StageContent): Companion[] {
    const { ghost } = this.store;
    const frame = () => this.store.ghostFrame;
    const futures = content.kind === "model" && !content.live ? this.store.futures : [];
    return [
      ...futures.map((motion, index): Companion => ({ style: { kind: "future", index }, motion })),
      ...(ghost ? [{ style: { kind: "ghost" }, motion: ghost, frame } satisfies Companion] : []),
    ];
  }

  #fade(fade: Fade | { opacity: number } | null): void {
    if (fade === this.#faded) return;
    this.#faded = fade;
    const { figure } = this.#walk;
    figure?.fade(1);
    if (fade) figure?.fade(fade.opacity, "part" in fade ? fade.part : undefined);
  }

  /** The poses of an inducing point. */
  #updateMarked(content: StageContent): void {
    const marks = content.kind === "model" ? this.store.marks : null;
    if (this.#markedOf === marks) return;
    this.#clearMarked();
    this.#markedOf = marks;
    this.#marked = (marks?.poses ?? []).map(({ part, opacity }) =>
      this.#walk.make(content, { kind: "accent", part, opacity }),
    );
  }

  /** The place of a node in the picture, in pixels of the page; null before the first pose. */
  placeOf(node: number): { x: number; y: number } | null {
    const { pose } = this.playback;
    if (!pose) return null;
    const { size, camera } = this.#walk.viewport;
    const seen = new Vector3().fromArray(pose, 3 * node).project(camera);
    return { x: ((seen.x + 1) / 2) * size.width, y: ((1 - seen.y) / 2) * size.height };
  }

  /** The node nearest to a place in the picture; null if none is within `within` pixels. */
  nodeAt(x: number, y: number, within: number): number | null {
    const nodes = (this.playback.pose?.length ?? 0) / 3;
    let best: { node: number; away: number } | null = null;
    for (let node = 0; node < nodes; node++) {
      const place = this.placeOf(node);
      const away = place ? Math.hypot(place.x - x, place.y - y) : Infinity;
      if (away < (best?.away ?? within)) best = { node, away };
    }
    return best?.node ?? null;
  }

  /** The shift of a node in metres for a drag in pixels, parallel to the picture. */
  dragged(node: number, dx: number, dy: number): [number, number, number] {
    const { camera, size } = this.#walk.viewport;
    const { pose } = this.playback;
    if (!pose) return [0, 0, 0];
    const seen = new Vector3().fromArray(pose, 3 * node).project(camera);
    const moved = new Vector3(
      seen.x + (2 * dx) / size.width,
      seen.y - (2 * dy) / size.height,
      seen.z,
    ).unproject(camera);
    const by = moved.sub(new Vector3().fromArray(pose, 3 * node));
    return [by.x, by.y, by.z];
  }

  /** Whether drags turn the camera. */
  set turns(on: boolean) {
    this.#walk.viewport.controls.enableRotate = on;
  }

  /** Draws after a change. `seconds` since the last call. */
  draw(seconds: number): void {
    this.#walk.draw(seconds, this.#marked.length === 0, (pose) => {
      this.#marked.forEach((figure, i) => {
        const marked = this.#markedOf?.poses[i];
        if (marked) figure.pose(placed(marked.positions, pose));
      });
    });
  }
}

/** A marked pose at the place and in the direction of the figure. */
function placed(marked: Float32Array, pose: Float32Array): Float32Array {
  const motion: Motion = { positions: marked, frames: 1, nodes: marked.length / 3, frameTime: 1 };
  return poseAt(motion, 0, placeOnto(marked, pose), new Float32Array(marked.length));
}
