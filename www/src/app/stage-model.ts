// The model on the stage as a file: one without couplings in front, or the model with couplings.
import { modelFile, plain } from "../couplings/model-file";
import { otherModelOnStage } from "./any-model";
import type { App } from "./app";
import type { SavedFile } from "./save-file";

export interface StageModel extends SavedFile {
  content(): Promise<string>;
  /** Whether a link without the model in it opens it: it is the page's own, or in a file of the page's host. */
  isOnHost: boolean;
}

/** Null without a model. */
export function modelOnStage({ stage, model, engine, settings }: App): StageModel | null {
  const other = otherModelOnStage(stage);
  if (other) {
    const name = `${plain(other.name) || other.kind}.model.json`;
    const content = async () => other.text;
    return { name, type: "application/json", content, isOnHost: other.modelFile !== "" };
  }
  const file = engine.engine && modelFile(model, engine.engine);
  if (!file) return null;
  const isOnHost = model.openedText === null || settings.values.modelFile !== "";
  return { ...file, isOnHost, saved: () => model.markSaved() };
}
