// Keys that work anywhere on the page, unless a control uses them.

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
