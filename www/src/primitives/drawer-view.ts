// The primitives of each part as small moving figures, of which only the part is in colour: drag one onto the body, or press it.
import { html } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { exampleOf, primitivesOf } from "./combinations";
import { DRAGGED } from "./dragged";
import "./figure-view";
import type { LibraryStore } from "./library-store";

export class DrawerView extends View {
  static override properties = { playing: {} };
  declare library: LibraryStore;
  declare playing: boolean;

  protected override stores() {
    return [this.library];
  }

  #card(part: number, primitive: number) {
    const { library } = this;
    const info = library.known?.info;
    if (!info) return html``;
    const { name } = info.primitives[primitive] ?? { name: "" };
    const on = library.uses[part] === primitive;
    return html`
      <button class="primitive" draggable="true" aria-pressed=${on ? "true" : "false"} data-testid="primitive-${part}-${primitive}"
        aria-label="${info.parts[part]?.name}: ${name}"
        @dragstart=${(event: DragEvent) => event.dataTransfer?.setData(DRAGGED, String(primitive))}
        @click=${() => library.choose(part, primitive)}>
        <pg-small-figure .body=${library.body} .motion=${library.motionOf(exampleOf(info, primitive))} .accent=${part} .playing=${this.playing}></pg-small-figure>
        <span>${name}</span>
      </button>`;
  }

  protected override render() {
    const info = this.library.known?.info;
    if (!info) return html``;
    return html`
      <h2>Primitives</h2>
      <p class="hint">What each part has learned to do. Press one, or drag it onto the body: the other parts go on.</p>
      ${info.parts.map(
        ({ name }, part) => html`
        <div class="drawer-part" role="group" aria-label="Primitives of ${name}" style=${partStyle(partColour(part))}>
          <h3 class="part-name"><i class="swatch"></i>${name}</h3>
          <div class="drawer-cards">${primitivesOf(info, part).map((primitive) => this.#card(part, primitive))}</div>
        </div>`,
      )}`;
  }
}
customElements.define("pg-drawer", DrawerView);
