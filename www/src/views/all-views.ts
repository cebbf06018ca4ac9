// All views but the Lab, in the order of the navigation.
import type { View } from "./define-view";

const found = import.meta.glob<View>("../*/entry.ts", { eager: true, import: "view" });
const last = Number.POSITIVE_INFINITY;

/** `folder`: the view's own in the sources, as this file writes it. */
export const ALL_VIEWS = Object.entries(found)
  .map(([file, view]) => ({ ...view, folder: file.replace("entry.ts", "") }))
  .sort((a, b) => (a.place ?? last) - (b.place ?? last));
