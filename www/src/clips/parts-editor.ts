// The editor of parts: the joints as a tree, each with its part. A change applies to the whole branch.
import { html } from "lit";
import type { PartSpec } from "../engine/protocol";
import { partOfJoints } from "../scene/joints";
import { MAX_PARTS } from "../engine/limits";
import { partName } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { freeName, memberRow, partColours, partNames, renamed, nameProblem } from "./part-names";
import { View } from "../ui/view";
import type { ClipsStore } from "./clips-store";
import { filledSplit, moveBranch } from "./parts";
import "./parts-editor.css";
import { lab } from "../words/lab";

export class PartsEditor extends View {
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  /** Why the last name was refused; empty after the next change. */
  #refused = "";

  /** The split of the settings, or the parts in its place when it is invalid. */
  get #split(): PartSpec[] {
    const { split } = this.settings.values;
    return split.length > 0 ? split : this.clips.parts;
  }

  #change(split: PartSpec[]): void {
    this.#refused = "";
    this.clips.setParts({ split });
  }

  #rename(place: number, text: string): string {
    const split = this.#split;
    const name = partName(text);
    const why = nameProblem(split, place, name);
    if (!why) this.#change(renamed(split, place, name));
    this.#refused = why;
    this.requestUpdate();
    return this.#split[place]?.name ?? "";
  }

  #removePart(index: number): void {
    const split = this.#split;
    const heir = index === 0 ? 1 : 0;
    const orphans = split[index]?.joints ?? [];
    const inherit = (part: PartSpec, i: number) =>
      i === heir ? { ...part, joints: [...part.joints, ...orphans] } : part;
    this.#change(split.map(inherit).filter((_, i) => i !== index));
  }

  protected override render() {
    const [clip] = this.clips.ticked;
    if (!clip) return html``;
    const { joints } = clip.loaded.info;
    const { locked } = this.clips;
    const split = filledSplit(joints, this.#split);
    const part = partOfJoints(joints.length, split);
    const colours = partColours(split.map(({ joints: own }) => own.length));
    const depth: number[] = [];
    for (const { parent } of joints) depth.push(parent === null ? 0 : (depth[parent] ?? 0) + 1);
    const joint = ({ name }: { name: string }, place: number) =>
      memberRow({ parts: split, disabled: locked }, colours, {
        name,
        part: part[place] ?? 0,
        more: { "--depth": Math.min(depth[place] ?? 0, 12) },
        move: (to) => this.#change(moveBranch(joints, split, place, to)),
      });
    return html`
      <div class="parts-editor stack">
        ${partNames({
          parts: split.map(({ name, joints }) => ({ name, size: joints.length })),
          of: "joints",
          most: MAX_PARTS,
          disabled: locked,
          refused: this.#refused,
          rename: (place, text) => this.#rename(place, text),
          remove: (place) => this.#removePart(place),
          add: () => this.#change([...this.#split, { name: freeName(this.#split), joints: [] }]),
        })}
        <p class="hint">${lab().learn.parts.choose}</p>
        <ul class="joint-tree note" tabindex="0" aria-label=${lab().learn.parts.joints}>${joints.map(joint)}</ul>
      </div>`;
  }
}
customElements.define("pg-parts-editor", PartsEditor);
