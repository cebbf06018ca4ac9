// Models of kinds without couplings: their motion moves on the stage in front of the model, whose couplings stay.
// Loaded at the first use.
import { wholeWorkers } from "../engine/whole-workers";
import type { MadeMotion } from "../engine/whole-protocol";
import { modelStyle } from "../figures/model-style";
import type { SettingsStore } from "../settings/settings-store";
import type { StageContent, StageStore } from "../stage/stage-store";
import { lab } from "../words/lab";

/** The key of such a motion on the stage; keys of clips begin with "made-" or "own-". */
const KEY = "other-model";

/** A motion with the document of its model and the name of the file. */
type ShownMotion = MadeMotion & { name: string; text: string };

const shown = new WeakMap<StageContent, ShownMotion>();

/** Rolls the model out and shows its motion. `name`: that of its file. */
export async function showAnyModel(
  { stage, settings }: { stage: StageStore; settings: SettingsStore },
  name: string,
  text: string,
  workers = wholeWorkers(),
): Promise<void> {
  const { frames } = settings.values;
  const made = await workers.desk.run((worker) => worker.rollOutAny(text, frames));
  const { figure, joints, parts, motion, kind } = made;
  const words = lab().stage.otherKind;
  const caption = { title: words.made(modelStyle(kind).name), text: words.noCouplings };
  const names = joints.map(({ name }) => name);
  const content: StageContent = { kind: "clip", clip: KEY, figure, joints: names, parts, motion, caption };
  shown.set(content, { ...made, name: name.replace(/(\.model)?\.json$/i, ""), text });
  stage.showClip(content);
}

/** The motion on the stage, where another kind of model has made it. */
export const motionOnStage = ({ content }: StageStore) => (content && shown.get(content)) ?? null;
