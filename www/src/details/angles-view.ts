// One channel of the motion on the stage: over time, against its speed, or against another channel.
import { html, nothing, svg } from "lit";
import { axes, path, labelsWidth } from "../figures/chart";
import { linearScale } from "../figures/scale";
import type { Playback } from "../stage/playback";
import { download } from "../ui/download";
import { View } from "../ui/view";
import { type Channel, courseOf, plottedCsv, type Recorded, speedOf } from "./channels";
import { numbers } from "../words/sections";

/** A motion of the body on the stage. */
export interface PlottedMotion {
  name: string;
  motion: Recorded;
}

type Axes = ReturnType<typeof numbers>["angles"]["axes"];

/** The heads in a file do not depend on the language of the page. */
const FILE_AXES: Axes = {
  time: "time (s)",
  speed: (channel, unit) => `speed of ${channel} (${unit}/s)`,
  fileUnits: "file units",
};

const HEIGHT = 260;
const TYPE = 12;

export class AnglesView extends View {
  static override properties = {
    motions: { attribute: false },
    channels: { attribute: false },
    chosen: { state: true },
    across: { state: true },
    width: { state: true },
  };
  declare playback: Playback;
  /** The motion on the stage is the first. */
  declare motions: readonly PlottedMotion[];
  declare channels: readonly Channel[];
  /** The column of the channel. */
  declare chosen: number;
  /** The horizontal axis: time, the channel's speed, or the column of another channel. */
  across: "time" | "speed" | number = "time";
  width = 320;
  /** The first motion in each frame, in pixels. */
  #places: [number, number][] = [];

  protected override stores() {
    return [];
  }

  protected override arrived(): void {
    this.whenLeaving(this.playback.on(() => this.#markNow()));
    const box = this.querySelector(".details-chart");
    const measure = () => {
      this.width = box?.clientWidth || this.width;
    };
    if (box) this.watchSize(box, measure);
    measure();
  }

  override willUpdate(): void {
    if (this.chosen === undefined)
      this.chosen = (this.channels.find(isKnee) ?? this.channels.at(-1))?.column ?? 0;
  }

  override updated(): void {
    this.#markNow();
  }

  #markNow(): void {
    const now = this.querySelector(".now");
    const place = this.#places[Math.min(Math.round(this.playback.frame), this.#places.length - 1)];
    if (!now || !place) return;
    now.setAttribute("cx", String(place[0]));
    now.setAttribute("cy", String(place[1]));
  }

  /** The horizontal and the vertical value in each frame of a motion. */
  #courses({ motion }: PlottedMotion): { x: number[] | null; y: number[] } {
    const [channel, other] = [this.channels[this.chosen], this.channels[Number(this.across)]];
    const y = channel ? courseOf(motion, channel) : [];
    if (this.across === "time") return { x: null, y };
    // A phase plot has the angle across and the speed upwards.
    if (this.across === "speed") return { x: y, y: speedOf(y, motion.frameTime) };
    return { x: other ? courseOf(motion, other) : [], y };
  }

  #titles(axes: Axes): { x: string; y: string } {
    const unit = ({ isAngle }: Channel) => (isAngle ? "°" : axes.fileUnits);
    const title = (column: number) => {
      const channel = this.channels[column];
      return channel ? `${channel.joint} ${channel.channel} (${unit(channel)})` : "";
    };
    const own = title(this.chosen);
    if (this.across === "time") return { x: axes.time, y: own };
    if (this.across === "speed") {
      const { joint = "", channel = "" } = this.channels[this.chosen] ?? {};
      const [of] = this.channels.filter(({ column }) => column === this.chosen).map(unit);
      return { x: own, y: axes.speed(`${joint} ${channel}`, of ?? "") };
    }
    return { x: title(this.across), y: own };
  }

  #chart() {
    const seconds = (t: number, { motion }: PlottedMotion) => t * motion.frameTime;
    const lines = this.motions.map((plotted) => {
      const { x, y } = this.#courses(plotted);
      return { x: x ?? y.map((_, t) => seconds(t, plotted)), y };
    });
    const [bottom, top] = [HEIGHT - 2.2 * TYPE - 12, 2 * TYPE];
    const up = linearScale(
      lines.flatMap(({ y }) => y),
      bottom,
      top,
    );
    const words = numbers().angles;
    const { x, y } = this.#titles(words.axes);
    const upward = { scale: up, title: y };
    const space = { right: this.width - 8, top, bottom, type: TYPE };
    const plot = { ...space, left: labelsWidth(upward, space) };
    const right = linearScale(
      lines.flatMap(({ x }) => x),
      plot.left,
      plot.right,
    );
    const placed = lines.map(({ x, y }) =>
      y.map((value, t): [number, number] => [right.at(x[t] ?? 0), up.at(value)]),
    );
    this.#places = placed[0] ?? [];
    // The motion on the stage is drawn last, above the others.
    return svg`
      <svg width=${this.width} height=${HEIGHT} viewBox="0 0 ${this.width} ${HEIGHT}" role="img" aria-label=${words.chart(y, x)}>
        ${axes(plot, { scale: right, title: x }, upward)}
        ${placed.map((points, i) => svg`<g class="line-${i}">${path(points)}</g>`).reverse()}
        <circle class="now" r="5"></circle>
      </svg>`;
  }

  #save(): void {
    const motions = this.motions.map((plotted) => ({ name: plotted.name, ...this.#courses(plotted) }));
    const text = plottedCsv(this.motions[0]?.motion.frameTime ?? 0, motions, this.#titles(FILE_AXES));
    const { joint = "", channel = "" } = this.channels[this.chosen] ?? {};
    download(`${joint}-${channel}.csv`, new Blob([text], { type: "text/csv" }));
  }

  #options(selected: unknown) {
    const joints = [...new Set(this.channels.map(({ joint }) => joint))];
    return joints.map(
      (joint) => html`<optgroup label=${joint}>
        ${this.channels.flatMap((channel) =>
          channel.joint === joint
            ? [
                html`<option value=${channel.column} ?selected=${channel.column === selected}>${joint} ${channel.channel}</option>`,
              ]
            : [],
        )}</optgroup>`,
    );
  }

  protected override render() {
    const value = (event: Event) => (event.target as HTMLSelectElement).value;
    const against = (event: Event) => {
      const chosen = value(event);
      this.across = chosen === "time" || chosen === "speed" ? chosen : Number(chosen);
    };
    const words = numbers().angles;
    return html`
      <div class="details-choice row wrap">
        <label>${words.channel} <select data-testid="angle" @change=${(event: Event) => {
          this.chosen = Number(value(event));
        }}>${this.#options(this.chosen)}</select></label>
        <label>${words.against} <select data-testid="across" @change=${against}>
          <option value="time" ?selected=${this.across === "time"}>${words.time}</option>
          <option value="speed" ?selected=${this.across === "speed"}>${words.speed}</option>
          ${this.#options(this.across)}</select></label>
        <button class="small" data-testid="save-angles" @click=${this.#save}>${words.save}</button>
      </div>
      <div class="details-chart" data-testid="angle-chart" data-frames=${this.motions[0]?.motion.rows.length ?? 0}>${this.#chart()}</div>
      ${
        this.motions.length > 1
          ? html`<p class="details-legend">${this.motions.map(({ name }, i) => html`<span class="line-${i}"><i></i>${name}</span>`)}</p>`
          : nothing
      }
      <p class="hint">${words.about(this.motions[0]?.name ?? "")}</p>`;
  }
}
customElements.define("pg-angles", AnglesView);

const isKnee = ({ joint, channel }: Channel) => /leg|knee|shin/i.test(joint) && channel === "Xrotation";
