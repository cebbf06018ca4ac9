// Models other than a vCGPDM or vGPDM: their motion moves on the stage in front of the model, whose couplings stay.
// Loaded at the first use.
import type { WholeWorkers } from "../engine/whole-workers";
import type { ByHand, Drag, MadeMotion } from "../engine/whole-protocol";
import type { Playback } from "../stage/playback";
import type { NoticesStore } from "../ui/notices-store";
import { loadPerforming, performingWords } from "../words/sections";
import type { WordsStore } from "../words/words";
import { modelStyle } from "../figures/model-style";
import type { SettingsStore } from "../settings/settings-store";
import type { StageContent, StageStore } from "../stage/stage-store";
import { messageOf, sentence } from "../ui/format";
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
  /** Whether the visitor has changed the motion. */
  byHand: boolean;
}

const shown = new WeakMap<StageContent, OtherModel>();

/** A link that brings a model. */
interface BringingLink {
  /** The length of the motion. */
  frames: number;
  /** Takes the settings of the link, once the document has proved to be a model. */
  take(): void;
}

/** What the page gives. */
interface Stage {
  stage: StageStore;
  playback: Playback;
  settings: SettingsStore;
  workers: WholeWorkers;
  notices: NoticesStore;
  words: WordsStore;
}

/** Rolls the model out and shows its motion. `name`: that of its file. `link`: null for a visitor's file. */
export async function showAnyModel(
  app: Stage,
  { name, text, link }: { name: string; text: string; link: BringingLink | null },
): Promise<void> {
  const { stage, settings, workers } = app;
  const { frames } = link ?? settings.values;
  const roll = (handles?: ByHand, drag?: Drag) =>
    workers.desk.run((worker) => worker.rollOutAny(text, frames, handles, drag));
  const made = await roll();
  const isMap = made.kind === "map-cgpdm";
  const hasHandles = isMap || /tmp|dmp/.test(made.kind);
  const [module] = await Promise.all(
    hasHandles
      ? [import("../live/handles-store"), import("../live/handles-view"), loadPerforming(app.words)]
      : [],
  );
  link?.take();
  const { modelFile, packedModel } = settings.values;
  const caption = {
    title: lab().stage.madeBy(modelStyle(made.kind).name),
    text: hasHandles ? performingWords().handles[isMap ? "captionMap" : "caption"] : "",
  };
  const named = { text, name: name.replace(/(\.model)?\.json$/i, ""), modelFile: link ? modelFile : "" };
  let content: StageContent | null = null;
  const show = (now: MadeMotion) => {
    const { figure, parts, motion } = now;
    const joints = now.joints.map(({ name }) => name);
    content = { kind: "clip", clip: OTHER_MODEL, figure, joints, parts, motion, caption };
    if (now !== made) content.ghost = made.motion;
    if (controls) content.controls = controls;
    shown.set(content, { ...now, ...named, byHand: store?.isAsLearned === false });
    stage.showClip(content);
  };
  const isShown = () => stage.content === content;
  const failed = (problem: unknown) => app.notices.addError(caption.title, sentence(messageOf(problem)));
  const store = module && new module.HandlesStore(app.playback, made, isShown, roll, show, failed);
  const controls = store && Object.assign(document.createElement("pg-handles"), { handles: store });
  show(made);
  if (!link) return;
  // The address brings this model as long as the model is on the stage.
  const stop = stage.on(() => {
    if (isShown()) return;
    stop();
    const now = settings.values;
    if (now.modelFile === modelFile && now.packedModel === packedModel)
      settings.change({ modelFile: "", packedModel: "" });
  });
}

/** The model on the stage, if it is one without couplings. */
export const otherModelOnStage = ({ content }: StageStore) => (content && shown.get(content)) ?? null;
