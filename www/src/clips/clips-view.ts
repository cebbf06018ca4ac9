// The panel Clips: show, tick and cut clips.
import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { EngineStore } from "../engine/engine-store";
import type { StageStore } from "../stage/stage-store";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { ClipEntry, ClipsStore } from "./clips-store";
import "./clips.css";

export class ClipsView extends View {
  declare clips: ClipsStore;
  declare stage: StageStore;
  declare engine: EngineStore;
  readonly #cutting = new Set<string>();

  protected override stores() {
    return [this.clips, this.stage, this.engine];
  }

  #toggleCut(key: string): void {
    if (!this.#cutting.delete(key)) this.#cutting.add(key);
    this.requestUpdate();
  }

  #cutField(clip: ClipEntry, side: "first" | "end") {
    const { clips } = this;
    const { key, title, loaded } = clip;
    // Visitors count frames from 1, and the last one is included.
    const from = side === "first" ? 1 : 0;
    const change = (event: Event) => {
      const input = event.target as HTMLInputElement;
      const asked: ClipEntry = { ...clip, [side]: input.valueAsNumber - from };
      clips.cut(key, asked.first, asked.end);
      // Lit does not draw an unchanged number again.
      const now = clips.all.find((other) => other.key === key) ?? clip;
      input.value = String(now[side] + from);
    };
    return html`<input type="number" min="1" max=${loaded.info.frames} .value=${String(clip[side] + from)} ?disabled=${clips.locked}
      aria-label="${side === "first" ? "First" : "Last"} frame of ${title}" @change=${change} />`;
  }

  #cutFields(clip: ClipEntry) {
    return html`
      <div class="cut" role="group" aria-label="Frames of ${clip.title} to use">
        <label>from ${this.#cutField(clip, "first")}</label>
        <label>to ${this.#cutField(clip, "end")}</label>
        <span>of ${clip.loaded.info.frames} frames</span>
      </div>`;
  }

  #row(clip: ClipEntry) {
    const { key, title, origin, ticked, loaded, first, end } = clip;
    const { clips, stage } = this;
    const shown = stage.clip === key;
    const { frameTime, warnings } = loaded.info;
    const seconds = ((end - first) * frameTime).toFixed(1);
    return html`
      <li class="clip ${shown ? "shown" : ""}">
        <label class="tick-label">
          <input type="checkbox" aria-label="Train on ${title}" .checked=${ticked} ?disabled=${clips.locked}
            @change=${(event: Event) => void clips.tick(key, (event.target as HTMLInputElement).checked)} />
          <span class="clip-title" title=${title}>${title}</span>
        </label>
        <span class="clip-length">${seconds} s</span>
        <button class="round" aria-label="Cut ${title}" title="Cut" aria-expanded=${this.#cutting.has(key) ? "true" : "false"} @click=${() => this.#toggleCut(key)}>${icon("cut")}</button>
        <button class="round" aria-label=${shown ? `Stop showing ${title}` : `Show ${title}`} title=${shown ? "Back to the model" : "Show on the stage"} aria-pressed=${shown ? "true" : "false"}
          @click=${() => (shown ? stage.endClip() : clips.show(key))}>${icon("eye")}</button>
        ${
          origin === "own"
            ? html`<button class="round" aria-label="Remove ${title}" title="Remove" ?disabled=${clips.locked} @click=${() => void clips.remove(key)}>${icon("close")}</button>`
            : html`<span class="round"></span>`
        }
        ${this.#cutting.has(key) ? this.#cutFields(clip) : nothing}
        ${
          warnings.length > 0
            ? html`<details class="warnings"><summary>${warnings.length} ${warnings.length === 1 ? "notice" : "notices"}</summary>
              <ul>${warnings.map((warning) => html`<li>${warning}</li>`)}</ul></details>`
            : nothing
        }
      </li>`;
  }

  /** Rows with keys, so that an open row stays with its clip. */
  #rows(clips: readonly ClipEntry[]) {
    return repeat(
      clips,
      ({ key }) => key,
      (clip) => this.#row(clip),
    );
  }

  /** When only the bones differ: the remedy, and how to undo it. */
  #bones() {
    const { clips } = this;
    const { bonesClash, firstBones, ticked, locked } = clips;
    const [first] = ticked;
    const change = (to: boolean) => () => void clips.setFirstBones(to);
    if (bonesClash) {
      return html`<p class="hint">Their joints are the same, only their bones differ.
        <button class="small" data-testid="first-bones" ?disabled=${locked} @click=${change(true)}>Use the first clip’s bones</button></p>`;
    }
    if (!firstBones || !first || ticked.length < 2) return nothing;
    return html`<p class="hint" data-testid="bones">All ticked clips are trained on with the bones of ${first.title}: joint angles stay, the way over the
      ground is scaled by the length of the legs.
      <button class="small" ?disabled=${locked} @click=${change(false)}>Use their own bones</button></p>`;
  }

  protected override render() {
    const { clips } = this;
    const own = clips.all.filter(({ origin }) => origin === "own");
    const made = clips.all.filter(({ origin }) => origin === "made");
    return html`
      <h2>Clips</h2>
      ${clips.clash ? html`<p class="bad" role="alert" data-testid="clash">${clips.clash}</p>` : nothing}
      ${this.#bones()}
      ${
        own.length > 0
          ? html`<ul class="clip-list" data-testid="own-clips">${this.#rows(own)}</ul>`
          : html`<p class="hint">Open your own motion clips (.bvh) or a model (.json), or drop them anywhere. They stay on this machine.
            <button class="link" data-testid="show-series" @click=${() => this.dispatchEvent(new CustomEvent("show-series", { bubbles: true }))}>Time series</button>
            that are no body (.csv) have a view of their own.</p>`
      }
      ${
        made.length > 0
          ? html`<details class="made">
            <summary>Samples, made by a procedural walker
              <small>${made.filter(({ ticked }) => ticked).length} of ${made.length} ticked, to train a new model on</small></summary>
            <ul class="clip-list" data-testid="made-clips">${this.#rows(made)}</ul></details>`
          : this.engine.state === "loading"
            ? html`<p class="empty">Getting the sample clips ready</p>`
            : nothing
      }`;
  }
}
customElements.define("pg-clips", ClipsView);
