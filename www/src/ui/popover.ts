// Puts a box that lies over the page beside what it belongs to. CSS can do this only in the newest browsers.

/** Pixels from the edges of the window, and from what it belongs to. */
const EDGE = 8;
const GAP = 4;

export interface Size {
  width: number;
  height: number;
}

/** Where a box goes: below the anchor, or above where it has more room, and within the window. */
export function popoverPlace(
  anchor: DOMRectReadOnly | (Size & { x: number; y: number }),
  box: Size,
  window: Size,
) {
  const below = anchor.y + anchor.height + GAP;
  const above = anchor.y - GAP - box.height;
  const fits = below + box.height <= window.height - EDGE;
  const most = Math.max(EDGE, window.height - EDGE - box.height);
  const top = fits || above < EDGE ? Math.min(below, most) : above;
  const left = Math.max(EDGE, Math.min(anchor.x, window.width - EDGE - box.width));
  return { left, top };
}

/** Shows a popover beside the control that asked for it. */
export function showPopoverAt(popover: HTMLElement, anchor: HTMLElement): void {
  popover.showPopover();
  const { left, top } = popoverPlace(anchor.getBoundingClientRect(), popover.getBoundingClientRect(), {
    width: document.documentElement.clientWidth,
    height: innerHeight,
  });
  popover.style.left = `${left}px`;
  popover.style.top = `${top}px`;
}
