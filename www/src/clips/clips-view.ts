// The panel Clips: show, tick and cut clips.
import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { EngineStore } from "../engine/engine-store";
import type { UpAxis } from "../engine/protocol";
import type { StageStore } from "../stage/stage-store";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import { type ClipEntry, type ClipsStore, fileNotices, noteOf } from "./clips-store";
import "./clips.css";
import { lab } from "../words/lab";

const UP_AXES: readonly UpAxis[] = ["x", "y", "z", "-x", "-y", "-z"];

export class ClipsView extends View {
  declare clips: ClipsStore;
  declare stage: StageStore;
  declare engine: EngineStore;
  readonly #cutting = new Set<string>();

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
      aria-label=${lab().learn.clips.side[side](title)} @change=${change} />`;
  }

  #cutFields(clip: ClipEntry) {
    const words = lab().learn.clips;
    return html`
      <div class="cut row wrap loose hint" role="group" aria-label=${words.frames(clip.title)}>
        <label>${words.from} ${this.#cutField(clip, "first")}</label>
        <label>${words.to} ${this.#cutField(clip, "end")}</label>
        <span>${words.of(clip.loaded.info.frames)}</span>
        ${clip.origin === "own" ? [this.#upField(clip), this.#rateField(clip), this.#bodyField(clip)] : nothing}
      </div>`;
  }

  /** For a body that lies on the stage: the axis that points up in its file. */
  #upField({ key, title, loaded }: ClipEntry) {
    const { clips } = this;
    const words = lab().learn.clips;
    const change = (event: Event) =>
      void clips.state(key, { up: (event.target as HTMLSelectElement).value as UpAxis });
    return html`<label>${words.up}
      <select aria-label=${words.upAxis(title)} ?disabled=${clips.locked} @change=${change}>
        ${UP_AXES.map((axis) => html`<option ?selected=${axis === loaded.info.upAxis}>${axis}</option>`)}
      </select></label>`;
  }

  /** For a file with several bodies. */
  #bodyField({ key, title, source, bodies }: ClipEntry) {
    const { clips } = this;
    if (bodies.length < 2) return nothing;
    const words = lab().learn.clips;
    const now = "root" in source ? source.root : bodies[0];
    const change = (event: Event) =>
      void clips.state(key, { root: (event.target as HTMLSelectElement).value });
    return html`<label>${words.body}
      <select aria-label=${words.bodyOf(title)} ?disabled=${clips.locked} @change=${change}>
        ${bodies.map((body) => html`<option ?selected=${body === now}>${body}</option>`)}
      </select></label>`;
  }

  /** For a file with a wrong frame time. */
  #rateField({ key, title, loaded }: ClipEntry) {
    const { clips } = this;
    const words = lab().learn.clips;
    const change = (event: Event) =>
      void clips.state(key, { fps: (event.target as HTMLInputElement).valueAsNumber });
    const rate = Number((1 / loaded.info.frameTime).toPrecision(4));
    return html`<label>${words.rate} <input type="number" min="1" max="10000" step="any" .value=${String(rate)}
      aria-label=${words.rateOf(title)} ?disabled=${clips.locked} @change=${change} /></label>`;
  }

  #row(clip: ClipEntry) {
    const { key, title, origin, ticked, loaded, first, end } = clip;
    const { clips, stage } = this;
    const shown = stage.clip === key;
    const { frameTime, warnings } = loaded.info;
    const words = lab().learn.clips;
    return html`
      <li class="clip row wrap ${shown ? "shown" : ""}">
        <label class="tick-label row">
          <input type="checkbox" aria-label=${words.tick(title)} .checked=${ticked} ?disabled=${clips.locked}
            @change=${(event: Event) => void clips.tick(key, (event.target as HTMLInputElement).checked)} />
          <span class="clip-title ellipsis" title=${noteOf(clip) || title}>${title}</span>
        </label>
        <span class="clip-length hint tabular">${words.seconds((end - first) * frameTime)}</span>
        <button class="round" aria-label=${words.cutOf(title)} title=${words.cut} aria-expanded=${this.#cutting.has(key) ? "true" : "false"} @click=${() => this.#toggleCut(key)}>${icon("cut")}</button>
        <button class="round" aria-label=${shown ? words.stopShowing(title) : words.show(title)} title=${shown ? words.backToModel : words.onStage} aria-pressed=${shown ? "true" : "false"}
          @click=${() => (shown ? stage.endClip() : clips.show(key))}>${icon("eye")}</button>
        ${
          origin === "own"
            ? html`<button class="round" aria-label=${words.removeOf(title)} title=${words.remove} ?disabled=${clips.locked} @click=${() => void clips.remove(key)}>${icon("close")}</button>`
            : html`<span class="round"></span>`
        }
        ${this.#cutting.has(key) || loaded.assumed ? this.#cutFields(clip) : nothing}
        ${loaded.assumed ? html`<p class="hint bad" data-testid="assumed-rate">${words.assumed(loaded.assumed.why, loaded.assumed.fps)}</p>` : nothing}
        ${fileNotices(warnings)}
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
    const words = lab().learn.clips;
    if (bonesClash) {
      return html`<p class="hint">${words.bonesClash}
        <button class="small" data-testid="first-bones" ?disabled=${locked} @click=${change(true)}>${words.firstBones}</button></p>`;
    }
    if (!firstBones || !first || ticked.length < 2) return nothing;
    return html`<p class="hint" data-testid="bones">${words.bones(first.title)}
      <button class="small" ?disabled=${locked} @click=${change(false)}>${words.ownBones}</button></p>`;
  }

  protected override render() {
    const { clips } = this;
    const own = clips.all.filter(({ origin }) => origin === "own");
    const made = clips.all.filter(({ origin }) => origin === "made");
    const modelled = clips.all.filter(({ origin }) => origin === "model");
    const words = lab().learn.clips;
    return html`
      <h2>${words.title}</h2>
      ${clips.clash ? html`<p class="bad" role="alert" data-testid="clash">${clips.clash}</p>` : nothing}
      ${this.#bones()}
      ${
        own.length > 0
          ? html`<ul class="clip-list" data-testid="own-clips">${this.#rows(own)}</ul>`
          : html`<p class="hint">${words.openOwn}
            <button class="link" data-testid="show-series" @click=${() => this.tell("show-series")}>${words.series}</button>
            ${words.seriesView}</p>`
      }
      ${
        made.length > 0
          ? html`<details class="made">
            <summary class="hint">${words.samples}
              <small>${words.ticked(made.filter(({ ticked }) => ticked).length, made.length)}</small></summary>
            <ul class="clip-list" data-testid="made-clips">${this.#rows(made)}</ul></details>`
          : this.engine.state === "loading"
            ? html`<p class="empty">${words.gettingReady}</p>`
            : nothing
      }
      ${
        modelled.length > 0
          ? html`<ul class="clip-list" data-testid="model-clips">${this.#rows(modelled)}</ul>`
          : nothing
      }`;
  }
}
customElements.define("pg-clips", ClipsView);
