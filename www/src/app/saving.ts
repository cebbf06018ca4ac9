// Files that leave the page, to the visitor's own disk.
import type { App } from "./app";
import { download } from "../ui/download";
import { clipTitle, messageOf } from "../ui/format";

function baseName(app: App): string {
  const clip = clipTitle(app.model?.info.sequences[0]?.name ?? "model");
  const plain = clip.replace(/[^\p{L}\p{N}_-]+/gu, "-").replace(/^-+|-+$/g, "");
  return `${plain || "model"}-${app.model?.info.parts.length ?? 1}-parts`;
}

async function save(app: App, name: string, type: string, text: () => Promise<string>): Promise<void> {
  try {
    download(name, new Blob([await text()], { type }));
  } catch (problem) {
    app.notify({ kind: "error", title: `${name} was not saved`, text: messageOf(problem), at: null });
  }
}

export async function saveModel(app: App): Promise<void> {
  if (!app.engine || !app.model) return;
  await save(app, `${baseName(app)}.model.json`, "application/json", () => app.engine!.modelJson());
}

/** The rollout on the stage, with the couplings as they are now. */
export async function saveMotion(app: App): Promise<void> {
  if (!app.engine || !app.model) return;
  await save(app, `${baseName(app)}.bvh`, "text/plain", () => app.engine!.rolloutBvh(app.rolloutRequest()));
}
