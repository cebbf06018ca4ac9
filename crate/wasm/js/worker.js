// The worker of `train`: one message with clips or tables and settings begins a training.
import init from "./load.js";
import { setOf, trainSet } from "./train.js";

addEventListener("message", async ({ data: { states, settings, wasm } }) => {
  try {
    await init(wasm);
    postMessage({ ready: true });
    const report = (progress) => postMessage({ progress });
    const model = await trainSet(setOf(states), settings, report);
    postMessage({ model: model.toJson() });
  } catch (error) {
    const { name, message, code } = error;
    postMessage({ error: { name, message, code } });
  }
});
