// The menu Save: the motion on the stage in several formats, and the model.
import { html, nothing } from "lit";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import { messageOf } from "../ui/format";
import type { App } from "./app";
import { clipOnStage } from "./caption";
import "./save-menu.css";
import type { Saved } from "./saving";

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
    const { left, bottom } = button.getBoundingClientRect();
    const width = WIDTH * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
    const { clientWidth } = document.documentElement;
    currentTarget.style.left = `${Math.max(8, Math.min(left, clientWidth - width - 8))}px`;
    currentTarget.style.top = `${bottom + 4}px`;
  }

  #item(what: Saved, title: string, kind: string, about: string, possible: boolean) {
    const chosen = () => {
      this.querySelector<HTMLElement>("#save-menu")?.hidePopover();
      import("./saving").then(
        ({ save }) => save(this.app, what),
        (problem: unknown) => this.app.notices.addError("Nothing was saved", messageOf(problem)),
      );
    };
    return html`
      <button data-testid="save-${what}" ?disabled=${!possible} @click=${chosen}>
        <span>${title}<small>${about}</small></span><small>${kind}</small></button>`;
  }

  protected override render() {
    const { engine, model } = this.app;
    const clip = clipOnStage(this.app);
    const hasModel = engine.engine !== null && model.rollout !== null;
    const noRollout = clip ? "Go back to the model first" : "";
    // Other views save their own files: the stage is not visible there.
    const { isPlayView } = this.app;
    return html`
      <button class="small" data-testid="save" popovertarget="save-menu" title=${isPlayView ? nothing : "Saves what is on the stage: go to the Lab"}
        ?disabled=${!isPlayView || (!hasModel && !clip)}>${icon("save")} Save</button>
      <div id="save-menu" class="menu" popover role="group" aria-label="Save" @beforetoggle=${this.#place}>
        ${this.#item("motion", "Motion", "BVH", clip ? `The clip ${clip.title}` : "As it moves on the stage", hasModel || clip !== null)}
        ${this.#item("glb", "Motion with a skin", "GLB", "For Blender and viewers", hasModel || clip !== null)}
        ${this.#item("positions", "Joint positions", "CSV", "A row a frame, in metres, y up", hasModel || clip !== null)}
        ${this.#item("latents", "Latents and weights", "CSV", noRollout || "A row a frame", hasModel && !clip)}
        ${this.#item("account", "How the motion was made", "JSON", noRollout || "Model, clips, seed, couplings, start", hasModel && !clip)}
        ${this.#item("model", "Model", "JSON", "Opens here and in the terminal", hasModel)}
      </div>`;
  }
}
customElements.define("pg-save-menu", SaveMenu);
