// For tests: the model that the page opens with, in the library itself.
import init, { Model } from "vcgpdm/inline";
import text from "../../first/model.json?raw";
import type { ModelInfo } from "./protocol";

export async function startModel() {
  await init();
  const model = Model.fromJson(text);
  return { model, info: model.info() as ModelInfo, text };
}
