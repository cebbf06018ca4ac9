// Files that leave the page, to the visitor's own disk.
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { download } from "../ui/download";
import { clipTitle, messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";

interface Stores {
  engine: EngineStore;
  model: ModelStore;
  notices: NoticesStore;
}

function baseName({ model }: ModelStore): string {
  const clip = clipTitle(model?.info.sequences[0]?.name ?? "model");
  const plain = clip.replace(/[^\p{L}\p{N}_-]+/gu, "-").replace(/^-+|-+$/g, "");
  return `${plain || "model"}-${model?.info.parts.length ?? 1}-parts`;
}

async function save(notices: NoticesStore, name: string, type: string, text: () => Promise<string>): Promise<void> {
  try {
    download(name, new Blob([await text()], { type }));
  } catch (problem) {
    notices.addError(`${name} was not saved`, messageOf(problem));
  }
}

export async function saveModel({ engine: { engine }, model, notices }: Stores): Promise<void> {
  if (engine) await save(notices, `${baseName(model)}.model.json`, "application/json", () => engine.modelJson());
}

/** The rollout on the stage, with the couplings as they are now. */
export async function saveMotion({ engine: { engine }, model, notices }: Stores): Promise<void> {
  if (engine)
    await save(notices, `${baseName(model)}.bvh`, "text/plain", () => engine.rolloutBvh(model.rolloutRequest()));
}
