// Reads the records of an earlier visit. Records may be junk, half written or of another version of the page,
// so each piece is checked and left out when it cannot be read.
import type { Health, TrainedModel } from "../engine/protocol";
import type { Run } from "../training/runs";
import { type Check, has, isBoolean, isListOf, isNullOr, isNumber, isOneOf, isText } from "../ui/checks";
import { type Counts, countsOf, contentsText, type Holdings, type StoredLibrary } from "./records";

/** `Date` knows no times beyond these milliseconds. */
const LAST_TIME = 8.64e15;
const isTime: Check = (value) => isNumber(value) && Math.abs(value as number) <= LAST_TIME;

const isClipSource: Check = (value) =>
  has({ sample: isText })(value) || has({ name: isText, file: isText })(value);
const clipFields = { id: isNumber, title: isText, source: isClipSource, first: isNumber, end: isNumber };
const isClip = has({
  ...clipFields,
  key: isText,
  origin: isOneOf("own", "made", "model"),
  ticked: isBoolean,
});

/** Version 0.2 wrote these states with spaces, and one with "the". */
const healthState = (state: string) =>
  state.replaceAll(" ", "-").replace("leaves-the-training-range", "leaves-training-range");
const HEALTH_STATES = [
  "moves-on",
  "rests-as-recorded",
  "visits-few-poses",
  "stands-still",
  "keeps-one-pose",
  "leaves-training-range",
  "shakes",
  "not-finite",
];

const isHealth = has({
  state: (state) => isText(state) && HEALTH_STATES.includes(healthState(state as string)),
  from: isNullOr(isNumber),
  part: isNullOr(isNumber),
  rank: isNumber,
  parts: (value) => value === undefined || isListOf(has({ visited: isNullOr(isNumber) }))(value),
});
const isModel = has({
  text: isText,
  latents: isListOf((value) => value instanceof Float64Array),
  health: isNullOr(isHealth),
  error: (value) => value === undefined || isNullOr(isNumber)(value),
});
const isSettings = has({
  parts: isListOf(has({ name: isText, joints: isListOf(isNumber) })),
  latent: isNumber,
  dynamicsIps: isNumber,
  poseIps: isNumber,
  order: isNumber,
  framesPerSecond: isNumber,
  seed: isNumber,
  maxIterations: isNumber,
});
const isStep = has({
  iteration: isNumber,
  bound: isNumber,
  best: isNumber,
  fraction: isNumber,
  setbacks: has({ jittered: isNumber, turnedBack: isNumber }),
});
const isRun = has({
  id: isNumber,
  settings: isSettings,
  clips: isListOf(has(clipFields)),
  state: isOneOf("waiting", "running", "done", "cancelled", "failed"),
  steps: isListOf(isStep),
  elapsed: isNumber,
  ending: isText,
  model: isNullOr(isModel),
  portion: isNumber,
  open: isBoolean,
});
const isLibrary = has({ text: isText, title: isText, unsaved: isBoolean });

/** A model with the fields of today. Earlier versions wrote no error. */
function upToDate(model: Run["model"]): Run["model"] {
  return model && withHealth({ ...model, error: model.error ?? null });
}

function withHealth(model: TrainedModel): TrainedModel {
  if (!model.health) return model;
  const state = healthState(model.health.state) as typeof model.health.state;
  // Version 0.2 wrote no poses of the parts, and 2 as the highest rank.
  const { parts, rank, pace } = model.health as Partial<Health>;
  const earlier = parts ? { pace: pace ?? null } : { parts: [], pace: null, rank: rank === 2 ? 3 : rank };
  return { ...model, health: { ...model.health, state, ...earlier } as Health };
}

export interface Recovered {
  /** When the visit was last written, in milliseconds since 1970; null: unknown. */
  at: number | null;
  holdings: Holdings;
  /** What the holdings are, such as "2 clips and a training"; empty when there is nothing to bring back. */
  contents: string;
  counts: Counts;
  /** Whether all records could be read. */
  whole: boolean;
}

/** Reads whatever can be read from the records of a visit. */
export function recover(records: ReadonlyMap<string, unknown>): Recovered {
  let whole = true;
  const leaveOut = () => {
    whole = false;
    return null;
  };
  /** A record that a visit may lack. */
  const optional = <Value>(name: string, check: Check): Value | null => {
    const value = records.get(name);
    if (value === undefined) return null;
    return check(value) ? (value as Value) : leaveOut();
  };
  const checked = <Value>(value: unknown, check: Check): Value | null =>
    check(value) ? (value as Value) : leaveOut();
  /** A clip with its file in place of the name of the file's record. */
  const withFile = <Clip>(clip: unknown): Clip | null => {
    const { source } = clip as { source: { sample: string } | { name: string; file: string } };
    if (!("file" in source)) return clip as Clip;
    const file = checked<Blob>(records.get(source.file), (value) => value instanceof Blob);
    return file && ({ ...(clip as object), source: { name: source.name, file } } as Clip);
  };
  const clipsOf = <Clip>(clips: readonly unknown[], check: Check): Clip[] =>
    clips.flatMap((clip) => {
      const readable = checked<object>(clip, check);
      return (readable && withFile<Clip>(readable)) ?? [];
    });

  const about = checked<object>(records.get("about"), has({})) ?? {};
  /** A field of the record about the others. */
  const field = <Value>(name: string, check: Check, otherwise: Value): Value =>
    checked<Value>((about as Record<string, unknown>)[name], check) ?? otherwise;

  const listed = field<number[]>("order", isListOf(isNumber), []).map((id) => `run ${id}`);
  const others = [...records.keys()].filter((name) => name.startsWith("run ") && !listed.includes(name));
  if (others.length > 0) whole = false;
  const runs = [...listed, ...others].flatMap((name): Run[] => {
    const run = checked<Run>(records.get(name), isRun);
    if (!run) return [];
    const clips = clipsOf<Run["clips"][number]>(run.clips, has(clipFields));
    // A training without one of its clips is another training.
    return clips.length === run.clips.length ? [{ ...run, clips, model: upToDate(run.model) }] : [];
  });
  const chosen = field<number | null>("chosen", isNullOr(isNumber), null);
  const holdings: Holdings = {
    fragment: field("fragment", isText, ""),
    clips: clipsOf(
      checked<unknown[]>(
        records.get("clips"),
        isListOf(() => true),
      ) ?? [],
      isClip,
    ),
    firstBones: field("firstBones", isBoolean, false),
    runs,
    chosen: runs.find(({ id }) => id === chosen) ?? null,
    model: optional<string>("model", isText),
    results: optional<string>("results", isText),
    // Earlier versions did not write this, so that the model and the results may be on no disk.
    unsaved:
      "unsaved" in about
        ? field("unsaved", has({ model: isBoolean, results: isBoolean }), { model: true, results: true })
        : { model: true, results: true },
    library: optional<StoredLibrary>("library", isLibrary),
  };
  const at = field<number | null>("at", isTime, null);
  const counts = countsOf(holdings);
  return { at, holdings, counts, contents: contentsText(counts), whole };
}
