// Models of kinds without couplings: their motion moves on the stage in front of the model, whose couplings stay.
// Loaded at the first use.
import type { WholeWorkers } from "../engine/whole-workers";
import type { MadeMotion } from "../engine/whole-protocol";
import { modelStyle } from "../figures/model-style";
import type { SettingsStore } from "../settings/settings-store";
import type { StageContent, StageStore } from "../stage/stage-store";
import { lab } from "../words/lab";
import { OTHER_MODEL } from "../couplings/model-document";

/** A model without couplings on the stage, with its motion. */
interface OtherModel extends MadeMotion {
  /** That of its file, without extension; empty: it came in a link. */
  name: string;
  /** Its document. */
  text: string;
  /** The file on the page's host that the address names; empty: none. */
  modelFile: string;
}

const shown = new WeakMap<StageContent, OtherModel>();

/** A link that brings a model. */
interface BringingLink {
  /** The length of the motion. */
  frames: number;
  /** Takes the settings of the link, once the document has proved to be a model. */
  take(): void;
}

/** Rolls the model out and shows its motion. `name`: that of its file. `link`: null for a visitor's file. */
export async function showAnyModel(
  { stage, settings, workers }: { stage: StageStore; settings: SettingsStore; workers: WholeWorkers },
  { name, text, link }: { name: string; text: string; link: BringingLink | null },
): Promise<void> {
  const { frames } = link ?? settings.values;
  const made = await workers.desk.run((worker) => worker.rollOutAny(text, frames));
  const { figure, joints, parts, motion, kind } = made;
  const words = lab().stage.otherKind;
  const caption = { title: words.made(modelStyle(kind).name), text: words.noCouplings };
  const names = joints.map(({ name }) => name);
  const content: StageContent = {
    kind: "clip",
    clip: OTHER_MODEL,
    figure,
    joints: names,
    parts,
    motion,
    caption,
  };
  link?.take();
  const { modelFile, packedModel } = settings.values;
  shown.set(content, {
    ...made,
    text,
    name: name.replace(/(\.model)?\.json$/i, ""),
    modelFile: link ? modelFile : "",
  });
  stage.showClip(content);
  if (!link) return;
  // The address brings this model as long as the model is on the stage.
  const stop = stage.on(() => {
    if (stage.content === content) return;
    stop();
    const now = settings.values;
    if (now.modelFile === modelFile && now.packedModel === packedModel)
      settings.change({ modelFile: "", packedModel: "" });
  });
}

/** The model on the stage, if it is one without couplings. */
export const otherModelOnStage = ({ content }: StageStore) => (content && shown.get(content)) ?? null;
