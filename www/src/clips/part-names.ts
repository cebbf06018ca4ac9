// The editor of part names, a row for each part, and the choice of the part of a joint or column.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { lab } from "../words/lab";

interface Named {
  name: string;
}

export interface PartNames {
  /** Each part's name, and how many joints or columns it has. */
  parts: readonly (Named & { size: number })[];
  /** The members of the parts. */
  of: "joints" | "columns";
  /** The most parts. */
  most: number;
  disabled: boolean;
  /** Why the last name was refused; empty after the next change. */
  refused: string;
  /** Renames a part and returns its name now. */
  rename(place: number, text: string): string;
  remove(place: number): void;
  add(): void;
}

/** Why a part cannot have this name; empty when it can. */
export function nameProblem(parts: readonly Named[], place: number, name: string): string {
  const { noName, taken } = lab().learn.parts;
  if (name === "") return noName;
  return parts.some((other, i) => i !== place && other.name === name) ? taken(name) : "";
}

/** The parts with a new name for one of them. */
export const renamed = <Part extends Named>(parts: readonly Part[], place: number, name: string): Part[] =>
  parts.map((part, i) => (i === place ? { ...part, name } : part));

/** A free name for a new part. */
export function freeName(parts: readonly Named[]): string {
  for (let i = parts.length + 1; ; i++) {
    const name = lab().learn.parts.free(i);
    if (!parts.some((part) => part.name === name)) return name;
  }
}

/** The colours of parts of these sizes. Empty parts are not trained and take no colour. */
export function partColours(sizes: readonly number[]): string[] {
  let trained = 0;
  return sizes.map((size) => {
    if (size === 0) return "var(--line)";
    trained += 1;
    return partColour(trained - 1);
  });
}

export function partNames({ parts, of, most, disabled, refused, ...change }: PartNames): TemplateResult {
  const colours = partColours(parts.map(({ size }) => size));
  const words = lab().learn.parts;
  const row = ({ name, size }: PartNames["parts"][number], place: number) => html`
    <div class="row wrap" style=${partStyle(colours[place] ?? "")}>
      <i class="swatch"></i>
      <input type="text" maxlength="24" aria-label=${words.name(place + 1)} .value=${name} ?disabled=${disabled}
        @change=${(event: Event) => {
          const input = event.target as HTMLInputElement;
          // Lit does not draw an unchanged name again.
          input.value = change.rename(place, input.value);
        }} />
      <button class="round" aria-label=${words.remove(name)} title=${words.heir[of]} ?disabled=${disabled || parts.length < 2}
        @click=${() => change.remove(place)}>${icon("close")}</button>
      ${size === 0 ? html`<small>${words.empty[of]}</small>` : nothing}
    </div>`;
  return html`
    <div class="part-names stack">
      ${parts.map(row)}
      <small class="limit" role="status">${refused}</small>
      <button class="small" data-testid="add-part" ?disabled=${disabled || parts.length >= most} @click=${() => change.add()}>${words.add}</button>
    </div>`;
}

export interface Member {
  name: string;
  /** The index of its part. */
  part: number;
  /** More properties of its style. */
  more?: Record<string, number>;
  title?: string;
  move(to: number): void;
}

/** A joint or a column in the colour of its part, with a choice of parts. */
export const memberRow = (
  { parts, disabled }: Pick<PartNames, "disabled"> & { parts: readonly Named[] },
  colours: readonly string[],
  { name, part, more, title, move }: Member,
): TemplateResult => html`
  <li class="row tight" style=${partStyle(colours[part] ?? "", more)}>
    <i class="swatch"></i><span class="ellipsis" title=${title ?? nothing}>${name}</span>
    <select aria-label=${lab().learn.parts.member(name)} ?disabled=${disabled}
      @change=${(event: Event) => move(Number((event.target as HTMLSelectElement).value))}>
      ${parts.map((to, i) => html`<option value=${i} .selected=${i === part}>${to.name}</option>`)}
    </select>
  </li>`;
