// `train`: a whole training in one call, in a worker or here in short steps.
import { Clip, Model, Table, Trainer, TrainingSet } from "./glue.js";

/** Milliseconds from one report to the next, and of the longest stretch without a pause. */
const PAUSE = 50;

/** A value for an error message, as the wasm names values. */
function found(value) {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "function") return "function";
  if (typeof value !== "object" || value === null) return String(value);
  const name = value.constructor?.name;
  return Array.isArray(value) ? "a list" : name && name !== "Object" ? `an instance of ${name}` : "an object";
}

function refuse(code, expected, value) {
  const error = new Error(`${expected}, found ${found(value)}`);
  throw Object.assign(error, { name: "VcgpdmError", code });
}

/** The clips or tables as a list. */
function listOf(data) {
  const list = Array.isArray(data) ? data : [data];
  for (const item of list)
    if (!(item instanceof Clip || item instanceof Table))
      refuse("argument", "expected an instance of Clip or of Table, or a list of them", item);
  return list;
}

/** The settings without the functions that watch. */
function divided(options = {}) {
  if (typeof options !== "object" || options === null || Array.isArray(options))
    refuse("settings", "settings: expected an object", options);
  const { onProgress, signal, ...settings } = options;
  if (typeof (onProgress ?? divided) !== "function")
    refuse("settings", "settings: `onProgress`: expected a function", onProgress);
  if (signal && typeof signal.throwIfAborted !== "function")
    refuse("settings", "settings: `signal`: expected an AbortSignal", signal);
  return { onProgress, signal, settings };
}

/** A clip or table as plain data. */
function stateOf(item) {
  if (!(item instanceof Table)) return { clip: item.state() };
  const { name, columns, frameTime } = item.info();
  return { table: { name, columns, frameTime, values: item.values() } };
}

/** Adds a clip or table to a set. */
function add(set, item) {
  if (item instanceof Table) set.addTable(item);
  else set.add(item);
}

/** The set of plain data. */
export function setOf(states) {
  const set = new TrainingSet();
  for (const { clip, table } of states) {
    const item = clip
      ? Clip.fromState(clip)
      : Table.of(table.name, table.columns, table.values, table.frameTime);
    add(set, item);
    item.free();
  }
  return set;
}

/** Trains a set to the end; pauses and reports from time to time. */
export async function trainSet(set, settings, onProgress, signal) {
  let trainer;
  try {
    trainer = new Trainer(set, settings);
    for (;;) {
      const end = performance.now() + PAUSE;
      let progress;
      do progress = trainer.step();
      while (!progress.done && performance.now() < end);
      onProgress?.(progress);
      if (progress.done) return trainer.model();
      await new Promise((resume) => setTimeout(resume));
      signal?.throwIfAborted();
    }
  } finally {
    trainer?.free();
    set.free();
  }
}

/** Trains in this thread. */
export async function trainHere(data, options) {
  const { onProgress, signal, settings } = divided(options);
  const list = listOf(data);
  signal?.throwIfAborted();
  const set = new TrainingSet();
  for (const item of list) add(set, item);
  return trainSet(set, settings, onProgress, signal);
}

/** Trains in the worker that `start` starts; here if it does not start. */
export async function trainIn(start, wasm, data, options) {
  const { onProgress, signal, settings } = divided(options);
  signal?.throwIfAborted();
  const states = listOf(data).map(stateOf);
  // A Request or Response cannot be sent, and was used up by this thread.
  const address =
    typeof wasm === "string" || wasm instanceof URL ? String(new URL(wasm, location.href)) : undefined;
  let worker;
  try {
    worker = start();
  } catch {
    return trainHere(data, options);
  }
  const outcome = new Promise((resolve, reject) => {
    signal?.addEventListener("abort", () => reject(signal.reason), { once: true });
    let began = false;
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (began) reject(new Error(event.message));
      else resolve(trainHere(data, options));
    };
    worker.onmessage = ({ data: message }) => {
      began = true;
      if (message.progress) onProgress?.(message.progress);
      if (message.model) resolve(Model.fromJson(message.model));
      if (message.error) reject(Object.assign(new Error(message.error.message), message.error));
    };
    worker.postMessage({ states, settings, wasm: address });
  });
  return outcome.finally(() => worker.terminate());
}
