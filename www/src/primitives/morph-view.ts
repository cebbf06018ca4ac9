// The mixture of two primitives of a part.
import { html, nothing } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { primitivesOf } from "./combinations";
import type { LibraryStore } from "./library-store";
import { primitivesWords } from "../words/primitives";
import { shownPart } from "../words/lab";

export class MorphView extends View {
  declare library: LibraryStore;

  protected override stores() {
    return [this.library];
  }

  #slider(part: number) {
    const { library } = this;
    const info = library.current?.info;
    if (!info) return nothing;
    const from = library.uses[part] ?? 0;
    const others = primitivesOf(info, part).filter((primitive) => primitive !== from);
    const mix = library.mixes[part];
    const other = mix?.other ?? others[0];
    if (other === undefined) return nothing;
    const share = mix?.share ?? 0;
    const name = (primitive: number) => info.primitives[primitive]?.name ?? "";
    const title = shownPart(info.parts[part]?.name ?? "");
    const words = primitivesWords().morph;
    return html`
      <div class="morph" style=${partStyle(partColour(part))}>
        <span class="part-name"><i class="swatch"></i>${title}</span>
        <span>${name(from)}</span>
        <input type="range" min="0" max="1" step="0.01" .value=${String(share)} data-testid="morph-${part}"
          aria-label=${words.fromTo(title, name(from), name(other))} aria-valuetext=${words.share(share, name(other))}
          @input=${(event: Event) => library.setMix(part, other, (event.target as HTMLInputElement).valueAsNumber)}
          @dblclick=${() => library.setMix(part, other, 0)} />
        ${
          others.length === 1
            ? html`<span>${name(other)}</span>`
            : html`<select aria-label=${words.towards(title)} @change=${(event: Event) =>
                library.setMix(part, Number((event.target as HTMLSelectElement).value), share)}>
                ${others.map((choice) => html`<option value=${choice} ?selected=${choice === other}>${name(choice)}</option>`)}</select>`
        }
      </div>`;
  }

  protected override render() {
    const parts = this.library.current?.info.parts ?? [];
    return html`
      <h2>${primitivesWords().morph.title}</h2>
      <p class="hint">${primitivesWords().morph.about}</p>
      ${parts.map((_, part) => this.#slider(part))}`;
  }
}
customElements.define("pg-morph", MorphView);
