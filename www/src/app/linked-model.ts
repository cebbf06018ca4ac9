// Opens the model that an address brings: in itself, or in a file of the page's host. Loaded at the first use.
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import type { ModelStore } from "../couplings/model-store";
import { stageWork } from "../couplings/model-work";
import type { EngineStore } from "../engine/engine-store";
import { textOfFile } from "../links/model-file";
import { unpacked } from "../links/packed-model";
import { LinkError } from "../links/problem";
import { readSettings, type Settings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import type { TrainingStore } from "../training/training-store";
import { messageOf, sentence } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { mayLose } from "../unsaved/unsaved";
import { lab } from "../words/lab";
import { linkWords, loadLinks } from "../words/sections";
import type { WordsStore } from "../words/words";
import type { WholeWorkers } from "../engine/whole-workers";
import { hasNoCouplings } from "../couplings/model-document";

interface Stores {
  words: WordsStore;
  settings: SettingsStore;
  engine: EngineStore;
  stage: StageStore;
  playback: Playback;
  model: ModelStore;
  training: TrainingStore;
  notices: NoticesStore;
  workers: WholeWorkers;
  takeMoment(): void;
}
type Brought = Pick<Settings, "modelFile" | "packedModel">;

const documentOf = ({ modelFile, packedModel }: Brought) =>
  packedModel === "" ? textOfFile(modelFile) : unpacked(packedModel);

async function say({ words, notices }: Stores, problem: unknown): Promise<void> {
  await loadLinks(words);
  const { notOpened, problems } = linkWords();
  const why = problem instanceof LinkError ? problems(problem.problem) : sentence(messageOf(problem));
  notices.addError(notOpened, why);
}

/** Shows the motion of a model without couplings. `take` takes the settings of the link. */
async function show(
  app: Stores,
  text: string,
  { modelFile, frames }: Pick<Settings, "modelFile" | "frames">,
  take: () => void,
): Promise<void> {
  const { showAnyModel } = await import("./any-model");
  await showAnyModel(app, { name: modelFile.split("/").at(-1) ?? "", text, link: { frames, take } });
  app.takeMoment();
}

function whenReady(engine: EngineStore, act: () => void): void {
  const stop = engine.on(() => {
    if (engine.state === "loading") return;
    stop();
    if (engine.state === "ready") act();
  });
}

/** Opens the model of the first address. Returns false when the page's own model has to take its place. */
export async function openFirst(app: Stores): Promise<boolean> {
  const { settings, model } = app;
  const { modelFile, packedModel, frames, camera, time } = settings.values;
  const link = { modelFile, packedModel, frames, camera, time };
  try {
    const text = await documentOf(link);
    if (hasNoCouplings(text)) {
      // Its motion moves in front of the page's own model, which clears these settings.
      whenReady(app.engine, () => {
        show(app, text, link, () => settings.change(link)).catch((problem: unknown) => say(app, problem));
      });
      return false;
    }
    await model.openLinked(text, () => {});
    return true;
  } catch (problem) {
    // Couplings and start of the link belong to its model.
    settings.change({ modelFile: "", packedModel: "", model: "", alpha: {}, start: 0, startFrame: 0 });
    await say(app, problem);
    return false;
  }
}

/**
 * Opens the model of an address that the visitor has followed. After a problem everything is as before, and also
 * when the visitor has asked for something else meanwhile.
 */
export async function follow(app: Stores, fragment: string, isNewest: () => boolean): Promise<void> {
  const { settings, model, training } = app;
  const stay = () => settings.address.writeSoon(settings.written);
  try {
    const link = readSettings(fragment);
    const text = await documentOf(link);
    if (!isNewest()) return;
    if (hasNoCouplings(text)) {
      return await show(app, text, link, () => {
        settings.takeFragment(fragment);
        model.restart();
      });
    }
    if (training.busy) throw new Error(lab().files.trainingRuns);
    if (!(await mayLose(stageWork(model, app.engine)))) return stay();
    if (!isNewest()) return;
    await model.openLinked(text, () => settings.takeFragment(fragment));
    training.unchoose();
    app.takeMoment();
  } catch (problem) {
    if (!isNewest()) return;
    stay();
    await say(app, problem);
  }
}
