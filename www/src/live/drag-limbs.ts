// Limbs of a live figure follow the pointer.
import type { StageView } from "../stage/stage-view";
import type { LiveStore } from "./live-store";

/** Pixels around a node in which the pointer can grab it. */
const REACH = 26;

/**
 * A node near the pointer follows it; anywhere else a drag turns the camera. `dropped` is called after the
 * drag of a node. Returns a function that ends this.
 */
export function letDragLimbs(
  stage: StageView,
  picture: HTMLCanvasElement,
  live: LiveStore,
  dropped = () => {},
): () => void {
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
    if (node === null) return;
    grabbed = { node, x, y };
    turn(false);
    picture.setPointerCapture(event.pointerId);
  };
  const drag = (event: PointerEvent) => {
    if (!grabbed || !stage.scene) return;
    const { x, y } = place(event);
    live.pull(grabbed.node, stage.scene.dragged(grabbed.node, x - grabbed.x, y - grabbed.y));
    grabbed = { ...grabbed, x, y };
  };
  const drop = () => {
    if (grabbed) dropped();
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
