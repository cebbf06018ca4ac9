// Keys that work anywhere on the page, unless a control uses them.

export interface KeyActions {
  togglePlay(): void;
  step(direction: 1 | -1): void;
  resetCouplings(): unknown;
  help(): void;
  projector(): void;
  /** Shows the QR code of the present state. */
  code(): void;
  /** Escape. Returns whether there was a projector mode to leave. */
  leaveProjector(): boolean;
  /** The key that cuts a coupling goes down or up. */
  hold(held: boolean): void;
}

/** Whether the focused control uses this key. */
export function isUsedByControl(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  if (!target || event.ctrlKey || event.metaKey || event.altKey) return true;
  if (document.querySelector("dialog[open]")) return true;
  if (target.matches("input:not([type=range]):not([type=checkbox]), select, textarea")) return true;
  if (event.key === " ") return target.matches("button, summary, a, input[type=checkbox], [role=tab]");
  if (event.key.startsWith("Arrow") || event.key.startsWith("Page"))
    return target.matches("input, [role=tab]");
  return false;
}

/** `isOn`: whether the keys work now. */
export function listenToKeys(isOn: () => boolean, actions: KeyActions): void {
  document.addEventListener("keyup", (event) => event.key === "c" && actions.hold(false));
  document.addEventListener("keydown", (event) => {
    if (!isOn() || event.defaultPrevented || isUsedByControl(event)) return;
    // The key also closes the card of a term.
    if (event.key === "Escape" && !document.querySelector(":popover-open"))
      return void (actions.leaveProjector() && event.preventDefault());
    const action = {
      " ": () => actions.togglePlay(),
      ArrowLeft: () => actions.step(-1),
      ArrowRight: () => actions.step(1),
      "0": () => actions.resetCouplings(),
      "?": () => actions.help(),
      p: () => actions.projector(),
      q: () => actions.code(),
      c: () => !event.repeat && actions.hold(true),
    }[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
