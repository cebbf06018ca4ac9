// A dialog with the channels of the motion on the stage, or with the kernels of the model. Loaded at its
// first use.
import { html, render, type TemplateResult } from "lit";
import type { ModelStore } from "../couplings/model-store";
import type { Engine, LoadedClip } from "../engine/protocol";
import type { Playback } from "../stage/playback";
import "../ui/dialog.css";
import { icon } from "../ui/icons";
import "./angles-view";
import { channelsOf, readMotion } from "./channels";
import "./details.css";
import { kernelsOf } from "./kernels";
import { kernelTables } from "./kernels-view";

export type Detail = "angles" | "kernels";

/** The contents of the dialog. */
export interface Subject {
  engine: Engine;
  model: ModelStore;
  playback: Playback;
  /**
   * The clip on the stage with its frames from `first` up to, not including, `end`; null: the model's motion.
   */
  clip: { title: string; loaded: LoadedClip; first: number; end: number } | null;
}

async function angles({ engine, model, playback, clip }: Subject): Promise<TemplateResult> {
  const motions = clip
    ? [{ name: clip.title, motion: readMotion(await engine.clipBvh(clip.loaded.id, clip.first, clip.end)) }]
    : [{ name: "the model now", motion: readMotion(await engine.rolloutBvh(model.rolloutRequest())) }];
  const { learned } = model;
  if (!clip && model.couplings.altered && learned)
    motions.push({ name: "as learned", motion: readMotion(await engine.rolloutBvh(learned.request)) });
  const joints = clip?.loaded.info.joints ?? model.model?.info.joints ?? [];
  return html`<pg-angles .playback=${playback} .motions=${motions} .channels=${channelsOf(joints)}></pg-angles>`;
}

const TITLES = { angles: "Joint angles", kernels: "What was learned: kernels" };

/** Opens the dialog within `place` and removes it when it is closed. */
export async function openDetails(what: Detail, subject: Subject, place: HTMLElement): Promise<void> {
  const content =
    what === "angles" ? await angles(subject) : kernelTables(kernelsOf(await subject.engine.modelJson()));
  const dialog = document.createElement("dialog");
  dialog.className = "details";
  dialog.setAttribute("aria-labelledby", "details-title");
  dialog.addEventListener("close", () => dialog.remove());
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  const body = html`
    <div class="dialog-body">
      <header><h2 id="details-title">${TITLES[what]}</h2>
        <form method="dialog"><button class="round" aria-label="Close">${icon("close")}</button></form></header>
      ${content}
    </div>`;
  render(body, dialog);
  place.append(dialog);
  dialog.showModal();
}
