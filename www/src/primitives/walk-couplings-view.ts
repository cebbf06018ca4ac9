// The couplings of the walking combination, set by hand or fitted, and the buttons that keep the combination.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import { type CouplingSlider, couplingSlider } from "../couplings/coupling-slider";
import type { CouplingsStore } from "../couplings/couplings-store";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import { withTerms } from "../terms/term";
import type { FittingStore } from "./fitting-store";
import type { LibraryStore } from "./library-store";
import { lab, shownPart } from "../words/lab";
import { primitivesWords } from "./view-words";
import { LARGEST_COUPLING } from "../engine/limits";
import { sentence } from "../ui/format";
import type { LibraryInfo, PartMotion } from "../engine/library-protocol";

interface CutButton {
  names: readonly [source: string, target: string];
  held: boolean;
  hold(held: boolean): void;
}

interface CouplingsTable extends Pick<CouplingSlider, "trained" | "prefix"> {
  couplings: CouplingsStore;
  /** The names of the parts. */
  parts: readonly string[];
  /** Cuts a coupling, or restores it: a button of each coupling does while it is held. */
  hold(source: number, target: number, held: boolean): void;
  isCut(source: number, target: number): boolean;
}

/** A button that cuts a coupling while it is held, by pointer or by key. */
function cutButton({ names, held, hold }: CutButton) {
  const words = primitivesWords().couplings;
  const key = (event: KeyboardEvent) => {
    if (event.repeat || (event.key !== " " && event.key !== "Enter")) return;
    event.preventDefault();
    hold(event.type === "keydown");
  };
  const press = (event: PointerEvent) => {
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    hold(true);
  };
  const release = () => hold(false);
  return html`<button class="small cut-button" aria-pressed=${held ? "true" : "false"} title=${words.cutMeaning}
    aria-label=${words.cutOf(...names)} @pointerdown=${press} @pointerup=${release} @pointercancel=${release}
    @keydown=${key} @keyup=${key} @blur=${release}>${words.cut}</button>`;
}

function couplingsTable({ couplings, parts, hold, isCut, ...how }: CouplingsTable) {
  const words = lab().couplings;
  const head = (part: number) =>
    html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${parts[part] ?? ""}</span>`;
  const cell = (source: number, target: number) => {
    const names = [parts[source] ?? "", parts[target] ?? ""] as const;
    const button = {
      names,
      held: isCut(source, target),
      hold: (held: boolean) => hold(source, target, held),
    };
    return html`<td>${couplingSlider({ couplings, source, target, names, ...how })}${cutButton(button)}</td>`;
  };
  return html`
    <div class="table-box">
      <table class="couplings" data-parts=${parts.length}>
        <thead>
          <tr>
            <td><small>${words.decides}</small></td>
            ${parts.map((_, target) => html`<th scope="col"><small>${words.about}</small> ${head(target)}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${parts.map(
            (_, source) => html`
            <tr>
              <th scope="row">${head(source)}</th>
              ${parts.map((__, target) => cell(source, target))}
            </tr>`,
          )}
        </tbody>
      </table>
    </div>`;
}

/** Names the parts that rest under these couplings, with the reason; empty if all parts move. */
export function restingPartsText(
  { parts, primitives }: LibraryInfo,
  uses: readonly number[],
  moves: readonly PartMotion[],
): string {
  const words = primitivesWords().couplings.rests;
  const name = (part: number) => shownPart(parts[part]?.name ?? "");
  const primitive = (part: number) => `${name(part)}: ${primitives[uses[part] ?? -1]?.name ?? ""}`;
  const why = ({ leader }: PartMotion, part: number): string => {
    if (!leader) return words.alone;
    const { weight, met } = leader;
    const share = words.decides(name(leader.part), weight, name(part));
    if (weight < 0.5) return `${share}${words.ownRest}`;
    return met
      ? `${share}${words.doesNotDrive}`
      : `${share}${words.neverLearned(primitive(leader.part), primitive(part))}`;
  };
  return moves
    .flatMap((motion, part) => (motion.still ? [words.keepsPose(name(part)), why(motion, part)] : []))
    .map(sentence)
    .join(" ");
}

type Fit = Pick<FittingStore, "busy" | "iteration" | "elapsed" | "ending" | "unexplained">;

export function fitText({ busy, iteration, elapsed, ending, unexplained }: Fit): {
  text: string;
  failed: boolean;
} {
  const texts = primitivesWords().couplings;
  if (busy) return { text: lab().learn.training.iteration(iteration), failed: false };
  const { words, failed } = ending;
  if (!words) return { text: texts.fitAbout, failed };
  if (failed) return { text: sentence(words), failed };
  if (unexplained.length === 0) return { text: texts.fitted(sentence(words), elapsed), failed };
  return { text: texts.unexplained(unexplained.map(shownPart), LARGEST_COUPLING, elapsed), failed: true };
}

export class WalkCouplingsView extends View {
  declare library: LibraryStore;
  declare fitting: FittingStore;
  declare clips: ClipsStore;
  /** The key of the clip to fit to; empty for the first clip. */
  #clip = "";

  protected override stores() {
    return [this.library, this.library.walk, this.fitting, this.clips];
  }

  /** The text about parts that rest. */
  #still({ current, uses, moves }: LibraryStore) {
    const text = current ? restingPartsText(current.info, uses, moves) : "";
    return html`<p class="still-words" role="status" data-testid="still-words">${text}</p>`;
  }

  #fit() {
    const { fitting } = this;
    const clips = this.clips.ofBody(this.library.current?.info.joints ?? []);
    const { busy, status } = fitting;
    const key = clips.some((clip) => clip.key === this.#clip) ? this.#clip : (clips[0]?.key ?? "");
    const { text, failed } = fitText(fitting);
    const words = primitivesWords().couplings;
    return html`
      <div class="fit-row row wrap">
        <label class="row tight quiet note">${words.clip} <select data-testid="fit-clip" ?disabled=${busy} @change=${(
          event: Event,
        ) => {
          this.#clip = (event.target as HTMLSelectElement).value;
          this.requestUpdate();
        }}>${clips.map((clip) => html`<option value=${clip.key} ?selected=${clip.key === key}>${clip.title}</option>`)}</select></label>
        <button class="small" data-testid=${busy ? "fit-cancel" : "fit"} ?disabled=${busy ? status === "cancelling" : key === ""}
          @click=${() => (busy ? fitting.cancel() : void fitting.fit(key))}>${busy ? lab().learn.training.cancel : words.fit}</button>
      </div>
      ${progressBar(words.fitting, busy ? fitting.fraction : null)}
      <p class=${failed ? "bad" : "hint"} role="status" data-testid="fit-words">${text}</p>`;
  }

  protected override render() {
    const { library } = this;
    if (!library.current) return nothing;
    const { movements, parts } = library.current.info;
    const words = primitivesWords().couplings;
    return html`
      <header class="panel-head row"><h2>${withTerms(words.title)}</h2>
        <button class="small" ?disabled=${!library.couplings.altered} @click=${() => library.couplings.resetAll()}>${words.reset}</button></header>
      <p class="hint">${words.about}</p>
      ${couplingsTable({
        couplings: library.couplings,
        parts: parts.map(({ name }) => shownPart(name)),
        trained: false,
        prefix: "walk-",
        hold: (source, target, held) => void library.walk.hold(source, target, held),
        isCut: (source, target) => library.walk.isCut(source, target),
      })}
      ${this.#still(library)}
      ${this.#fit()}
      <div class="row wrap">
        <button class="small" data-testid="keep-combination" title=${words.keepMeaning}
          @click=${() => void library.keep(this.#name(movements.map(({ name }) => name)))}>${words.keep}</button>
        <button class="small primary" data-testid="put-on-stage" title=${words.stageMeaning}
          @click=${() => this.tell("put-on-stage")}>${words.stage}</button>
      </div>`;
  }

  /** A name that no movement has. */
  #name(taken: readonly string[]): string {
    const { current, uses } = this.library;
    const text = uses.map((primitive) => current?.info.primitives[primitive]?.name ?? "").join(" + ");
    if (!taken.includes(text)) return text;
    for (let number = 2; ; number++) if (!taken.includes(`${text} ${number}`)) return `${text} ${number}`;
  }
}
customElements.define("pg-walk-couplings", WalkCouplingsView);
