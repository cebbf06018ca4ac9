// Saves files to the visitor's disk. Loaded at the first use.
import type { ClipEntry } from "../clips/clips-store";
import { modelFile, plain } from "../couplings/model-file";
import type { Figure, JointInfo, Motion, PartSpec } from "../engine/protocol";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import type { App } from "./app";
import { motionOnStage } from "./any-model";
import { clipOnStage } from "./caption";
import { motionName } from "./file-names";
import { lab } from "../words/lab";

/** The kinds of files: of the clip on the stage, or of the model and its motion. */
export type Saved = "model" | "motion" | "glb" | "positions" | "latents" | "account";

interface File {
  name: string;
  type: string;
  content(): Promise<string | ArrayBuffer>;
}

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
  if (!file) return;
  try {
    download(file.name, new Blob([await file.content()], { type: file.type }));
    // In front of the model there may be one of another kind.
    if (what === "model" && !motionOnStage(app.stage)) app.model.markSaved();
  } catch (problem) {
    app.notices.addError(lab().files.notSaved(file.name), messageOf(problem));
  }
}

/** Null: there is nothing of this kind now. */
function fileOf(app: App, what: Saved): File | null {
  if (what === "motion" || what === "glb" || what === "positions") {
    const moved = movedClip(app) ?? movedOther(app) ?? movedModel(app);
    return moved && motionFile(moved, what);
  }
  const other = motionOnStage(app.stage);
  if (what === "model" && other) {
    const file = `${plain(other.name) || other.kind}.model.json`;
    return { name: file, type: "application/json", content: async () => other.text };
  }
  const { engine } = app.engine;
  const { model, rollout } = app.model;
  const name = rolledOutName(app);
  if (!engine || !model || !rollout || name === null) return null;
  if (what === "model") return modelFile(app.model, engine);
  const request = app.model.rolloutRequest();
  if (what === "latents") {
    const content = async () => (await files()).rolloutCsv(model, await engine.rollout(request));
    return { name: `${name}.latents.csv`, type: "text/csv", content };
  }
  const about = { version: app.engine.version, file: `${name}.bvh` };
  const content = async () => (await files()).motionAccount(model, { ...rollout, request }, about);
  return { name: `${name}.made.json`, type: "application/json", content };
}

const files = () => import("./stage-files");

function motionFile({ name, body, motion, bvh }: StageMotion, what: "motion" | "glb" | "positions"): File {
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
  const made = motionOnStage(stage);
  if (!made) return null;
  const { name, motion, bvh, figure, joints, parts } = made;
  const body = { figure, joints, parts };
  return { name: plain(name) || made.kind, body, motion: async () => motion, bvh: async () => bvh };
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
  const { sequence, frame, frames } = app.model.rolloutRequest();
  return motionName({ info: model.info, id, alpha, reading, sequence, frame, frames });
}

function clipName({ title, first, end, loaded }: ClipEntry): string {
  const whole = first === 0 && end === loaded.info.frames;
  return `${plain(title) || "clip"}${whole ? "" : `-${first + 1}-${end}`}`;
}
