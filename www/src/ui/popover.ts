// Places a popover next to a control. CSS can do this only in the newest browsers.

/** Pixels from the edges of the window and from the control. */
const EDGE = 8;
const GAP = 4;

export interface Size {
  width: number;
  height: number;
}

/** The place of a box: below the anchor, or above it when the box does not fit below, within the window. */
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

/** Shows a popover next to a control. */
export function showPopoverAt(popover: HTMLElement, anchor: HTMLElement): void {
  popover.showPopover();
  const { left, top } = popoverPlace(anchor.getBoundingClientRect(), popover.getBoundingClientRect(), {
    width: document.documentElement.clientWidth,
    height: innerHeight,
  });
  popover.style.left = `${left}px`;
  popover.style.top = `${top}px`;
}
