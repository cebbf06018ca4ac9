// What of this visit is on no disk, and would be lost with the page.
import type { App } from "./app";

/**
 * Whether leaving the page would lose work: a visit is kept by the browser, where it can, but for what is not
 * looked at, studies and series.
 */
export function wouldLose(app: App): boolean {
  const library = app.primitives.loaded?.library;
  const comparison = app.comparison.loaded;
  const perception = app.perception.loaded;
  const kept = app.session.loaded?.keeps ?? false;
  const isKept = (looked: unknown) => (thing: unknown) => kept && thing === looked;
  return [
    !kept && (app.model.unsaved || app.training.runs.some(({ model }) => model !== null)),
    !(library?.unsaved ?? []).every(isKept(library?.known)),
    !(comparison?.unsaved ?? []).every(isKept(comparison?.shown)),
    (app.series.loaded?.model.unsaved ?? null) !== null,
    (perception?.unsaved ?? null) !== null,
    perception !== null && perception.unkept !== "" && perception.kept.some(({ rows }) => rows.length > 0),
  ].some(Boolean);
}
