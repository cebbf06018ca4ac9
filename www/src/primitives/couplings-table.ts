// The couplings of the combination that walks, as a table of sliders.
import { html } from "lit";
import { isOff, sharesOf, shareWord } from "../couplings/shares";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "../couplings/strength";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import { partStyle, styled } from "../ui/styled";
import type { LibraryStore } from "./library-store";

export function couplingsTable(library: LibraryStore) {
  const parts = library.known?.info.parts ?? [];
  const name = (part: number) => parts[part]?.name ?? "";
  const head = (part: number) =>
    html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${name(part)}</span>`;
  const cell = (source: number, target: number) => {
    const alpha = library.alpha[source]?.[target] ?? 1;
    const nearest = library.nearest[source]?.[target] ?? 1;
    const w = sharesOf(library.alpha.map((row) => row[target] ?? 1))[source] ?? 0;
    const label = `${name(source)} to ${name(target)}`;
    const back = () => library.setCoupling(source, target, nearest);
    return html`
      <td style=${partStyle(partColour(source))} class=${isOff(w) ? "off" : ""}>
        <div class="slider">
          <span class="fill" style=${styled({ "--at": placeOf(alpha).toFixed(4) })}></span>
          <span class="tick" style=${styled({ "--at": placeOf(nearest).toFixed(4) })} title="As it was: ${short(nearest)}"></span>
          <input type="range" min=${WEAKEST} max=${STRONGEST} step="0.01" .value=${strengthOf(alpha).toFixed(2)}
            aria-label=${label} aria-valuetext="alpha ${short(alpha)}, weight ${shareWord(w)}" data-testid="walk-coupling-${source}-${target}"
            title="${label}: drag to change, double click to reset"
            @input=${(event: Event) => library.setCoupling(source, target, alphaOf((event.target as HTMLInputElement).valueAsNumber))}
            @keydown=${(event: KeyboardEvent) => {
              if (event.key !== "Backspace" && event.key !== "Delete") return;
              event.preventDefault();
              back();
            }}
            @dblclick=${back} />
        </div>
        <div class="numbers">
          <span title="alpha, the variance of this prediction: small means influential"><i>α</i> <output data-testid="walk-alpha-${source}-${target}">${short(alpha)}</output></span>
          <span title="weight of this prediction; the weights into a part sum to 1"><i>w</i> <output>${shareWord(w)}</output></span>
        </div>
      </td>`;
  };
  return html`
    <div class="table-box">
      <table class="couplings" data-parts=${parts.length}>
        <thead><tr><td><small>who decides</small></td>
          ${parts.map((_, target) => html`<th scope="col"><small>about</small> ${head(target)}</th>`)}</tr></thead>
        <tbody>${parts.map(
          (_, source) =>
            html`<tr><th scope="row">${head(source)}</th>${parts.map((__, target) => cell(source, target))}</tr>`,
        )}</tbody>
      </table>
    </div>`;
}
