// The choices for learning a library: clips, their groups, and shared parts.
import { html } from "lit";
import { progressRow } from "../training/progress-row";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import type { LearningClip, LearningStore } from "./learning-store";
import { primitivesWords } from "./view-words";
import { shownPart } from "../words/lab";

export class LearningView extends View {
  declare learning: LearningStore;

  protected override stores() {
    return [this.learning];
  }

  #clip({ key, title, chosen, movement }: LearningClip) {
    const { learning } = this;
    const words = primitivesWords().learning;
    return html`
      <li class="learning-clip">
        <label><input type="checkbox" .checked=${chosen} ?disabled=${learning.busy} aria-label=${words.from(title)}
          @change=${(event: Event) => learning.choose(key, (event.target as HTMLInputElement).checked)} /> <span>${title}</span></label>
        <input type="text" .value=${movement} ?disabled=${learning.busy || !chosen} aria-label=${words.movement(title)}
          @change=${(event: Event) => learning.rename(key, (event.target as HTMLInputElement).value)} />
      </li>`;
  }

  #part(name: string, part: number) {
    const { learning } = this;
    const choice = (shared: boolean, words: string) => html`
      <button aria-pressed=${learning.isShared(name) === shared ? "true" : "false"} ?disabled=${learning.busy} data-testid="share-${part}-${shared ? "same" : "own"}"
        @click=${() => learning.setShared(name, shared)}>${words}</button>`;
    const { drawer, learning: texts } = primitivesWords();
    return html`
      <div class="learning-part" role="group" aria-label=${drawer.of(shownPart(name))} style=${partStyle(partColour(part))}>
        <span class="part-name"><i class="swatch"></i>${shownPart(name)}</span>
        <span class="segments">${choice(true, texts.same)}${choice(false, texts.own)}</span>
      </div>`;
  }

  protected override render() {
    const { learning } = this;
    const words = primitivesWords().learning;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about(words.same, words.own)}</p>
      <div class="learning">
        <ul class="learning-clips">${learning.clips.map((clip) => this.#clip(clip))}</ul>
        <div>
          ${learning.parts.map(({ name }, part) => this.#part(name, part))}
          ${progressRow({
            progress: learning,
            verb: [words.learn, words.going, words.done],
            testIds: ["learn", "learn-cancel", "learn-words"],
            whyNot: learning.whyNot,
            hint: words.hint,
            start: () => void learning.learn(),
          })}
        </div>
      </div>`;
  }
}
customElements.define("pg-learning", LearningView);
