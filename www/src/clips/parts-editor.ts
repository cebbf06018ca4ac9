// Parts by hand: the joints as a tree, each with the part it belongs to. A change takes the whole branch along.
import { html } from "lit";
import type { PartSpec } from "../engine/protocol";
import { partOfJoints } from "../scene/part-of-joints";
import { MAX_PARTS } from "../engine/limits";
import type { SettingsStore } from "../settings/settings-store";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import type { ClipsStore } from "./clips-store";
import { completeSplit, moveBranch } from "./parts";
import "./parts-editor.css";
import { partStyle } from "../ui/styled";

export class PartsEditor extends View {
  declare settings: SettingsStore;
  declare clips: ClipsStore;

  protected override stores() {
    return [this.settings, this.clips];
  }

  private change(split: PartSpec[]): void {
    this.clips.setParts({ split });
  }

  private rename(index: number) {
    return (event: Event) => {
      const name = (event.target as HTMLInputElement).value.trim();
      if (name) this.change(this.settings.values.split.map((part, i) => (i === index ? { ...part, name } : part)));
      this.requestUpdate();
    };
  }

  private removePart(index: number): void {
    const { split } = this.settings.values;
    const heir = index === 0 ? 1 : 0;
    const orphans = split[index]?.joints ?? [];
    const inherit = (part: PartSpec, i: number) =>
      i === heir ? { ...part, joints: [...part.joints, ...orphans] } : part;
    this.change(split.map(inherit).filter((_, i) => i !== index));
  }

  protected override render() {
    const [clip] = this.clips.ticked;
    if (!clip) return html``;
    const { joints } = clip.loaded.info;
    const { locked } = this.clips;
    const { split } = this.settings.values;
    const whole = completeSplit(joints, split);
    const part = partOfJoints(joints.length, whole);
    const depth: number[] = [];
    for (const { parent } of joints) depth.push(parent === null ? 0 : (depth[parent] ?? 0) + 1);
    // Parts without joints are kept while editing, but are not in `whole`: find each joint's part by name and place.
    const index = (joint: number) => split.findIndex(({ name }) => name === whole[part[joint] ?? -1]?.name);
    return html`
      <div class="parts-editor">
        <div class="part-names">
          ${split.map(
            ({ name }, i) => html`
            <div style=${partStyle(partColour(i))}>
              <i class="swatch"></i>
              <input type="text" maxlength="24" aria-label="Name of part ${i + 1}" .value=${name} ?disabled=${locked} @change=${this.rename(i)} />
              <button class="round" aria-label="Remove part ${name}" ?disabled=${locked || split.length < 2} @click=${() => this.removePart(i)}>${icon("close")}</button>
            </div>`,
          )}
          <button class="small" ?disabled=${locked || split.length >= MAX_PARTS}
            @click=${() => this.change([...split, { name: freeName(split), joints: [] }])}>Add a part</button>
        </div>
        <p class="hint">Choose a joint’s part; the joints below it go along.</p>
        <ul class="joint-tree" tabindex="0" aria-label="Joints and their parts">
          ${joints.map(
            ({ name }, joint) => html`
            <li style=${partStyle(partColour(Math.max(0, index(joint))), { "--depth": Math.min(depth[joint] ?? 0, 12) })}>
              <i class="swatch"></i><span>${name}</span>
              <select aria-label="Part of ${name}" ?disabled=${locked}
                @change=${(event: Event) => {
                  const to = Number((event.target as HTMLSelectElement).value);
                  this.change(moveBranch(joints, fill(split, whole), joint, to));
                }}>
                ${split.map((to, i) => html`<option value=${i} ?selected=${i === index(joint)}>${to.name}</option>`)}
              </select>
            </li>`,
          )}
        </ul>
      </div>`;
  }
}
customElements.define("pg-parts-editor", PartsEditor);

function freeName(split: readonly PartSpec[]): string {
  for (let i = split.length + 1; ; i++) {
    if (!split.some(({ name }) => name === `part ${i}`)) return `part ${i}`;
  }
}

/** The split with the joints that `whole` gives each of its parts; parts without joints stay. */
function fill(split: readonly PartSpec[], whole: readonly PartSpec[]) {
  return split.map(({ name }) => ({ name, joints: whole.find((part) => part.name === name)?.joints ?? [] }));
}
