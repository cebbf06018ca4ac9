// The model on the stage as a file on the visitor's disk.
import type { Engine, ModelInfo } from "../engine/protocol";
import { download } from "../ui/download";
import { clipTitle } from "../ui/format";
import type { ModelStore } from "./model-store";

/** Letters, digits and single hyphens: a name on every system. */
export function plain(text: string): string {
  return text.replace(/[^\p{L}\p{N}_.]+/gu, "-").replace(/^[-.]+|[-.]+$/g, "");
}

/** "35_01-2-parts-1a2b3c4d". `id`: the first digits of the hash of the model's document. */
export function modelName({
  info,
  id,
}: {
  info: Pick<ModelInfo, "parts" | "sequences">;
  id: string;
}): string {
  const clip = plain(clipTitle(info.sequences[0]?.name ?? "")) || "model";
  const parts = info.parts.length === 1 ? "1-part" : `${info.parts.length}-parts`;
  return `${clip}-${parts}-${id}`;
}

/** Null without a model. */
export function modelFile(
  { model, id }: Pick<ModelStore, "model" | "id">,
  engine: Pick<Engine, "modelJson">,
) {
  if (!model) return null;
  return {
    name: `${modelName({ ...model, id })}.model.json`,
    type: "application/json",
    content: () => engine.modelJson(),
  };
}

/** Saves the model, if there is one, to the visitor's disk. */
export async function saveModel(
  store: Pick<ModelStore, "model" | "id" | "markSaved">,
  engine: Pick<Engine, "modelJson">,
): Promise<void> {
  const file = modelFile(store, engine);
  if (!file) return;
  download(file.name, new Blob([await file.content()], { type: file.type }));
  store.markSaved();
}
