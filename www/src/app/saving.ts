// Saves files to the visitor's disk. Loaded at the first use.
import { type ClipEntry, noteOf } from "../clips/clips-store";
import { plain, modelName } from "../couplings/model-file";
import type { Figure, JointInfo, Motion, PartSpec, ModelInfo, Reading } from "../engine/protocol";
import type { App } from "./app";
import { otherModelOnStage } from "./any-model";
import { clipOnStage } from "./caption";
import { type SavedFile, saveFile } from "./save-file";
import { modelOnStage } from "./stage-model";
import type { ChangedCouplings } from "../settings/settings";
import { clipTitle } from "../ui/format";

/** The most changed couplings in a name; of more the name has the number. */
const NAMED = 3;

export interface RolledOut {
  info: Pick<ModelInfo, "parts" | "sequences" | "frameTime">;
  /** The first digits of the hash of the model's document. */
  id: string;
  alpha: ChangedCouplings;
  reading: Reading;
  /** The training sequence that begins the motion. */
  sequence: number;
  /** The frame of that sequence; absent: the first. */
  frame?: number | undefined;
  /** The seed of a sampled motion. */
  sample?: number | undefined;
  /** The title of the clip that begins the motion in place of a sequence. */
  clip?: string | undefined;
  frames: number;
}

/** The name of the model and the differences of this motion: "...-lower-upper-5-as-35_02-10s". */
export function motionName(motion: RolledOut): string {
  const { info, sequence, frame, frames, clip, sample } = motion;
  const start = info.sequences[sequence];
  const words = [modelName(motion), ...couplingWords(motion)];
  if (clip) words.push(`as-${plain(clip) || "clip"}`);
  else if (sequence > 0 && start) words.push(`as-${plain(clipTitle(start.name)) || sequence + 1}`);
  if (frame) words.push(`from-${frame + 1}`);
  if (sample) words.push(`sample-${sample}`);
  words.push(`${Number((frames * info.frameTime).toFixed(1))}s`);
  return words.join("-");
}

function couplingWords({ info, alpha, reading }: RolledOut): string[] {
  const changed = Object.entries(alpha);
  if (changed.length === 0) return [];
  const name = (part: string | undefined) => plain(info.parts[Number(part)]?.name ?? "") || String(part);
  const words = changed.slice(0, NAMED).map(([pair, value]) => {
    const [source, target] = pair.split(".");
    return `${name(source)}-${name(target)}-${Number(value.toPrecision(4))}`;
  });
  // Motions that differ only in couplings outside the name have different checksums.
  if (changed.length > NAMED)
    words.push(`and-${changed.length - NAMED}-more-${checksum(JSON.stringify(changed))}`);
  return reading === "re-inferred" ? [...words, "re-inferred"] : words;
}

/** Four hexadecimal digits that nearly always differ for different texts (FNV-1a, folded). */
function checksum(text: string): string {
  let hash = 0x811c9dc5;
  for (const character of text) hash = Math.imul(hash ^ character.charCodeAt(0), 0x01000193);
  return ((hash ^ (hash >>> 16)) & 0xffff).toString(16).padStart(4, "0");
}

/** The kinds of files: of the clip on the stage, or of the model and its motion. */
export type Saved = "model" | "motion" | "glb" | "positions" | "latents" | "account";

/** A motion on the stage, which can be saved in three formats. */
interface StageMotion {
  /** Without a file extension. */
  name: string;
  body: { figure: Figure; joints: readonly JointInfo[]; parts: readonly PartSpec[] };
  motion(): Promise<Motion>;
  bvh(): Promise<string>;
}

export async function save(app: App, what: Saved): Promise<void> {
  const file = fileOf(app, what);
  if (file) await saveFile(app, file);
}

/** The name of the files of the motion on the stage, without extension. */
export const fileNameOf = (app: App): string =>
  (movedClip(app) ?? movedOther(app) ?? movedModel(app))?.name ?? "motion";

/** Null: there is nothing of this kind now. */
function fileOf(app: App, what: Saved): SavedFile | null {
  if (what === "motion" || what === "glb" || what === "positions") {
    const moved = movedClip(app) ?? movedOther(app) ?? movedModel(app);
    return moved && motionFile(moved, what);
  }
  if (what === "model") return modelOnStage(app);
  const shown = clipOnStage(app);
  if (shown && what === "account") {
    const name = clipName(shown);
    const about = { version: app.engine.version, file: `${name}.bvh` };
    const content = async () => (await files()).clipAccount(shown, noteOf(shown), about);
    return { name: `${name}.made.json`, type: "application/json", content };
  }
  const { engine } = app.engine;
  const { model, rollout } = app.model;
  const name = rolledOutName(app);
  if (!engine || !model || !rollout || name === null) return null;
  const request = app.model.rolloutRequest();
  if (what === "latents") {
    const content = async () => (await files()).rolloutCsv(model, await engine.rollout(request));
    return { name: `${name}.latents.csv`, type: "text/csv", content };
  }
  const clip = app.model.clipStart?.title;
  const about = { version: app.engine.version, file: `${name}.bvh`, ...(clip ? { clip } : {}) };
  const content = async () => (await files()).motionAccount(model, { ...rollout, request }, about);
  return { name: `${name}.made.json`, type: "application/json", content };
}

const files = () => import("./stage-files");

function motionFile(
  { name, body, motion, bvh }: StageMotion,
  what: "motion" | "glb" | "positions",
): SavedFile {
  if (what === "motion") return { name: `${name}.bvh`, type: "text/plain", content: bvh };
  if (what === "positions") {
    const content = async () => (await files()).positionsCsv(body, await motion());
    return { name: `${name}.positions.csv`, type: "text/csv", content };
  }
  const content = async () => {
    const { motionGlb } = await import("../scene/glb");
    return motionGlb(await bvh(), { ...body, motion: await motion() });
  };
  return { name: `${name}.glb`, type: "model/gltf-binary", content };
}

function movedClip(app: App): StageMotion | null {
  const { clips } = app.engine;
  const clip = clipOnStage(app);
  const { content } = app.stage;
  if (!clips || !clip || content?.kind !== "clip") return null;
  const { loaded, source, first, end } = clip;
  return {
    name: clipName(clip),
    body: { ...loaded.info, parts: content.parts },
    // Only the frames that the cut keeps.
    motion: async () => content.motion,
    bvh: () => clips.clipBvh({ id: loaded.id, source, first, end }),
  };
}

/** Of a model without couplings. */
function movedOther({ stage }: App): StageMotion | null {
  const made = otherModelOnStage(stage);
  if (!made) return null;
  const { name, motion, bvh, byHand, ...body } = made;
  return {
    name: `${plain(name) || made.kind}${byHand ? "-by-hand" : ""}`,
    body,
    motion: async () => motion,
    bvh: async () => bvh,
  };
}

function movedModel(app: App): StageMotion | null {
  const { engine } = app.engine;
  const { model } = app.model;
  const name = rolledOutName(app);
  if (!engine || !model || name === null) return null;
  const request = app.model.rolloutRequest();
  return {
    name,
    body: model.info,
    motion: async () => (await engine.rollout(request)).motion,
    bvh: () => engine.rolloutBvh(request),
  };
}

/** The name of the files of the model's motion, without extension; null: there is no motion. */
function rolledOutName(app: App): string | null {
  const { model, rollout, id } = app.model;
  if (!model || !rollout) return null;
  const { alpha, reading } = app.settings.values;
  const { sequence, frame, frames, sample } = app.model.rolloutRequest();
  const clip = app.model.clipStart?.title;
  return motionName({ info: model.info, id, alpha, reading, sequence, frame, frames, clip, sample });
}

/** The name of a clip that was made live says so. */
function clipName(clip: ClipEntry): string {
  const { first, end, loaded, source } = clip;
  const title = noteOf(clip) && "name" in source ? source.name : clip.title;
  const whole = first === 0 && end === loaded.info.frames;
  return `${plain(title) || "clip"}${whole ? "" : `-${first + 1}-${end}`}`;
}
