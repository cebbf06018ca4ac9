// The work on the page that a session stores, and how a later visit takes it up.
import type { ClipsStore } from "../clips/clips-store";
import type { ModelStore } from "../couplings/model-store";
import { stageWork } from "../couplings/model-work";
import type { EngineStore } from "../engine/engine-store";
import type { Holdings } from "../session/records";
import type { Visit } from "../session/session-store";
import { initialSettings, writeSettings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import type { TrainingStore } from "../training/training-store";
import { messageOf, sentence } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { mayLose } from "../unsaved/unsaved";
import type { ViewName, ViewStores } from "../settings/views";
import type { Lazy } from "../ui/lazy";
import { sessionWords } from "../words/sections";

/** The stores whose work a session stores. */
interface Stores {
  settings: SettingsStore;
  engine: EngineStore;
  clips: ClipsStore;
  training: TrainingStore;
  model: ModelStore;
  notices: NoticesStore;
  view<Name extends ViewName>(name: Name): Lazy<ViewStores[Name]>;
}

/** Clips of runs that are not open any more have negative ids: no open clip has one. */
let lastClosedClip = 0;

export function visitOf(stores: Stores): Visit {
  return {
    holdings: () => holdingsOf(stores),
    takeUp: (holdings) => takeUp(stores, holdings),
    showError: (title, text) => stores.notices.addError(title, text),
  };
}

function holdingsOf(stores: Stores): Holdings {
  const { settings, clips, training, model } = stores;
  const comparison = stores.view("compare").loaded;
  const shown = comparison?.shown;
  const ids = new Map(clips.all.map(({ key, loaded }) => [key, loaded.id]));
  return {
    fragment: settings.labFragment,
    clips: clips.stored.map((clip) => ({ ...clip, id: ids.get(clip.key) ?? 0 })),
    firstBones: clips.firstBones,
    runs: training.runs,
    chosen: training.chosen,
    model: training.chosen ? null : model.openedText,
    results: shown && !shown.given ? shown.results.text : null,
    unsaved: {
      model: model.unsaved,
      results: comparison?.unsaved.some((entry) => entry === shown) ?? false,
    },
    library: stores.view("primitives").loaded?.library.stored ?? null,
  };
}

/** Asks all questions before the first change; from then on a piece that fails does not stop the others. */
async function takeUp(stores: Stores, holdings: Holdings): Promise<string[]> {
  const { settings, clips, training, model, engine } = stores;
  const { chosen, library, unsaved } = holdings;
  const words = sessionWords();
  const bringsModel = holdings.model !== null || Boolean(chosen?.model);
  // The model of a training takes the stage without a question.
  if (bringsModel && training.busy) throw new Error(words.trainingRuns);
  const keepsPresent = () => new Error(words.keepsPresent);
  if (bringsModel && !(await mayLose(stageWork(model, engine)))) throw keepsPresent();
  if (holdings.results !== null) {
    const comparison = await stores.view("compare").get();
    if (!(await comparison.open(holdings.results, !unsaved.results))) throw keepsPresent();
  }
  if (settings.labFragment === writeSettings(initialSettings()) && holdings.fragment !== "") {
    settings.takeFragment(holdings.fragment);
    model.restart();
  }

  const problems: string[] = [];
  const attempt = async (what: string, work: () => Promise<unknown>) => {
    try {
      await work();
    } catch (problem) {
      problems.push(sentence(`${what}: ${messageOf(problem)}`));
    }
  };
  /** The ids of the clips in this visit, by their ids in the earlier one. */
  const ids = new Map<number, number>();
  for (const clip of holdings.clips)
    await attempt(words.theClip(clip.title), async () => {
      ids.set(clip.id, await clips.takeUp(clip));
    });
  await clips.setFirstBones(holdings.firstBones);
  const idNow = (id: number) => {
    const now = ids.get(id) ?? --lastClosedClip;
    ids.set(id, now);
    return now;
  };
  const runs = holdings.runs.map((run) => ({
    ...run,
    clips: run.clips.map((clip) => ({ ...clip, id: idNow(clip.id) })),
  }));
  await attempt(words.theTrainings, () => training.takeUp(runs, chosen ? holdings.runs.indexOf(chosen) : -1));
  const { model: text } = holdings;
  if (text !== null)
    await attempt(words.theModel, async () => {
      await model.open(text, { couplings: "visitor", clip: true });
      training.unchoose();
      if (unsaved.model) model.markMadeHere();
    });
  if (library !== null)
    await attempt(words.theLibrary, async () => {
      const primitives = await stores.view("primitives").get();
      await primitives.library.open(library.text, library.title, library.unsaved);
    });
  return problems;
}
