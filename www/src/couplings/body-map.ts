// A small map of the body: a node for each part, an arrow for each coupling, as thick as its weight.
import { html, svg } from "lit";
import { resetCoupling, setCoupling } from "./rollouts";
import { short, weight } from "../ui/format";
import { HERE, poseAt } from "../scene/motion";
import { partColour } from "../ui/palette";
import { partOfJoints } from "../scene/part-of-joints";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import { bowPath, drawApart, HEIGHT, loopPath, NODE, type Spot, WIDTH } from "./body-layout";
import { View } from "../ui/view";

/** Pixels of drag for a factor of ten in alpha. */
const DECADE = 50;

export class BodyMap extends View {
  static override topics = ["model", "rollout", "settings", "training"] as const;
  private drag: { source: number; target: number; y: number; alpha: number } | null = null;
  private bodyOf: unknown = null;
  private body: { spots: Spot[]; bones: { a: Spot; b: Spot; part: number }[] } = { spots: [], bones: [] };

  override willUpdate(): void {
    const { model, learned } = this.app;
    if (!model || !learned || this.bodyOf === model.info.sequences[0]?.sha256 + JSON.stringify(model.info.parts))
      return;
    this.bodyOf = model.info.sequences[0]?.sha256 + JSON.stringify(model.info.parts);
    this.body = this.layOut();
  }

  /** The first pose from the front, and the parts' middles drawn apart. */
  private layOut(): { spots: Spot[]; bones: { a: Spot; b: Spot; part: number }[] } {
    const { info } = this.app.model!;
    const { motion } = this.app.learned!;
    const pose = poseAt(motion, 0, HERE, new Float32Array(motion.nodes * 3));
    const later = poseAt(motion, Math.min(motion.frames - 1, 45), HERE, new Float32Array(motion.nodes * 3));
    const heading = Math.atan2(later[0]! - pose[0]!, later[2]! - pose[2]!);
    const height = Math.max(...pose.filter((_, i) => i % 3 === 1), 0.1);
    const scale = (HEIGHT - 30) / height;
    const flat: Spot[] = info.figure.nodes.map((_, node) => {
      const [x, z] = [pose[3 * node]! - pose[0]!, pose[3 * node + 2]! - pose[2]!];
      const sideways = x * Math.cos(heading) - z * Math.sin(heading);
      return { x: WIDTH / 2 - scale * sideways, y: HEIGHT - 14 - scale * pose[3 * node + 1]! };
    });
    const part = partOfJoints(info.joints.length, info.parts);
    const bones = info.figure.nodes.flatMap(({ parent }, node) =>
      parent === null ? [] : [{ a: flat[parent]!, b: flat[node]!, part: part[info.figure.nodes[parent]!.joint] ?? 0 }],
    );
    const spots = info.parts.map((_, index) => {
      const own = info.figure.nodes.flatMap(({ joint }, node) => (part[joint] === index ? [flat[node]!] : []));
      const n = Math.max(1, own.length);
      return {
        x: own.reduce((sum, { x }) => sum + x, 0) / n,
        y: own.reduce((sum, { y }) => sum + y, 0) / n,
      };
    });
    return { spots: drawApart(spots), bones };
  }

  private grab(source: number, target: number) {
    return (event: PointerEvent) => {
      event.preventDefault();
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      this.drag = { source, target, y: event.clientY, alpha: this.app.couplings()[source]![target]! };
    };
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) return;
    const alpha = drag.alpha * 10 ** ((event.clientY - drag.y) / DECADE);
    setCoupling(this.app, drag.source, drag.target, Math.min(ALPHA_MAX, Math.max(ALPHA_MIN, alpha)));
  }

  private arrow(source: number, target: number) {
    const { model, rollout } = this.app;
    const w = rollout?.weights[source]?.[target] ?? 0;
    const [a, b] = [this.body.spots[source], this.body.spots[target]];
    if (!a || !b) return svg``;
    const width = 1 + 6.5 * w;
    const path = source === target ? loopPath(a) : bowPath(a, b);
    const name = (part: number) => model!.info.parts[part]?.name ?? "";
    const alpha = this.app.couplings()[source]![target]!;
    const colour = partColour(source);
    const head = `head-${source}-${target}`;
    return svg`
      <g class="arrow" style="--part:${colour}" @pointerdown=${this.grab(source, target)} @pointermove=${this.move}
        @pointerup=${() => (this.drag = null)} @pointercancel=${() => (this.drag = null)}
        @dblclick=${() => resetCoupling(this.app, source, target)}>
        <title>${name(source)} to ${name(target)}: weight ${weight(w)}, alpha ${short(alpha)}. Drag up for stronger, down for weaker.</title>
        <marker id=${head} viewBox="0 0 10 10" refX="5" refY="5" markerUnits="userSpaceOnUse"
          markerWidth=${(6 + 1.25 * width).toFixed(1)} markerHeight=${(6 + 1.25 * width).toFixed(1)} orient="auto"><path d="M0 0.4L9 5L0 9.6z" fill=${colour} /></marker>
        <path class="grip" d=${path} />
        <path class="line" d=${path} stroke-width=${width.toFixed(2)} opacity=${(0.3 + 0.7 * Math.sqrt(w)).toFixed(2)} marker-end="url(#${head})" />
      </g>`;
  }

  protected override render() {
    const { model } = this.app;
    const { spots, bones } = this.body;
    const parts = model?.info.parts ?? [];
    return html`
      <svg class="body-map" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" data-testid="body-map"
        aria-label="Body map: an arrow for each coupling, as thick as its weight. The sliders in the table change the same couplings.">
        ${bones.map(({ a, b, part }) => svg`<line class="map-bone" style="--part:${partColour(part)}" x1=${a.x} y1=${a.y} x2=${b.x} y2=${b.y} />`)}
        ${parts.flatMap((_, source) => parts.map((__, target) => this.arrow(source, target)))}
        ${parts.map(({ name }, part) =>
          spots[part]
            ? svg`
          <g style="--part:${partColour(part)}">
            <circle class="map-node" cx=${spots[part].x} cy=${spots[part].y} r=${NODE} />
            <title>${name}</title>
          </g>`
            : "",
        )}
      </svg>`;
  }
}
customElements.define("pg-body-map", BodyMap);
