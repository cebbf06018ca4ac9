// Gives one part of the model's body to a recording: which part, which recording, and until when.
import { html, nothing } from "lit";
import type { ModelStore } from "../couplings/model-store";
import type { PartCompletion } from "../engine/whole-protocol";
import { fixed } from "../ui/format";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { completingWords } from "../words/sections";
import "./completing.css";
import type { CompletingStore } from "./completing-store";
import { shownPart } from "../words/lab";

export class CompletingView extends View {
  declare completing: CompletingStore;
  declare model: ModelStore;

  /** The error of a part in errors of the mean pose. */
  #score({ part, mse, mseMeanPose, afterCut }: PartCompletion) {
    const { error, after } = completingWords();
    const ratio = (now: { mse: number; mseMeanPose: number }) => fixed(now.mse / now.mseMeanPose, 2);
    const place = this.model.model?.info.parts.findIndex(({ name }) => name === part) ?? 0;
    return html`
      <p class="limbs" data-testid="completed-${place}" style=${partStyle(partColour(place))}>
        <i class="swatch"></i>${error(shownPart(part), ratio({ mse, mseMeanPose }))}${afterCut ? html`, ${after(ratio(afterCut))}` : nothing}
      </p>`;
  }

  #until(seconds: number | null, [first, last]: readonly [number, number]) {
    const words = completingWords();
    const now = seconds ?? last;
    return html`
      <label class="completing-until row wrap loose">${words.until}
        <input type="range" min=${first} max=${last} step="any" .value=${String(now)} data-testid="completing-until"
          aria-valuetext=${seconds === null ? words.toTheEnd : words.seconds(fixed(now, 1))}
          @input=${(event: Event) => this.completing.observeUntil((event.target as HTMLInputElement).valueAsNumber)} />
        <output>${seconds === null ? words.toTheEnd : words.seconds(fixed(now, 1))}</output>
      </label>`;
  }

  protected override render() {
    const { completing, model } = this;
    const words = completingWords();
    const parts = model.model?.info.parts ?? [];
    const { clip, clips, shown, part, scores } = completing;
    if (!clip) return nothing;
    const chips = parts.map(
      ({ name }, place) => html`
        <button class="chip" type="button" aria-pressed=${place === part ? "true" : "false"} data-testid="given-${place}"
          style=${partStyle(partColour(place))} @click=${() => completing.give(place)}>${shownPart(name)}</button>`,
    );
    return html`
      <p class="hint">${words.about}</p>
      <div class="choices" role="group" aria-label=${words.given}><span>${words.given}</span>${chips}</div>
      <label>${words.recording}
        <select data-testid="completing-clip" @change=${(event: Event) => completing.chooseClip((event.target as HTMLSelectElement).value)}>
          ${clips.map(({ key, title }) => html`<option value=${key} ?selected=${key === clip.key}>${title}</option>`)}
        </select></label>
      ${this.#until(completing.until, completing.times)}
      <button type="button" class="small" aria-pressed=${shown ? "true" : "false"} data-testid="complete"
        @click=${() => (shown ? completing.hide() : completing.show())}>${shown ? words.stop : words.show}</button>
      <div role="status" data-testid="completed">
        ${scores && shown ? html`${scores.map((score) => this.#score(score))}<p class="hint">${words.meaning}</p>` : nothing}
      </div>`;
  }
}
customElements.define("pg-completing", CompletingView);
