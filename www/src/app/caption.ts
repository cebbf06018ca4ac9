// The caption over the figure: a title and a text about the stage.
import { html, nothing } from "lit";
import { type ClipEntry, noteOf } from "../clips/clips-store";
import type { PointingStore } from "../latents/pointing-store";
import { presetWords } from "../couplings/presets";
import { View } from "../ui/view";
import type { App } from "./app";
import "./caption.css";
import { type StageWords, stageWords } from "./stage-words";
import { lab, shownPart } from "../words/lab";
import { troubleText } from "../couplings/measures-text";
import type { BodyReport } from "../engine/protocol";
import { sentence } from "../ui/format";

/** The motion on the stage. */
interface StageMotion {
  /** Seconds of motion. */
  seconds: number;
  parts: readonly { name: string }[];
  /** Whether a coupling is changed. */
  altered: boolean;
}

/** One sentence; empty for a healthy motion. */
export function healthWords(health: BodyReport["health"], { seconds, parts, altered }: StageMotion): string {
  const names = parts.map(({ name }) => shownPart(name));
  const words = troubleText(health, names);
  // The measured motion may be longer than the shown one.
  if (!words || (health.from ?? 0) >= seconds) return "";
  if (health.state === "leaves-training-range") return sentence(words);
  return sentence(lab().stage.health(words, altered));
}

/** The clip on the stage; null: the model's motion is there. */
export function clipOnStage({ clips, stage }: App): ClipEntry | null {
  return clips.all.find(({ key }) => key === stage.clip) ?? null;
}

/** The texts of the page about the stage now. */
export function wordsNow(app: App): StageWords {
  const { stage, model, pointing, training } = app;
  if (stage.content?.caption) return stage.content.caption;
  const clip = clipOnStage(app);
  const parts = model.model?.info.parts ?? [];
  const run = training.learning;
  const several = training.asked.length > 1;
  return stageWords({
    kind: stage.content?.kind ?? null,
    clip: clip && { ...clip, note: noteOf(clip) },
    learnedFrom: model.model?.info.sequences.map(({ name }) => name) ?? null,
    point: pointing.report ? pointWords(pointing, parts) : null,
    altered: model.couplings.altered,
    preset: model.preset && presetWords(model.preset),
    live: stage.content?.live === true,
    sample: model.rollout?.request.sample,
    twoReadings: stage.columns !== null,
    learning: run && {
      iteration: run.steps.at(-1)?.iteration ?? null,
      seed: several ? run.settings.seed : null,
    },
  });
}

function pointWords({ report }: PointingStore, parts: readonly { name: string }[]): string {
  const name = (part: number) => shownPart(parts[part]?.name ?? "");
  if (!report) return "";
  const { point } = report;
  const { posePoint, stepPoint } = lab().stage;
  return point.kind === "pose"
    ? posePoint(name(point.part))
    : stepPoint(name(point.source), name(point.target));
}

export class CaptionView extends View {
  declare app: App;

  protected override stores() {
    const { stage, clips, model, pointing, training, body } = this.app;
    return [stage, clips, model, pointing, training, body];
  }

  /** A notice with buttons, for a motion that is not healthy, such as one whose pose stops changing. */
  #healthNotice() {
    const { stage, model, training, pointing, body } = this.app;
    const { content } = stage;
    if (content?.kind !== "model" || training.learning || pointing.report || !body.reports || !body.isCurrent)
      return nothing;
    const seconds = content.motion.frames * content.motion.frameTime;
    const { health } = body.reports.now;
    const words = healthWords(health, {
      seconds,
      parts: content.parts,
      altered: model.couplings.altered,
    });
    if (!words) return nothing;
    const run = training.chosen;
    const points = run && training.morePoints(run);
    const buttons = model.couplings.altered
      ? html`<button class="small" @click=${() => model.couplings.resetAll()}>${lab().stage.asLearned}</button>`
      : run && !training.busy && training.whyNot() === ""
        ? html`${
            points === null
              ? nothing
              : html`<button class="small" data-testid="more-points" title=${lab().stage.morePointsMeaning(points)}
                @click=${() => void training.trainWithMorePoints(run)}>${lab().stage.morePoints}</button>`
          }
          <button class="small" data-testid="other-seeds" title=${lab().stage.otherSeedsMeaning}
            @click=${() => void training.trainOtherSeeds()}>${lab().stage.otherSeeds}</button>`
        : nothing;
    const samples =
      /pose|still/.test(health.state) && !model.rollout?.request.sample
        ? html`<button class="small" @click=${() => model.playSamples(true)}>${lab().stage.playSamples}</button>`
        : nothing;
    return html`<div class="stage-health row wrap" role="status" data-testid="health"><p>${words}</p>${buttons}${samples}</div>`;
  }

  protected override render() {
    const { stage, model } = this.app;
    const { title, text } = wordsNow(this.app);
    return html`
      <div class="stage-caption passive stack">
        <strong data-testid="stage-title">${title}</strong>
        <span class="hint">${
          stage.content?.kind === "model" && title === lab().stage.made
            ? `${lab().stage.rollout}${text ? ", " : ""}`
            : nothing
        }${text}</span>
        ${
          stage.clip !== null && model.model
            ? html`<button class="small" @click=${() => stage.endClip()}>${lab().stage.backToModel}</button>`
            : nothing
        }
        ${this.#healthNotice()}
      </div>`;
  }
}
customElements.define("pg-caption", CaptionView);
