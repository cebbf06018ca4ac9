// Limbs of a figure follow the pointer.
import type { StageView } from "../stage/stage-view";

/** A figure whose limbs can be dragged. */
interface Draggable {
  /** Whether it is on the stage. */
  readonly running: boolean;
  /** A node follows its place in the picture, shifted by metres. */
  reach(node: number, by: readonly [number, number, number]): void;
  letGo(node: number): void;
}

/** Pixels around a node in which the pointer can grab it. */
const REACH = 26;

/**
 * A node near the pointer follows it while the pointer is held, as far as the poses of the model allow; anywhere
 * else a drag turns the camera. Returns a function that ends this.
 */
export function letDragLimbs(stage: StageView, live: Draggable): () => void {
  const picture = stage.querySelector("canvas");
  if (!picture) return () => {};
  /** The node, and where the pointer is relative to it, in pixels. */
  let grabbed: { node: number; x: number; y: number } | null = null;
  const place = (event: PointerEvent) => {
    const { left, top } = picture.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  };
  const turn = (on: boolean) => {
    if (stage.scene) stage.scene.turns = on;
  };
  const grab = (event: PointerEvent) => {
    const { x, y } = place(event);
    const node = live.running ? (stage.scene?.nodeAt(x, y, REACH) ?? null) : null;
    const at = node === null ? null : stage.scene?.placeOf(node);
    if (node === null || !at) return;
    grabbed = { node, x: x - at.x, y: y - at.y };
    turn(false);
    picture.setPointerCapture(event.pointerId);
  };
  const drag = (event: PointerEvent) => {
    if (!grabbed || !stage.scene) return;
    const { x, y } = place(event);
    const { node } = grabbed;
    const at = stage.scene.placeOf(node);
    if (at) live.reach(node, stage.scene.dragged(node, x - grabbed.x - at.x, y - grabbed.y - at.y));
  };
  const drop = () => {
    if (grabbed) live.letGo(grabbed.node);
    grabbed = null;
    turn(true);
  };
  const listening = new AbortController();
  const { signal } = listening;
  // The listener must run before the camera's own listener on the same element.
  picture.addEventListener("pointerdown", grab, { capture: true, signal });
  picture.addEventListener("pointermove", drag, { signal });
  picture.addEventListener("pointerup", drop, { signal });
  picture.addEventListener("pointercancel", drop, { signal });
  return () => {
    listening.abort();
    turn(true);
  };
}
