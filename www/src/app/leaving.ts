// What the visitor would lose by leaving or reloading the page.
import { isConfirmed } from "../unsaved/unsaved";
import type { App } from "./app";
import { lab } from "../words/lab";

/**
 * Whether leaving the page would lose work. The browser stores what a visit holds, where it can, except for
 * studies, series, and the comparisons and libraries that are not looked at.
 */
export function wouldLose(app: App): boolean {
  const library = app.view("primitives").loaded?.library;
  const comparison = app.view("compare").loaded;
  const perception = app.view("perception").loaded?.perception ?? null;
  const isStored = app.session.loaded?.keeps ?? false;
  const isStoredThing = (shown: unknown) => (thing: unknown) => isStored && thing === shown;
  return [
    !isStored && (app.model.unsaved || app.training.runs.some(({ model }) => model !== null)),
    !(library?.unsaved ?? []).every(isStoredThing(library?.current)),
    !(comparison?.unsaved ?? []).every(isStoredThing(comparison?.shown)),
    (app.view("series").loaded?.model.unsaved ?? null) !== null,
    (perception?.unsaved ?? null) !== null,
    perception !== null &&
      perception.storageProblem !== "" &&
      perception.participations.some(({ rows }) => rows.length > 0),
  ].some(Boolean);
}

/** What runs now and would end with the page. */
function workUnderWay(app: App): string[] {
  const { learning, fitting } = app.view("primitives").loaded ?? {};
  const isBusy = (...stores: ({ busy: boolean } | null | undefined)[]) => stores.some((store) => store?.busy);
  const { running } = lab().files.newVersion;
  return [
    isBusy(app.training, learning, fitting, app.view("series").loaded?.training) ? running.training : "",
    isBusy(app.view("compare").loaded) ? running.comparison : "",
    isBusy(app.view("synthetic").loaded) ? running.experiment : "",
    app.view("perception").loaded?.perception.active ? running.participant : "",
  ].filter(Boolean);
}

/** Loads the new version of the page. Asks first when that ends something. */
export async function loadNewVersion(app: App): Promise<void> {
  const running = workUnderWay(app);
  if (running.length > 0) {
    const { title, text, load } = lab().files.newVersion;
    if (!(await isConfirmed(title, text(running), load))) return;
  }
  await app.session.loaded?.keepNow();
  app.offline.takeNewVersion();
}
