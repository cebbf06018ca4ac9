// The handles of a TMP or DMP, or the couplings of a MAP CGPDM, under the stage.
import { html, nothing } from "lit";
import { couplingSlider } from "../couplings/coupling-slider";
import type { StageView } from "../stage/stage-view";
import { styled } from "../ui/styled";
import { View } from "../ui/view";
import { lab, shownPart } from "../words/lab";
import { performingWords } from "../words/sections";
import { letDragLimbs } from "./drag-limbs";
import type { HandlesStore } from "./handles-store";
import "./handles.css";

export class HandlesView extends View {
  declare handles: HandlesStore;

  protected override stores() {
    return [this.handles];
  }

  protected override arrived(): void {
    const stage = this.closest(".stage-area")?.querySelector<StageView>("pg-stage");
    if (stage) this.whenLeaving(letDragLimbs(stage, this.handles));
  }

  /** The sliders of all couplings, a row for each part that they lead to. */
  #couplings({ couplings, parts }: HandlesStore) {
    const name = (part: number) => shownPart(parts[part]?.name ?? "");
    const sliders = parts.flatMap((_, target) =>
      parts.map((__, source) => {
        const names = [name(source), name(target)] as const;
        return html`<div><small>${lab().couplings.toOther(...names)}</small>${couplingSlider({ couplings, source, target, names, prefix: "map-" })}</div>`;
      }),
    );
    return html`<div class="map-couplings" style=${styled({ "--parts": String(parts.length) })}>${sliders}</div>`;
  }

  protected override render() {
    const { handles } = this;
    const words = performingWords().handles;
    const reset = html`<button class="small" data-testid="handles-reset" ?disabled=${handles.isAsLearned} @click=${() => handles.reset()}>${words.reset}</button>`;
    if (handles.kind === "map-cgpdm")
      return html`
        <section class="row wrap note" aria-label=${words.couplings} data-testid="handles">
          <p role="status">${words.kept}</p>
          ${this.#couplings(handles)}
          ${reset}
        </section>`;
    const isCurve = handles.kind === "tmp";
    const option = (changes: "pose" | "goal", text: string, meaning = "") =>
      html`<button class="chip" aria-pressed=${handles.changes === changes ? "true" : "false"} data-testid="drag-${changes}" title=${meaning} @click=${() => handles.choose(changes)}>${text}</button>`;
    const tempo = ({ target }: Event) => {
      handles.tempo = 2 ** Number((target as HTMLInputElement).value);
    };
    return html`
      <section class="row wrap note" aria-label=${words.title} data-testid="handles">
        <p role="status">${isCurve ? words.curve : words.system}</p>
        <label class="row">${words.tempo(handles.tempo)} <input type="range" min="-1" max="1" step="0.1" data-testid="handle-tempo" .value=${String(Math.log2(handles.tempo))} @input=${tempo} /></label>
        ${
          isCurve
            ? nothing
            : html`<div class="row" role="group" aria-label=${words.drag}>${words.drag}${option("pose", words.pose, words.poseMeaning)}${option("goal", handles.kind === "dmp-rhythmic" ? words.centre : words.goal)}</div>`
        }
        <button class="small" data-testid="lift" title=${words.liftMeaning} @click=${() => handles.lift()}>${words.lift}</button>
        ${reset}
      </section>`;
  }
}
customElements.define("pg-handles", HandlesView);

declare global {
  interface HTMLElementTagNameMap {
    "pg-handles": HandlesView;
  }
}
