// Small functions around what every browser has.

/** Whether the visitor's system asks for less motion. */
export const prefersReducedMotion = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

export function whenIdle(work: () => void): void {
  // Safari has no such function.
  if (typeof requestIdleCallback === "function") requestIdleCallback(work);
  else setTimeout(work, 2000);
}

/** Resolves when the visitor moves the pointer, presses or types for the first time. */
export const firstMove = (): Promise<void> =>
  new Promise((moved) => {
    for (const event of ["pointermove", "pointerdown", "keydown"])
      addEventListener(event, () => moved(), { once: true });
  });

/** The most seconds between two pictures; after a longer pause the clock does not advance by more. */
export const LONGEST_PICTURE = 0.25;

/**
 * Calls back before each picture with the seconds since the previous one, at most `longest`. Returns a
 * function that stops the calls.
 */
export function eachFrame(work: (seconds: number) => void, longest = LONGEST_PICTURE): () => void {
  let before = performance.now();
  const frame = (now: number) => {
    timer = requestAnimationFrame(frame);
    const seconds = Math.min(longest, (now - before) / 1000);
    before = now;
    work(seconds);
  };
  let timer = requestAnimationFrame(frame);
  return () => cancelAnimationFrame(timer);
}

const PREFIX = "vcgpdm ";

/** Does something with the browser's storage, which may be forbidden. */
function attempt<Result>(work: () => Result, otherwise: Result): Result {
  try {
    return work();
  } catch {
    return otherwise;
  }
}

export const kept = (name: string): string | null => attempt(() => localStorage.getItem(PREFIX + name), null);

export const keep = (name: string, value: string): void =>
  attempt(() => localStorage.setItem(PREFIX + name, value), undefined);

/** Forgets all choices. Returns a function that brings them back. */
export function forgetKept(): () => void {
  const names = attempt(() => Object.keys(localStorage), []).filter((key) => key.startsWith(PREFIX));
  const choices = names.map((key) => [key.slice(PREFIX.length), localStorage.getItem(key) ?? ""] as const);
  for (const key of names) localStorage.removeItem(key);
  return () => {
    for (const [name, value] of choices) keep(name, value);
  };
}

/**
 * Clears a canvas and fits it to its size on the page, with at most two dots for a pixel; null: the browser
 * cannot draw.
 */
export function clearCanvas(
  canvas: HTMLCanvasElement,
): { draw: CanvasRenderingContext2D; width: number; height: number } | null {
  const ratio = Math.min(2, devicePixelRatio);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.max(1, width * ratio);
  canvas.height = Math.max(1, height * ratio);
  const draw = canvas.getContext("2d");
  if (!draw) return null;
  draw.scale(ratio, ratio);
  return { draw, width, height };
}
