// The primitives of each part as small moving figures with the part in colour. A press or a drag onto the
// body
// chooses one.
import { html, nothing } from "lit";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { exampleOf, primitivesOf, DRAG_TYPE } from "./combinations";
import "./small-figure-view";
import type { LibraryStore } from "./library-store";
import { primitivesWords } from "./view-words";
import { shownPart } from "../words/lab";
import type { PrimitiveOrigin } from "../engine/library-protocol";

/** "walk-1, walk-2 and 3 more" */
function list(names: readonly string[]): string {
  const different = [...new Set(names)];
  const first = different.slice(0, 2).join(", ");
  return different.length > 2 ? primitivesWords().origin.more(first, different.length - 2) : first;
}

/** "Learned from walk-1, walk-2; 400 iterations, seed 8." */
export function originText({ clips, iterations, seed, relearned, note }: PrimitiveOrigin): string {
  const words = primitivesWords().origin;
  const from = (some: PrimitiveOrigin["clips"]) => list(some.map(({ name }) => name)) || words.unnamed;
  const how = words.how(iterations, seed);
  const text = relearned
    ? words.relearned(relearned.primitive, from(relearned.clips), words.frames[relearned.frames], how)
    : words.learned(from(clips), how);
  return note ? `${text} ${note}` : text;
}

export class DrawerView extends View {
  static override properties = { playing: {} };
  declare library: LibraryStore;
  declare playing: boolean;
  declare notices: NoticesStore;

  /** Saves the primitive as a file. */
  async #save(part: string, name: string, primitive: number): Promise<void> {
    try {
      const text = await this.library.primitiveText(primitive);
      download(`${part} ${name}.json`, new Blob([text], { type: "application/json" }));
    } catch (problem) {
      this.notices.addError(primitivesWords().drawer.notSaved(part, name), messageOf(problem));
    }
  }

  #card(part: number, primitive: number) {
    const { library } = this;
    const info = library.current?.info;
    const own = info?.primitives[primitive];
    if (!info || !own) return html``;
    const { name, origin } = own;
    const partName = info.parts[part]?.name ?? "";
    const on = library.uses[part] === primitive;
    const text = originText(origin);
    const words = primitivesWords().drawer;
    return html`
      <div class="primitive-box stack">
      <button class="primitive stack" draggable="true" aria-pressed=${on ? "true" : "false"} data-testid="primitive-${part}-${primitive}"
        aria-label="${shownPart(partName)}: ${name}" title=${text}
        @dragstart=${(event: DragEvent) => event.dataTransfer?.setData(DRAG_TYPE, String(primitive))}
        @click=${() => library.choose(part, primitive)}>
        <pg-small-figure .body=${library.body} .motion=${library.motionOf(exampleOf(info, primitive))} .accent=${part} .playing=${this.playing}></pg-small-figure>
        <span>${name}</span>
        ${origin.relearned ? html`<small>${words.relearned}</small>` : nothing}
      </button>
      <button class="small" data-testid="save-primitive-${part}-${primitive}" aria-label=${words.saveOf(shownPart(partName), name)} title=${words.saveMeaning(text)}
        @click=${() => void this.#save(partName, name, primitive)}>${words.save}</button>
      </div>`;
  }

  protected override render() {
    const info = this.library.current?.info;
    if (!info) return html``;
    const words = primitivesWords().drawer;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about}</p>
      ${info.parts.map(
        ({ name }, part) => html`
        <div class="drawer-part" role="group" aria-label=${words.of(shownPart(name))} style=${partStyle(partColour(part))}>
          <h3 class="part-name"><i class="swatch"></i>${shownPart(name)}</h3>
          <div class="drawer-cards">${primitivesOf(info, part).map((primitive) => this.#card(part, primitive))}</div>
        </div>`,
      )}`;
  }
}
customElements.define("pg-drawer", DrawerView);
