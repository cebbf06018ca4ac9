// Work that can wait until the page is idle.

export function whenIdle(work: () => void): void {
  // Safari has no such function.
  if (typeof requestIdleCallback === "function") requestIdleCallback(work);
  else setTimeout(work, 2000);
}
