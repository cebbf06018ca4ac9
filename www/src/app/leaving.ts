// What the visitor would lose by leaving or reloading the page.
import { isConfirmed } from "../ui/unsaved";
import type { App } from "./app";

/**
 * Whether leaving the page would lose work. The browser stores what a visit holds, where it can, except for
 * studies, series, and the comparisons and libraries that are not looked at.
 */
export function wouldLose(app: App): boolean {
  const library = app.primitives.loaded?.library;
  const comparison = app.comparison.loaded;
  const perception = app.perception.loaded;
  const isStored = app.session.loaded?.keeps ?? false;
  const isStoredThing = (shown: unknown) => (thing: unknown) => isStored && thing === shown;
  return [
    !isStored && (app.model.unsaved || app.training.runs.some(({ model }) => model !== null)),
    !(library?.unsaved ?? []).every(isStoredThing(library?.current)),
    !(comparison?.unsaved ?? []).every(isStoredThing(comparison?.shown)),
    (app.series.loaded?.model.unsaved ?? null) !== null,
    (perception?.unsaved ?? null) !== null,
    perception !== null &&
      perception.storageProblem !== "" &&
      perception.participations.some(({ rows }) => rows.length > 0),
  ].some(Boolean);
}

/** What runs now and would end with the page. */
function workUnderWay({ training, comparison, experiment, primitives, series, perception }: App): string[] {
  const { learning, fitting, imports, fold } = primitives.loaded ?? {};
  const isBusy = (...stores: ({ busy: boolean } | null | undefined)[]) => stores.some((store) => store?.busy);
  return [
    isBusy(training, learning, fitting, imports, fold, series.loaded?.training) ? "a training" : "",
    isBusy(comparison.loaded) ? "a comparison" : "",
    isBusy(experiment.loaded) ? "an experiment" : "",
    perception.loaded?.active ? "an experiment with a participant" : "",
  ].filter(Boolean);
}

/** Loads the new version of the page. Asks first when that ends something. */
export async function loadNewVersion(app: App): Promise<void> {
  const running = workUnderWay(app);
  if (running.length > 0) {
    const text = `Loading it ends what runs here: ${running.join(" and ")}.`;
    if (!(await isConfirmed("Load the new version now?", text, "Load it now"))) return;
  }
  await app.session.loaded?.keepNow();
  app.offline.takeNewVersion();
}
