// A tempo for each part, and a map of the tempos and strengths at which one part is locked to another.
import { html, nothing } from "lit";
import { partColour } from "../ui/palette";
import { partStyle, styled } from "../ui/styled";
import { fixed, sentence, short } from "../ui/format";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import type { LibraryStore } from "./library-store";
import { type LockingStore, type LockingMap, STRENGTHS, TEMPOS } from "./locking-store";
import { lab, shownPart } from "../words/lab";
import { primitivesWords } from "../words/primitives";

/** Steps of arrow keys in the map: tempos up, strengths to the right. */
const STEPS: Record<string, [number, number]> = {
  ArrowUp: [1, 0],
  ArrowDown: [-1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

/** Below this share of the coupling's effect, the effect of the tempo is not visible in the map. */
const STRIPES = 0.25;

const times = (strength: number) => (strength < 1 ? `1/${1 / strength}` : String(strength));

export class ChimeraView extends View {
  static override properties = { at: { state: true } };
  declare library: LibraryStore;
  declare locking: LockingStore;
  /** The indices of the point in the order of the Tab key: tempo and strength. */
  declare at: readonly [number, number];

  constructor() {
    super();
    this.at = [TEMPOS.indexOf(1), STRENGTHS.indexOf(1)];
  }

  protected override stores() {
    return [this.library, this.locking];
  }

  #name(part: number): string {
    return shownPart(this.library.current?.info.parts[part]?.name ?? "");
  }

  #tempo(tempo: number, part: number) {
    const name = this.#name(part);
    const words = primitivesWords().chimera;
    return html`
      <label class="tempo" style=${partStyle(partColour(part))}>
        <span class="part-name"><i class="swatch"></i>${name}</span>
        <input type="range" min="0.5" max="2" step="0.05" .value=${String(tempo)} data-testid="tempo-${part}"
          aria-label=${words.tempoOf(name)} aria-valuetext=${words.times(tempo)}
          @input=${(event: Event) => this.library.setTempo(part, (event.target as HTMLInputElement).valueAsNumber)}
          @dblclick=${() => this.library.setTempo(part, 1)} />
        <output>${fixed(tempo, 2)}</output>
      </label>`;
  }

  #keys(event: KeyboardEvent): void {
    const step = STEPS[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const within = (index: number, length: number) => Math.min(length - 1, Math.max(0, index));
    this.at = [within(this.at[0] + step[0], TEMPOS.length), within(this.at[1] + step[1], STRENGTHS.length)];
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(".locking [tabindex='0']")?.focus());
  }

  #cell(map: LockingMap, k: number, l: number) {
    const [tempo = 1, strength = 1] = [TEMPOS[k], STRENGTHS[l]];
    const value = map.rows[k]?.[l];
    const { taken } = this.locking;
    const on = taken?.tempo === tempo && taken.strength === strength;
    const words = primitivesWords().chimera;
    const text = words.point(
      tempo,
      times(strength),
      value === undefined ? words.notYet : words.locking(value),
    );
    return html`
      <td><button class=${value === undefined ? "point waiting" : "point"} data-testid="locking-${k}-${l}" aria-pressed=${on ? "true" : "false"}
        tabindex=${this.at[0] === k && this.at[1] === l ? 0 : -1} style=${styled({ "--at": (value ?? 0).toFixed(3) })}
        aria-label=${text} title=${text}
        @click=${() => {
          this.at = [k, l];
          this.locking.take(tempo, strength);
        }}></button></td>`;
  }

  #map(map: LockingMap) {
    const target = this.#name(map.target);
    const source = this.#name(map.source);
    const words = primitivesWords().chimera;
    const alpha = short(map.alpha[map.source]?.[map.target] ?? 1);
    const tempos = [...TEMPOS.keys()].reverse();
    return html`
      <table class="locking" style=${partStyle(partColour(map.target))} @keydown=${this.#keys}
        aria-label=${words.map(target, source)}>
        <tbody>
          ${tempos.map((k) => html`<tr><th scope="row">${fixed(TEMPOS[k] ?? 1, 2)}</th>${STRENGTHS.map((_, l) => this.#cell(map, k, l))}</tr>`)}
          <tr><td></td>${STRENGTHS.map((strength) => html`<th scope="col">${times(strength)}</th>`)}</tr>
        </tbody>
      </table>
      <p class="hint axes">${words.axes(target, source, alpha)}</p>
      <p class="hint legend" style=${partStyle(partColour(map.target))}><span>${words.ownWay}</span><i class="shade"></i><span>${words.inStep}</span></p>
      <p class="hint" role="status" data-testid="locking-words">${this.#effects()}</p>`;
  }

  /** What the map shows: whether the tempo matters at all. */
  #effects(): string {
    const { effects } = this.locking;
    if (!effects) return "";
    const { tempo, strength } = effects;
    const words = primitivesWords().chimera;
    const measured = words.effects(tempo, strength);
    return tempo < STRIPES * strength ? words.stripes(measured) : measured;
  }

  #pair() {
    const { locking } = this;
    const parts = this.library.current?.info.parts ?? [];
    const choice = (label: string, chosen: number, other: number, take: (part: number) => void) => html`
      <label>${label} <select aria-label=${label} @change=${(event: Event) => take(Number((event.target as HTMLSelectElement).value))}>
        ${parts.map(({ name }, part) => html`<option value=${part} ?selected=${part === chosen} ?disabled=${part === other}>${shownPart(name)}</option>`)}
      </select></label>`;
    const { leads, follows } = primitivesWords().chimera;
    return html`
      ${choice(leads, locking.source, locking.target, (part) => locking.choose(part, locking.target))}
      ${choice(follows, locking.target, locking.source, (part) => locking.choose(locking.source, part))}`;
  }

  protected override render() {
    const { library, locking } = this;
    if (!library.current) return nothing;
    const { busy, map, problem, fraction } = locking;
    const words = primitivesWords().chimera;
    const several = library.current.info.parts.length > 1;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about}</p>
      ${library.tempos.map((tempo, part) => this.#tempo(tempo, part))}
      ${
        several
          ? html`
          <div class="fit-row">${this.#pair()}
            <button class="small" data-testid=${busy ? "locking-cancel" : "locking-make"} @click=${() => (busy ? locking.cancel() : void locking.make())}>${busy ? lab().learn.training.cancel : words.make}</button></div>
          ${progressBar(words.making, busy ? fraction : null)}
          ${
            map
              ? this.#map(map)
              : html`<p class=${problem ? "bad" : "hint"} role="status">${
                  problem ? sentence(problem) : words.empty
                }</p>`
          }`
          : nothing
      }`;
  }
}
customElements.define("pg-chimera", ChimeraView);
