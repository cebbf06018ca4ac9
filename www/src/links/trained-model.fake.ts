// For tests: a model of a sample walk, trained and rolled out in the library itself.
import init, { Clip, Model, Trainer, TrainingSet } from "vcgpdm/inline";

/** The document of a model of two parts after a short training. */
export async function trainedDocument(): Promise<string> {
  await init();
  const clips = new TrainingSet();
  for (const id of ["walk-1", "walk-2"]) clips.add(Clip.sample(id));
  const trainer = new Trainer(clips, { parts: "lower,upper", seed: 1, maxIterations: 40 });
  while (!trainer.step().done);
  return trainer.model().toJson();
}

/**
 * Joint positions of ten seconds, in metres. `factor`: that of the coupling variances between different
 * parts, whose experts are inferred again.
 */
export function positions(document: string, factor: number): Float32Array {
  const model = Model.fromJson(document);
  const alpha = model
    .info()
    .alpha?.map((row, source) => row.map((value, target) => (source === target ? value : factor * value)));
  return model.rollout({ frames: 300, sequence: 0, alpha, reading: "re-inferred" }).positions();
}
