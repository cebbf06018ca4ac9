// The measurements of crate/lab/examples/speed.rs with the wasm package; runs in Node and in a browser.

/**
 * Median milliseconds of one bound with its gradient.
 * @param {any} wasm the package, built with the feature `speed`
 * @param {string} text a golden case
 */
export function evaluation(wasm, text) {
  const found = wasm.Case.fromJson(text);
  const times = [];
  let bound = NaN;
  // The first ones are not counted: the engine compiles a function again when it is called often.
  for (let i = 0; i < 400; i++) {
    const start = performance.now();
    bound = found.boundWithGradient();
    if (i >= 100) times.push(performance.now() - start);
  }
  found.free();
  times.sort((a, b) => a - b);
  return { bound, median_ms: times[times.length >> 1] };
}

/** Frames of the two inferences whose times are compared. Both are longer than the search for the beginning. */
const FEW = 20;
const MANY = 60;

/**
 * Milliseconds of one observed frame of all parts: filter and smoother. The least times of many count: another
 * program can only make a time longer.
 * @param {any} model
 * @param {any} clip a clip of two seconds or more
 */
export function observedFrame(model, clip) {
  const least = { [FEW]: Infinity, [MANY]: Infinity };
  for (let i = 0; i < 60; i++) {
    for (const frames of [FEW, MANY]) {
      const start = performance.now();
      model.infer(clip, frames);
      least[frames] = Math.min(least[frames] ?? Infinity, performance.now() - start);
    }
  }
  return ((least[MANY] ?? NaN) - (least[FEW] ?? NaN)) / (MANY - FEW);
}

/**
 * Seconds of a training on lower and upper body, and until 99.9 % of its bound.
 * @param {any} wasm
 * @param {[string, string][]} files names and texts of BVH files; without any, the bundled walks
 */
export function training(wasm, files) {
  const { Clip, Trainer, TrainingSet } = wasm;
  const bytes = new TextEncoder();
  const samples = () =>
    Clip.samples()
      .slice(0, 6)
      .map((/** @type {{ id: string }} */ { id }) => Clip.sample(id));
  const clips =
    files.length > 0 ? files.map(([name, text]) => Clip.read(name, bytes.encode(text))) : samples();
  const set = new TrainingSet();
  for (const clip of clips) set.add(clip);
  const { parts } = clips[0]
    .info()
    .presets.find((/** @type {{ id: string }} */ { id }) => id === "lower-upper");
  const start = performance.now();
  const trainer = new Trainer(set, {
    parts,
    latent: 3,
    dynamicsIps: 12,
    poseIps: 12,
    order: 2,
    framesPerSecond: 30,
    seed: 0,
    // The default of the native program.
    maxIterations: 250,
  });
  const trace = [];
  let last;
  do {
    last = trainer.step();
    trace.push({ seconds: (performance.now() - start) / 1000, best: last.best });
  } while (!last.done);
  const enough = last.best - 1e-3 * Math.abs(last.best);

  const model = trainer.model();
  const times = [];
  for (let i = 0; i < 200; i++) {
    const begin = performance.now();
    const rollout = model.rollout({ frames: 300, sequence: 0 });
    rollout.positions();
    times.push(performance.now() - begin);
    rollout.free();
  }
  times.sort((a, b) => a - b);
  return {
    bound: last.best,
    iterations: last.iteration,
    seconds: trace.at(-1)?.seconds,
    seconds_to_999: trace.find(({ best }) => best >= enough)?.seconds,
    rollout_ms: times[times.length >> 1],
    observed_frame_ms: observedFrame(model, clips[0]),
  };
}
