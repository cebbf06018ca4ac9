// Work that can wait until the page has nothing else to do.

export function whenIdle(work: () => void): void {
  // Safari does not know it.
  if (typeof requestIdleCallback === "function") requestIdleCallback(work);
  else setTimeout(work, 2000);
}
