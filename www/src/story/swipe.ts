// Swipes to the left and to the right on a touch screen.

/** Pixels: the least way to the side, and the most up or down. */
const SIDEWAYS = 60;
const UPWARDS = 40;

/** Calls back with 1 for a swipe to the left, -1 for one to the right. Returns a function that stops the calls. */
export function swipes(element: HTMLElement, swiped: (direction: 1 | -1) => void): () => void {
  const ended = new AbortController();
  const options = { signal: ended.signal, passive: true };
  let from: Touch | null = null;
  element.addEventListener(
    "touchstart",
    ({ touches, target }) => {
      // A slider is dragged sideways too.
      const isDragged = target instanceof Element && target.closest("input, svg, canvas") !== null;
      from = touches.length === 1 && !isDragged ? (touches[0] ?? null) : null;
    },
    options,
  );
  element.addEventListener(
    "touchend",
    ({ changedTouches }) => {
      const to = changedTouches[0];
      if (!from || !to) return;
      const [x, y] = [to.clientX - from.clientX, to.clientY - from.clientY];
      from = null;
      if (Math.abs(x) >= SIDEWAYS && Math.abs(y) <= UPWARDS) swiped(x < 0 ? 1 : -1);
    },
    options,
  );
  return () => ended.abort();
}
