// The settings of the page in one table: names, limits and defaults. Writes them to the URL and reads them. A
// value from the URL passes the same limits as one from a control. No rendering.
import { MAX_PARTS } from "../engine/limits";
import type { PartSpec, Reading } from "../engine/protocol";
import { LAST_CHAPTER } from "./chapters";
import { type ViewName, VIEWS } from "./views";

interface Setting<T> {
  /** The name in the URL. */
  key: string;
  initial: T;
  /** The value of a text, not yet limited; null: the text is no value. */
  read(text: string): T | null;
  write(value: T): string;
  /** The nearest value within the limits; null when the value is not valid. */
  limit(value: T): T | null;
}

export interface NumberSetting extends Setting<number> {
  min: number;
  max: number;
  step: number;
}

/** Fewer inducing points than these cannot be chosen. */
export const FEWEST_POINTS = 2;

function whole(key: string, initial: number, min: number, max: number, step = 1): NumberSetting {
  return {
    key,
    initial,
    min,
    max,
    step,
    read: (text) => (/^\s*[-+]?\d+(\.\d*)?(e\d+)?\s*$/i.test(text) ? Number(text) : null),
    write: String,
    limit: (value) => (Number.isFinite(value) ? Math.round(Math.min(max, Math.max(min, value))) : null),
  };
}

export interface PointsSetting extends NumberSetting {
  /** Stands for 0 where the library gives no other number. */
  usual: number;
}

/** A number of inducing points; 0: the number that the library gives these clips. */
function points(key: string, most: number): PointsSetting {
  return { ...whole(key, 0, 0, most), usual: 12, limit: pointsWithin(most) };
}

const pointsWithin = (most: number) => (value: number) =>
  Number.isFinite(value)
    ? value < 1
      ? 0
      : Math.round(Math.min(most, Math.max(FEWEST_POINTS, value)))
    : null;

/** Three numbers from which the camera looks at the figure; none: from the usual side. */
const look: Setting<readonly number[]> = {
  key: "camera",
  initial: [],
  read(text) {
    const numbers = text.split(",").map(Number);
    return numbers.length === 3 && text.length < 60 ? numbers : null;
  },
  write: (numbers) => numbers.map((number) => Number(number.toFixed(3))).join(),
  limit: (numbers) => (numbers.every(Number.isFinite) && [0, 3].includes(numbers.length) ? numbers : null),
};

/** Seconds of the motion. */
const time: Setting<number> = {
  key: "time",
  initial: 0,
  read: (text) => (/^\d{1,4}(\.\d{1,4})?$/.test(text) ? Number(text) : null),
  write: (seconds) => String(Number(seconds.toFixed(3))),
  limit: (seconds) => (Number.isFinite(seconds) ? Math.max(0, seconds) : null),
};

function choice<T extends string | number>(
  key: string,
  initial: T,
  values: readonly T[],
): Setting<T> & { values: readonly T[] } {
  return {
    key,
    initial,
    values,
    read: (text) => values.find((value) => String(value) === text) ?? null,
    write: String,
    limit: (value) => (values.includes(value) ? value : null),
  };
}

function flag(key: string, initial: boolean): Setting<boolean> {
  return {
    key,
    initial,
    read: (text) => (text === "1" || text === "" ? true : text === "0" ? false : null),
    write: (value) => (value ? "1" : "0"),
    limit: (value) => value,
  };
}

/** Coupling variances below and above these have no visible effect. */
export const ALPHA_MIN = 1e-3;
export const ALPHA_MAX = 1e3;
const MAX_JOINT = 999;
const MAX_NAME = 24;

/** Couplings that differ from the learned ones, by "source.target". */
export type ChangedCouplings = Record<string, number>;

const changedCouplings: Setting<ChangedCouplings> = {
  key: "alpha",
  initial: {},
  read(text) {
    const changed: ChangedCouplings = {};
    for (const item of text.split(",").filter(Boolean)) {
      const [, source, target, value] = /^(\d)\.(\d):([\d.e+-]+)$/i.exec(item) ?? [];
      if (Number(source ?? MAX_PARTS) >= MAX_PARTS || Number(target) >= MAX_PARTS) return null;
      changed[`${source}.${target}`] = Number(value);
    }
    return changed;
  },
  /** Only the text of a coupling is rounded. */
  write: (changed) =>
    Object.entries(changed)
      .map(([pair, alpha]) => `${pair}:${Number(alpha.toPrecision(4))}`)
      .join(","),
  limit(changed) {
    const within: ChangedCouplings = {};
    for (const [pair, alpha] of Object.entries(changed)) {
      if (!Number.isFinite(alpha) || alpha <= 0) return null;
      within[pair] = Math.min(ALPHA_MAX, Math.max(ALPHA_MIN, alpha));
    }
    return within;
  },
};

/** The joints of a part, by their places in the skeleton: "0-8.12". */
function writeJoints(joints: readonly number[]): string {
  const sorted = [...new Set(joints)].sort((a, b) => a - b);
  const runs: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    let j = i;
    while (sorted[j + 1] === (sorted[j] ?? NaN) + 1) j += 1;
    runs.push(i === j ? `${sorted[i]}` : `${sorted[i]}-${sorted[j]}`);
    i = j + 1;
  }
  return runs.join(".");
}

function readJoints(text: string): number[] | null {
  const joints: number[] = [];
  for (const run of text.split(".").filter(Boolean)) {
    const match = /^(\d{1,3})(?:-(\d{1,3}))?$/.exec(run);
    if (!match) return null;
    const from = Number(match[1]);
    const to = Number(match[2] ?? from);
    if (to < from || to > MAX_JOINT) return null;
    for (let joint = from; joint <= to; joint++) joints.push(joint);
  }
  return joints;
}

/** A valid name of a part: colons and semicolons separate names and joints in the text of a split. */
export const partName = (text: string): string =>
  text.replace(/[;:]/g, " ").trim().slice(0, MAX_NAME).trimEnd();

const split: Setting<PartSpec[]> = {
  key: "split",
  initial: [],
  read(text) {
    const parts: PartSpec[] = [];
    for (const item of text.split(";").filter(Boolean)) {
      const colon = item.lastIndexOf(":");
      const joints = readJoints(item.slice(colon + 1));
      if (colon < 1 || !joints) return null;
      parts.push({ name: item.slice(0, colon), joints });
    }
    return parts;
  },
  write: (parts) => parts.map(({ name, joints }) => `${name}:${writeJoints(joints)}`).join(";"),
  limit(parts) {
    const taken = new Set<number>();
    for (const joint of parts.flatMap(({ joints }) => joints)) {
      if (taken.has(joint) || joint > MAX_JOINT) return null;
      taken.add(joint);
    }
    const named = parts.map(({ name, joints }) => ({
      name: partName(name),
      joints: [...joints].sort((a, b) => a - b),
    }));
    const names = new Set(named.map(({ name }) => name));
    return named.length <= MAX_PARTS && names.size === named.length && !names.has("") ? named : null;
  },
};

const preset: Setting<string> = {
  key: "parts",
  initial: "lower-upper",
  read: (text) => text,
  write: (value) => value,
  limit: (value) => (/^[a-z0-9-]{1,40}$/.test(value) ? value : null),
};

/** Text that has a form; empty: the link has none. */
const text = (key: string, form: RegExp): Setting<string> => ({
  key,
  initial: "",
  read: (text) => text,
  write: (value) => value,
  limit: (value) => (form.test(value) ? value : null),
});

/** The first digits of the SHA-256 of the model's document that the couplings and the start belong to. */
const model = text("model", /^([0-9a-f]{8})?$/);

/** A model file on the page's host. */
const modelFile: Setting<string> = {
  ...text(model.key, /^/),
  read: (text) => (model.limit(text) === null ? text : null),
};

const reading: Setting<Reading> = {
  key: "reading",
  // In this reading uncoupled parts fall out of step; as learned, they stop (docs/couplings.md).
  initial: "re-inferred",
  read: (text) => (text === "learned" ? "as-learned" : text === "inferred" ? "re-inferred" : null),
  write: (value) => (value === "as-learned" ? "learned" : "inferred"),
  limit: (value) => value,
};

/** A trial held out, counted from 0, or each in turn. */
export type HeldOut = number | "each";

/** The trial held out as people and the URL count it: from 1; 0: each in turn. */
export const trialNumber = whole("heldout", 0, 0, 99);
export const numberOf = (trial: HeldOut): number => (trial === "each" ? 0 : trial + 1);
export const trialOf = (number: number): HeldOut => (number === 0 ? "each" : number - 1);

const heldOut: Setting<HeldOut> = {
  key: trialNumber.key,
  initial: "each",
  read(text) {
    const number = trialNumber.read(text);
    return number === null ? null : trialOf(number);
  },
  write: (trial) => String(numberOf(trial)),
  limit(trial) {
    const number = trialNumber.limit(numberOf(trial));
    return number === null ? null : trialOf(number);
  },
};

/** A subset of some words, in the order of these words. */
function several<T extends string>(
  key: string,
  initial: readonly T[],
  values: readonly T[],
): Setting<readonly T[]> & { values: readonly T[] } {
  return {
    key,
    initial,
    values,
    read: (text) => text.split(",").filter(Boolean) as T[],
    write: (chosen) => chosen.join(","),
    limit: (chosen) =>
      chosen.every((value) => values.includes(value))
        ? values.filter((value) => chosen.includes(value))
        : null,
  };
}

/** Whole numbers, each once, in rising order. */
function counts(
  key: string,
  initial: readonly number[],
  min: number,
  max: number,
  most: number,
): Setting<readonly number[]> {
  return {
    key,
    initial,
    read(text) {
      const words = text.split(/[\s,]+/).filter(Boolean);
      return words.every((word) => /^\d{1,6}$/.test(word)) ? words.map(Number) : null;
    },
    write: (numbers) => numbers.join(","),
    limit(numbers) {
      if (numbers.length === 0 || !numbers.every((number) => Number.isInteger(number) && number >= 0))
        return null;
      const within = numbers.map((number) => Math.min(max, Math.max(min, number)));
      return [...new Set(within)].sort((a, b) => a - b).slice(0, most);
    },
  };
}

/** The panels that open next to the picture of the Lab. */
export const PANELS = ["learn", "more", "numbers"] as const;

/** All kinds of models, in the order of the tables. */
export const MODELS = [
  "vcgpdm",
  "vgpdm",
  "map-gpdm",
  "map-cgpdm",
  "tmp",
  "dmp-discrete",
  "dmp-rhythmic",
] as const;

/** The id of parts that the visitor has assigned by hand. */
export const BY_HAND = "hand";

/** Weights of the pose terms in the objective of a training; with 1 it is the bound. */
export const POSE_WEIGHTS = ["balanced", 1, 0.3, 0.1] as const;

/** The exercises for a class; after them count what a link dares its receiver to do. */
export const EXERCISES = 6;
export const DARES = { pose: 7, pace: 8, hand: 9 } as const;

export const SETTINGS = {
  /** The open chapter of the story; 0: the Lab or another view is open. */
  chapter: whole("story", 0, 0, LAST_CHAPTER),
  /** Whether the page for teachers is open. */
  teach: flag("teach", false),
  // Of a link: the page takes these at once, and leaves them out of its address.
  camera: look,
  time,
  /** The thread of the second chapter: tied as learned, or cut. */
  cut: choice("cut", "", ["", "relearned", "kept"] as const),
  /** The exercise for a class that the Lab shows; 0: none. */
  exercise: whole("exercise", 0, 0, DARES.hand),
  /** "synthetic": the synthetic experiment; "perception": the graphics Turing test. */
  view: choice<ViewName>("view", "play", VIEWS),
  /** The open panel. The address calls it a tab, as it did when the Lab had tabs. */
  panel: choice("tab", "none", ["none", ...PANELS]),
  parts: preset,
  split,
  latent: whole("latent", 3, 1, 6),
  dynamicsIps: points("dynamics", 40),
  poseIps: points("poses", 60),
  order: whole("order", 2, 1, 4),
  framesPerSecond: whole("fps", 30, 5, 60),
  seed: whole("seed", 0, 0, 4294967295),
  maxIterations: whole("iterations", 250, 10, 5000, 10),
  poseWeight: choice("weight", "balanced", POSE_WEIGHTS),
  /** Whether training maximises the bound, without own rollouts, whatever the weight of the poses is. */
  asInPapers: flag("papers", false),
  /** 0: the number of cores, at most a few. */
  trainings: whole("trainings", 0, 0, 20),
  frames: whole("frames", 300, 60, 1200, 30),
  start: whole("start", 0, 0, 99),
  /** The frame of that sequence where the motion begins. */
  startFrame: whole("frame", 0, 0, 99_999),
  /** Whether the stage plays sampled rollouts, another one in each loop, in place of the mean. */
  samples: flag("samples", false),
  model,
  // After `model`: the address then names the file.
  modelFile,
  reading,
  alpha: changedCouplings,
  plot: choice("plot", "2d", ["2d", "3d"] as const),
  speed: choice("speed", 1, [0.25, 0.5, 1, 2] as const),
  loop: flag("loop", true),
  /** For a projector: only the stage and one panel, in large type. */
  large: flag("large", false),
  // Of a comparison
  models: several("models", ["vcgpdm", "vgpdm", "tmp", "dmp-rhythmic"], MODELS),
  ips: counts("ips", [8, 12, 16], 2, 40, 8),
  bases: counts("bases", [20], 2, 200, 8),
  balanced: flag("balanced", false),
  heldOut,
  seeds: whole("seeds", 1, 1, 10),
  comparedIterations: whole("steps", 150, 5, 5000),
  /** Whether the vCGPDM and the MAP CGPDM are also trained on fewer trials, for the growth of their time. */
  growth: flag("growth", false),
  // Of the synthetic experiment
  drawn: whole("draw", 0, 0, 4294967295),
  /** Whether the first part drives the second. */
  driving: flag("driving", true),
  /** Inducing points of every function. */
  drawnPoints: choice("points", 10, [4, 10] as const),
  // The last and longest parts of an address.
  /** A line of who sends a drawing or a dare. */
  says: text("says", /^.{0,80}$/u),
  /** A drawing (drawing/link.ts). */
  drawing: text("hand", /^.{0,9000}$/),
  /** A model in the link itself (links/packed-model.ts). */
  packedModel: text("packed", /^/),
};

export type Settings = {
  [Name in keyof typeof SETTINGS]: (typeof SETTINGS)[Name] extends Setting<infer T> ? T : never;
};
export type SettingName = keyof Settings;

/** The numbers of inducing points of a training: the visitor's, or else those of `usual`. */
export function pointsOf(
  { dynamicsIps, poseIps }: Settings,
  usual = { dynamicsIps: SETTINGS.dynamicsIps.usual, poseIps: SETTINGS.poseIps.usual },
): { dynamicsIps: number; poseIps: number } {
  return { dynamicsIps: dynamicsIps || usual.dynamicsIps, poseIps: poseIps || usual.poseIps };
}

type Row = Setting<Settings[SettingName]>;
const ROWS = Object.entries(SETTINGS) as unknown as [SettingName, Row][];

/** What the address of a chapter has. */
const OF_CHAPTERS: ReadonlySet<SettingName> = new Set(["chapter", "camera", "time", "cut"]);

/** What only the address of the view Draw has: nobody sends a drawing with something else. A dare has a line, too. */
const isOfDraw = (name: SettingName, exercise: number) =>
  name === "drawing" || (name === "says" && exercise <= EXERCISES);

export function initialSettings(): Settings {
  return Object.fromEntries(ROWS.map(([name, row]) => [name, row.initial])) as unknown as Settings;
}

/** The settings of a URL fragment; missing and invalid ones have their initial values. */
export function readSettings(fragment: string): Settings {
  const given = new URLSearchParams(fragment.replace(/^#/, ""));
  const read: [string, unknown][] = [];
  for (const [name, row] of ROWS) {
    const text = given.get(row.key);
    const value = text === null ? null : row.read(text);
    if (value !== null) read.push([name, value]);
  }
  return { ...initialSettings(), ...limited(Object.fromEntries(read)) };
}

/**
 * The URL fragment of these settings, without "#" and without initial values. A chapter has few settings.
 * The Lab names its view, because a page without a fragment opens where the visitor was.
 */
export function writeSettings(settings: Settings): string {
  if (settings.teach) return SETTINGS.teach.key;
  const given = new URLSearchParams();
  for (const [name, row] of ROWS) {
    if (settings.chapter > 0 && !OF_CHAPTERS.has(name)) continue;
    if (SETTINGS.view.write(settings.view) !== "draw" && isOfDraw(name, settings.exercise)) continue;
    const text = row.write(settings[name]);
    if (text !== row.write(row.initial)) given.set(row.key, text);
  }
  if (given.size === 0) given.set(SETTINGS.view.key, settings.view);
  return given
    .toString()
    .replace(/%3A/gi, ":")
    .replace(/%2C/gi, ",")
    .replace(/%3B/gi, ";")
    .replace(/%2F/gi, "/");
}

/** These values within the limits of their settings, without invalid ones. */
export function limited(values: Partial<Settings>): Partial<Settings> {
  const within: [string, unknown][] = [];
  for (const [name, row] of ROWS) {
    const value = values[name];
    const limit = value === undefined ? null : row.limit(value);
    if (limit !== null) within.push([name, limit]);
  }
  return Object.fromEntries(within) as Partial<Settings>;
}

/** `?embed` shows a view without header and footer. */
export function isEmbedded(search: string): boolean {
  const value = new URLSearchParams(search).get("embed");
  return value !== null && value !== "0";
}
