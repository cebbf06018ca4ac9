// Parts by hand: the joints as a tree, each with the part it belongs to. A change takes the whole branch along.
import { html } from "lit";
import { partsChanged } from "./clips";
import { changeSettings } from "../settings/change";
import { partColour } from "../ui/palette";
import { completeSplit, moveBranch, partOfJoints } from "./parts";
import { MAX_PARTS } from "../settings/settings";
import { icon } from "../ui/icons";
import { swatchStyle, View } from "../ui/view";

export class PartsEditor extends View {
  static override topics = ["settings", "clips", "training"] as const;

  private change(split: { name: string; joints: number[] }[]): void {
    changeSettings(this.app, { split });
    partsChanged(this.app);
  }

  private rename(index: number) {
    return (event: Event) => {
      const name = (event.target as HTMLInputElement).value.trim();
      if (name) this.change(this.app.settings.split.map((part, i) => (i === index ? { ...part, name } : part)));
      this.requestUpdate();
    };
  }

  private removePart(index: number): void {
    const { split } = this.app.settings;
    const heir = index === 0 ? 1 : 0;
    const joints = [...split[heir]!.joints, ...split[index]!.joints].sort((a, b) => a - b);
    this.change(split.map((part, i) => (i === heir ? { ...part, joints } : part)).filter((_, i) => i !== index));
  }

  protected override render() {
    const clip = this.app.tickedClips()[0];
    if (!clip) return html``;
    const { joints } = clip.loaded.info;
    const { busy } = this.app;
    const { split } = this.app.settings;
    const whole = completeSplit(joints, split);
    const part = partOfJoints(joints.length, whole);
    const depth: number[] = [];
    joints.forEach(({ parent }, joint) => (depth[joint] = parent === null ? 0 : depth[parent]! + 1));
    // Parts without joints are kept while editing, but are not in `whole`: find each joint's part by name and place.
    const index = (joint: number) => split.findIndex(({ name }) => name === whole[part[joint]!]?.name);
    return html`
      <div class="parts-editor">
        <div class="part-names">
          ${split.map(
            ({ name }, i) => html`
            <div style=${swatchStyle(partColour(i))}>
              <i class="swatch"></i>
              <input type="text" maxlength="24" aria-label="Name of part ${i + 1}" .value=${name} ?disabled=${busy} @change=${this.rename(i)} />
              <button class="round" aria-label="Remove part ${name}" ?disabled=${busy || split.length < 2} @click=${() => this.removePart(i)}>${icon("close")}</button>
            </div>`,
          )}
          <button class="small" ?disabled=${busy || split.length >= MAX_PARTS}
            @click=${() => this.change([...split, { name: freeName(split), joints: [] }])}>Add a part</button>
        </div>
        <p class="hint">Choose a joint’s part; the joints below it go along.</p>
        <ul class="joint-tree" tabindex="0" aria-label="Joints and their parts">
          ${joints.map(
            ({ name }, joint) => html`
            <li style="${swatchStyle(partColour(Math.max(0, index(joint))))};--depth:${Math.min(depth[joint]!, 12)}">
              <i class="swatch"></i><span>${name}</span>
              <select aria-label="Part of ${name}" ?disabled=${busy}
                @change=${(event: Event) => {
                  const to = Number((event.target as HTMLSelectElement).value);
                  this.change(moveBranch(joints, fill(split, whole), joint, to));
                }}>
                ${split.map((one, i) => html`<option value=${i} ?selected=${i === index(joint)}>${one.name}</option>`)}
              </select>
            </li>`,
          )}
        </ul>
      </div>`;
  }
}
customElements.define("pg-parts-editor", PartsEditor);

function freeName(split: { name: string }[]): string {
  for (let i = split.length + 1; ; i++) {
    if (!split.some(({ name }) => name === `part ${i}`)) return `part ${i}`;
  }
}

/** The split with the joints that `whole` gives each of its parts; parts without joints stay. */
function fill(split: { name: string; joints: number[] }[], whole: { name: string; joints: number[] }[]) {
  return split.map(({ name }) => ({ name, joints: whole.find((part) => part.name === name)?.joints ?? [] }));
}
