// All combinations of a library's primitives as small figures. A press chooses one.
import { html, nothing } from "lit";
import { View } from "../ui/view";
import { isSame, recordedAs, titleOf } from "./combinations";
import "./small-figure-view";
import type { LibraryStore } from "./library-store";
import { primitivesWords } from "../words/primitives";

export class GalleryView extends View {
  static override properties = { playing: {} };
  declare library: LibraryStore;
  declare playing: boolean;

  protected override stores() {
    return [this.library];
  }

  protected override render() {
    const { library } = this;
    const info = library.current?.info;
    if (!info) return html``;
    const words = primitivesWords().gallery;
    const card = (uses: number[]) => {
      const recorded = recordedAs(info, uses);
      return html`
        <button class="combination" data-testid="combination" aria-pressed=${isSame(uses, library.uses) ? "true" : "false"}
          @click=${() => library.take(uses)}>
          <pg-small-figure .body=${library.body} .motion=${library.motionOf(uses)} .accent=${null} .playing=${this.playing}></pg-small-figure>
          <span>${titleOf(info, uses)}</span>
          <small>${recorded === null ? words.never : words.recordedAs(recorded)}</small>
        </button>`;
    };
    return html`
      <h2>${words.title}</h2>
      <div class="gallery">${library.combinations.map(card)}</div>
      ${library.notShown > 0 ? html`<p class="hint">${words.more(library.notShown)}</p>` : nothing}`;
  }
}
customElements.define("pg-gallery", GalleryView);
