// Files and folders that are dropped anywhere on the page.
import type { Place } from "../ui/notices-store";
import { type DroppedFiles, droppedFiles } from "./dropped-files";

export function listenToDrops(opened: (dropped: Promise<DroppedFiles>, at: Place) => Promise<void>): void {
  const page = document.documentElement;
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  // Each element under the pointer sends these events, so they are counted.
  let depth = 0;
  const show = (dragging: boolean) => page.toggleAttribute("data-dragging", dragging);
  document.addEventListener("dragenter", (event) => {
    if (!hasFiles(event)) return;
    depth += 1;
    show(true);
  });
  document.addEventListener("dragleave", (event) => {
    if (!hasFiles(event)) return;
    depth = Math.max(0, depth - 1);
    if (depth === 0) show(false);
  });
  document.addEventListener("dragover", (event) => {
    if (hasFiles(event)) event.preventDefault();
  });
  document.addEventListener("drop", (event) => {
    depth = 0;
    show(false);
    if (!hasFiles(event)) return;
    event.preventDefault();
    void opened(droppedFiles(event.dataTransfer?.items ?? []), { x: event.clientX, y: event.clientY });
  });
}
