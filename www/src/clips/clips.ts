// Opening, ticking, cutting and looking at clips.
import type { App, ClipEntry } from "../app/app";
import { clipTitle, messageOf, sentence } from "../ui/format";
import { partsFor } from "./parts";
import type { SampleInfo } from "../engine/protocol";
import { showRollout, takeUp } from "../couplings/rollouts";
import { changeSettings } from "../settings/change";

/** Files beyond this are no motion clips; reading them would only fill the memory. */
export const LARGEST_FILE = 200e6;

/** The clips that the project makes itself; the plain walks are ticked. */
export async function loadSamples(app: App, samples: SampleInfo[]): Promise<void> {
  for (const { id, title, movement } of samples) {
    const loaded = await app.engine!.sampleClip(id);
    const source = { sample: id };
    add(app, { key: `made-${id}`, title, origin: "made", movement, source, loaded, ticked: movement === "walk" });
  }
  app.samplesLoaded = true;
  app.tell("clips");
}

function add(app: App, entry: Omit<ClipEntry, "first" | "end">): void {
  app.clips = [...app.clips, { ...entry, first: 0, end: entry.loaded.info.frames }];
  app.tell("clips");
}

/** Reads dropped or chosen files: motion clips (.bvh) and models (.json). Errors land where the files did. */
export async function openFiles(app: App, files: readonly File[], at: { x: number; y: number } | null): Promise<void> {
  app.clearNotices();
  const refuse = (title: string, text: string) => app.notify({ kind: "error", title, text, at });
  if (!app.engine) {
    const text = sentence(app.engineProblem) || "The page is still getting ready; try again in a moment.";
    return refuse("Nothing was opened", text);
  }
  let opened = 0;
  for (const file of files) {
    try {
      if (file.size > LARGEST_FILE)
        throw new Error("This file has more than 200 MB; expected a motion clip or a model.");
      if (/\.json$/i.test(file.name)) {
        await openJson(app, await file.text());
      } else if (/\.bvh$/i.test(file.name)) {
        opened += 1;
        await openClip(app, file, opened === 1);
      } else {
        throw new Error("Expected a motion clip (.bvh) or a model (.json).");
      }
    } catch (problem) {
      refuse(file.name, messageOf(problem));
    }
  }
  if (opened > 0) await checkClash(app);
}

/** A model, or the results of a comparison: those say so themselves. */
async function openJson(app: App, text: string): Promise<void> {
  if (!/"format"\s*:\s*"vcgpdm-evaluation"/.test(text.slice(0, 200))) return openModel(app, text);
  const { studying } = await import("../comparison/comparison-store");
  await studying(app).open(text);
  changeSettings(app, { view: "compare" });
}

async function openModel(app: App, text: string): Promise<void> {
  if (app.busy) throw new Error("A training is running: cancel it before opening a model.");
  const opened = await app.engine!.openModel(text, app.settings.frames);
  app.chosen = null;
  takeUp(app, opened);
  app.tell("training");
}

async function openClip(app: App, file: File, first: boolean): Promise<void> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const title = clipTitle(file.name);
  const loaded = await app.engine!.readClip(title, bytes);
  // Own clips are what the visitor wants to train on now: the made ones step back.
  if (first) app.clips = app.clips.map((clip) => (clip.origin === "made" ? { ...clip, ticked: false } : clip));
  const key = `own-${loaded.id}`;
  const source = { name: title, file: new Blob([bytes]) };
  add(app, { key, title, origin: "own", movement: "", source, loaded, ticked: true });
  if (first) preview(app, key);
}

function update(app: App, key: string, change: Partial<ClipEntry>): void {
  app.clips = app.clips.map((clip) => (clip.key === key ? { ...clip, ...change } : clip));
  app.tell("clips");
}

export async function tickClip(app: App, key: string, ticked: boolean): Promise<void> {
  update(app, key, { ticked });
  await checkClash(app);
}

/** Finds out whether the ticked clips can be trained on together. */
export async function checkClash(app: App): Promise<void> {
  const ids = app.tickedClips().map(({ loaded }) => loaded.id);
  let clash = "";
  try {
    if (ids.length > 1) await app.engine?.checkTogether(ids);
  } catch (problem) {
    clash = messageOf(problem);
  }
  app.clash = clash;
  app.tell("clips");
}

/** Frames from 1 to the end, as a person counts; keeps at least ten. */
export function cutClip(app: App, key: string, first: number, end: number): void {
  const clip = app.clips.find((one) => one.key === key);
  if (!clip || !Number.isFinite(first) || !Number.isFinite(end)) return app.tell("clips");
  const frames = clip.loaded.info.frames;
  const least = Math.min(10, frames);
  const from = Math.min(Math.max(0, Math.round(first)), frames - least);
  const to = Math.min(Math.max(from + least, Math.round(end)), frames);
  update(app, key, { first: from, end: to });
  if (app.shown?.clip === key) preview(app, key);
}

/** Plays a clip as it was recorded; again: back to the model. */
export function preview(app: App, key: string): void {
  const clip = app.clips.find((one) => one.key === key);
  if (!clip) return;
  const { info, motion } = clip.loaded;
  const width = motion.nodes * 3;
  app.show({
    kind: "clip",
    clip: key,
    figure: info.figure,
    joints: info.joints.map(({ name }) => name),
    parts: partsFor(info, app.settings.parts, app.settings.split),
    motion: {
      ...motion,
      frames: clip.end - clip.first,
      positions: motion.positions.subarray(clip.first * width, clip.end * width),
    },
  });
  app.tell("clips");
}

/** Shows other parts in the clip that is being looked at. */
export function partsChanged(app: App): void {
  if (app.shown?.clip !== undefined) preview(app, app.shown.clip);
  else app.tell("clips");
}

export function endPreview(app: App): void {
  showRollout(app, true);
  app.tell("clips");
}

export async function removeClip(app: App, key: string): Promise<void> {
  const clip = app.clips.find((one) => one.key === key);
  if (!clip) return;
  app.clips = app.clips.filter((one) => one !== clip);
  if (app.shown?.clip === key) endPreview(app);
  app.tell("clips");
  await app.engine?.dropClip(clip.loaded.id);
  await checkClash(app);
}
