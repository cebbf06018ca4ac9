// The menu Save: the motion on the stage in several formats, the model, and its link.
import { html, nothing } from "lit";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import { messageOf } from "../ui/format";
import type { App } from "./app";
import { clipOnStage } from "./caption";
import "./save-menu.css";
import type { Saved } from "./saving";
import { lab } from "../words/lab";

/** The width of the menu in rem; its style has the same. */
const WIDTH = 17;

export class SaveMenu extends View {
  declare app: App;

  protected override stores() {
    const { engine, model, stage, clips, settings } = this.app;
    return [engine, model, stage, clips, settings];
  }

  /** Places the menu below its button, within the window, before it appears. */
  #place({ currentTarget, newState }: ToggleEvent & { currentTarget: HTMLElement }): void {
    const button = this.querySelector("button");
    if (newState !== "open" || !button) return;
    // Its item is there when it has loaded, and is the last: nothing moves under a pointer.
    import("./film").catch(() => {});
    const { left, bottom } = button.getBoundingClientRect();
    const width = WIDTH * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
    const { clientWidth } = document.documentElement;
    currentTarget.style.left = `${Math.max(8, Math.min(left, clientWidth - width - 8))}px`;
    currentTarget.style.top = `${bottom + 4}px`;
  }

  #item(what: Saved, kind: string, possible: boolean, instead?: string) {
    const { title, about } = lab().files[what];
    const chosen = () => {
      this.querySelector<HTMLElement>("#save-menu")?.hidePopover();
      import("./saving").then(
        ({ save }) => save(this.app, what),
        (problem: unknown) => this.app.notices.addError(lab().files.nothingSaved, messageOf(problem)),
      );
    };
    return html`
      <button data-testid="save-${what}" ?disabled=${!possible} @click=${chosen}>
        <span>${title}<small class="own-line">${instead ?? about}</small></span><small>${kind}</small></button>`;
  }

  #share(): void {
    this.querySelector<HTMLElement>("#save-menu")?.hidePopover();
    this.tell("share");
  }

  protected override render() {
    const { engine, model } = this.app;
    const clip = clipOnStage(this.app);
    const hasModel = engine.engine !== null && model.rollout !== null;
    const hasMotion = hasModel || clip !== null;
    const words = lab().files;
    // A clip, or the motion of a model of another kind.
    const isBehind = this.app.stage.clip !== null;
    const isOtherKind = isBehind && !clip;
    const noRollout = isBehind ? words.modelFirst : undefined;
    // Other views save their own files: the stage is not visible there.
    const { isPlayView } = this.app;
    return html`
      <button class="small" data-testid="save" popovertarget="save-menu" title=${isPlayView ? nothing : words.saveElsewhere}
        ?disabled=${!isPlayView || !hasMotion}>${icon("save")} ${words.save}</button>
      <div id="save-menu" class="menu" popover role="group" aria-label=${words.save} @beforetoggle=${this.#place}>
        ${this.#item("motion", "BVH", hasMotion, clip ? words.motion.ofClip(clip.title) : undefined)}
        ${this.#item("glb", "GLB", hasMotion)}
        ${this.#item("positions", "CSV", hasMotion)}
        ${this.#item("latents", "CSV", hasModel && !isBehind, noRollout)}
        ${this.#item("account", "JSON", hasMotion && !isOtherKind, isOtherKind ? noRollout : undefined)}
        ${this.#item("model", "JSON", hasModel || isOtherKind)}
        <button data-testid="share" ?disabled=${!hasModel && !isOtherKind} @click=${this.#share}><span>${words.share.title}<small class="own-line">${words.share.about}</small></span><small>URL</small></button>
        <pg-film .app=${this.app}></pg-film>
      </div>`;
  }
}
customElements.define("pg-save-menu", SaveMenu);
