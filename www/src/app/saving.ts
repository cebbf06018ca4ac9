// Files that leave the page, to the visitor's own disk. Loaded when the first is asked for.
import type { ClipEntry } from "../clips/clips-store";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import type { App } from "./app";
import { clipOnStage } from "./caption";
import { modelName, motionName, plain, type RolledOut } from "./file-names";

/** What can be saved: the clip that is on the stage, or the model's motion and what belongs to it. */
export type Saved = "model" | "motion" | "latents" | "account";

interface File {
  name: string;
  type: string;
  text(): Promise<string>;
}

export async function save(app: App, what: Saved): Promise<void> {
  const file = fileOf(app, what);
  if (!file) return;
  try {
    download(file.name, new Blob([await file.text()], { type: file.type }));
  } catch (problem) {
    app.notices.addError(`${file.name} was not saved`, messageOf(problem));
  }
}

/** Null while there is nothing of the kind. */
function fileOf(app: App, what: Saved): File | null {
  const { engine } = app.engine;
  const clip = clipOnStage(app);
  if (engine && clip && what === "motion") {
    const { loaded, first, end } = clip;
    return { name: clipFile(clip), type: "text/plain", text: () => engine.clipBvh(loaded.id, first, end) };
  }
  const { model, rollout, id } = app.model;
  if (!engine || !model || !rollout) return null;
  if (what === "model") {
    return {
      name: `${modelName({ ...model, id })}.model.json`,
      type: "application/json",
      text: () => engine.modelJson(),
    };
  }
  const request = app.model.rolloutRequest();
  const { alpha, reading } = app.settings.values;
  const rolledOut: RolledOut = {
    info: model.info,
    id,
    alpha,
    reading,
    sequence: request.sequence,
    frame: request.frame,
    frames: request.frames,
  };
  const name = motionName(rolledOut);
  if (what === "motion") return { name: `${name}.bvh`, type: "text/plain", text: () => engine.rolloutBvh(request) };
  const files = () => import("./stage-files");
  if (what === "latents") {
    const text = async () => (await files()).rolloutCsv(model, await engine.rollout(request));
    return { name: `${name}.latents.csv`, type: "text/csv", text };
  }
  const about = { version: app.engine.version, file: `${name}.bvh` };
  const text = async () => (await files()).motionAccount(model, { ...rollout, request }, about);
  return { name: `${name}.made.json`, type: "application/json", text };
}

function clipFile({ title, first, end, loaded }: ClipEntry): string {
  const whole = first === 0 && end === loaded.info.frames;
  return `${plain(title) || "clip"}${whole ? "" : `-${first + 1}-${end}`}.bvh`;
}
