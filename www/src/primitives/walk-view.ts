// The large figure, with a slot on the body for each part's primitive.
import { html, nothing, svg } from "lit";
import { bodyOf, type Body as MapBody, HEIGHT, NODE, WIDTH } from "./body-layout";
import type { Motion } from "../engine/protocol";
import { Columns } from "../scene/columns";
import type { LiveTrack } from "../scene/live-track";
import { eachFrame } from "../ui/browser";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { exampleOf, DRAG_TYPE } from "./combinations";
import type { LibraryStore } from "./library-store";
import { lab, shownPart } from "../words/lab";
import { primitivesWords } from "./view-words";
import "../stage/stage-canvas.css";

export class WalkView extends View {
  static override properties = { over: { state: true } };
  declare library: LibraryStore;
  /** The part below a dragged primitive. */
  declare over: number | null;
  #columns: Columns | null = null;
  #hasGraphics = true;
  #drawnTrack: LiveTrack | null = null;
  #drawnAt = -1;
  #map: { key: unknown; body: MapBody } | null = null;

  constructor() {
    super();
    this.over = null;
  }

  protected override stores() {
    return [this.library, this.library.walk];
  }

  /** Called by the key for play. */
  togglePlay(): void {
    this.library.walk.togglePlay();
  }

  step(direction: 1 | -1): void {
    this.library.walk.step(direction);
  }

  protected override arrived(): void {
    const canvas = this.querySelector("canvas");
    try {
      if (canvas) this.#columns = new Columns(canvas);
    } catch {
      this.#hasGraphics = false;
      this.requestUpdate();
    }
    this.whenLeaving(eachFrame((seconds) => this.#tick(seconds)));
    this.whenLeaving(() => {
      this.#columns?.dispose();
      this.#columns = null;
      this.#drawnTrack = null;
    });
  }

  #tick(seconds: number): void {
    const { walk, current } = this.library;
    const { track, player } = walk;
    walk.advance(seconds);
    if (!track || !current || !this.#columns) return;
    if (track !== this.#drawnTrack) this.#show(track);
    const changed = player.frame !== this.#drawnAt;
    this.#drawnAt = player.frame;
    this.#columns.draw(player.frame - track.first, changed, seconds, player.playing);
  }

  #show(track: LiveTrack): void {
    const { body } = this.library;
    const ground = this.#example();
    if (!body || !ground) return;
    this.#drawnTrack = track;
    this.#columns?.show(body, [{ motion: track.motion, ghost: null, ground }]);
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
    const { playing } = library.walk.player;
    const { recorded } = library;
    const words = primitivesWords().walk;
    const { time } = lab();
    return html`
      <div class="walk-box">
        <canvas class="stage-canvas" tabindex="0" role="img" data-testid="walk"
          aria-label=${words.figure(library.title)}></canvas>
        ${this.#hasGraphics ? nothing : html`<p class="stage-problem" role="alert">${words.noGraphics}</p>`}
        ${this.#slots()}
        <p class="walk-words"><strong data-testid="combination-title">${library.title}</strong>
          <span data-testid="recorded">${recorded === null ? words.never : words.recordedAs(recorded)}</span></p>
        <button class="round primary walk-play" data-testid="walk-play" aria-label=${playing ? time.pause : time.play} title=${playing ? time.pauseMeaning : time.playMeaning}
          @click=${() => this.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
      </div>`;
  }
}
customElements.define("pg-walk", WalkView);
