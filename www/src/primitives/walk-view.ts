// The large figure, with a slot on the body for each part's primitive.
import { html, nothing, svg } from "lit";
import { bodyOf, type Body as MapBody, HEIGHT, NODE, WIDTH } from "./body-layout";
import type { Motion } from "../engine/protocol";
import { letDragLimbs } from "../live/drag-limbs";
import type { StageView } from "../stage/stage-view";
import "../stage/stage-view";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { exampleOf, DRAG_TYPE } from "./combinations";
import type { LibraryStore } from "./library-store";
import { lab, shownPart } from "../words/lab";
import { primitivesWords } from "./view-words";

export class WalkView extends View {
  static override properties = { over: { state: true } };
  declare library: LibraryStore;
  /** The part below a dragged primitive. */
  over: number | null = null;
  #map: { key: unknown; body: MapBody } | null = null;

  /** Called by the key for play. */
  togglePlay(): void {
    this.library.playback.togglePlay();
  }

  step(direction: 1 | -1): void {
    this.library.playback.step(direction);
  }

  protected override arrived(): void {
    const stage = this.querySelector<StageView>("pg-stage");
    // The stage draws its canvas after this view.
    void stage?.updateComplete.then(() => this.whenLeaving(letDragLimbs(stage, this.library.walk)));
  }

  /** The figure, whose limbs can be dragged. */
  protected figure(testId: string, label: string) {
    const { stage, playback } = this.library;
    return html`<pg-stage class="cover" .stage=${stage} .playback=${playback} .running=${true} .label=${label} .testId=${testId}></pg-stage>`;
  }

  /** A motion of this body from its start, which defines the height of the ground. */
  #example(): Motion | null {
    const { current, uses } = this.library;
    return current && this.library.motionOf(exampleOf(current.info, uses[0] ?? 0));
  }

  /** Chooses the dropped primitive, if it belongs to the part. */
  #drop(event: DragEvent, part: number): void {
    this.over = null;
    const primitive = Number(event.dataTransfer?.getData(DRAG_TYPE) || Number.NaN);
    if (!Number.isInteger(primitive)) return;
    event.preventDefault();
    this.library.choose(part, primitive);
  }

  #slots() {
    const { library } = this;
    const info = library.current?.info;
    const motion = this.#example();
    if (!info || !motion) return nothing;
    if (this.#map?.key !== motion) this.#map = { key: motion, body: bodyOf(info, motion) };
    const { spots, bones } = this.#map.body;
    const accepts = (event: DragEvent, part: number) => {
      if (!event.dataTransfer?.types.includes(DRAG_TYPE)) return;
      event.preventDefault();
      this.over = part;
    };
    return html`
      <svg class="slots" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${primitivesWords().walk.slots(library.title)}>
        ${bones.map(({ a, b, part }) => svg`<line class="map-bone" style=${partStyle(partColour(part))} x1=${a.x} y1=${a.y} x2=${b.x} y2=${b.y} />`)}
        ${info.parts.map(({ name }, part) => {
          const spot = spots[part];
          const primitive = info.primitives[library.uses[part] ?? -1]?.name ?? "";
          if (!spot) return nothing;
          return svg`
            <g class=${this.over === part ? "slot over" : "slot"} data-testid="slot-${part}" style=${partStyle(partColour(part))}
              @dragover=${(event: DragEvent) => accepts(event, part)} @dragleave=${() => {
                this.over = null;
              }} @drop=${(event: DragEvent) => this.#drop(event, part)}>
              <title>${shownPart(name)}: ${primitive}</title>
              <circle class="slot-reach" cx=${spot.x} cy=${spot.y} r=${2.4 * NODE} />
              <circle class="map-node" cx=${spot.x} cy=${spot.y} r=${NODE} />
              <text x=${spot.x} y=${spot.y + 2.3 * NODE}>${primitive}</text>
            </g>`;
        })}
      </svg>`;
  }

  protected override render() {
    const { library } = this;
    const { playing } = library.playback;
    const { recorded } = library;
    const words = primitivesWords().walk;
    const { time } = lab();
    return html`
      <div class="walk-box">
        ${this.figure("walk", words.figure(library.title))}
        ${this.#slots()}
        <p class="walk-words passive"><strong data-testid="combination-title">${library.title}</strong>
          <span class="quiet" data-testid="recorded">${recorded === null ? words.never : words.recordedAs(recorded)}</span></p>
        <button class="round primary walk-play" data-testid="walk-play" aria-label=${playing ? time.pause : time.play} title=${playing ? time.pauseMeaning : time.playMeaning}
          @click=${() => this.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
      </div>`;
  }
}
customElements.define("pg-walk", WalkView);
