// A drawing in the address of the page, so that a link sends it: each place of the pen is two letters an axis.
import type { SettingsStore } from "../settings/settings-store";
import type { DrawingStore, Pad } from "./drawing-store";
import { type Drawing, drawingOf, HEIGHT, ROWS_A_SECOND, WIDTH } from "./hand";

const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
/** Values of a coordinate. */
const VALUES = LETTERS.length ** 2;

/** More rows than a hand can draw in the time that it has, with the way back to its beginning. */
const MOST_ROWS = 800;

/** The numbers of the pads, and the letters of the rows; of a shape that is repeated, of one lap. Empty: too long. */
export function textOf({ rows: all, rate, lap, once }: Drawing, pads: readonly Pad[]): string {
  const rows = once ? all.slice(0, lap) : all;
  if (rows.length > MOST_ROWS) return "";
  const letters = (value: number, axis: number) => {
    const whole = Math.round((value / (axis % 2 === 0 ? WIDTH : HEIGHT)) * (VALUES - 1));
    const within = Math.min(VALUES - 1, Math.max(0, whole));
    return `${LETTERS[Math.floor(within / LETTERS.length)]}${LETTERS[within % LETTERS.length]}`;
  };
  const slow = rate < ROWS_A_SECOND ? `-${Math.round(ROWS_A_SECOND / rate)}` : "";
  return `${pads.join("")}${slow}.${rows.map((row) => row.map(letters).join("")).join("")}`;
}

/** The drawing of a link and its pads; null: there is none in it. */
export function drawingIn(text: string): { drawing: Drawing; pads: readonly Pad[] } | null {
  const [, numbers = "", slow = "1", letters = ""] = /^(0|1|01)(?:-(\d))?\.([\w-]+)$/.exec(text) ?? [];
  const pads = [...numbers].map((number): Pad => (number === "0" ? 0 : 1));
  const width = 4 * pads.length;
  if (width === 0 || letters.length % width !== 0 || letters.length > MOST_ROWS * width) return null;
  const value = (at: number, most: number) => {
    const [high, low] = [LETTERS.indexOf(letters[at] ?? ""), LETTERS.indexOf(letters[at + 1] ?? "")];
    return ((high * LETTERS.length + low) / (VALUES - 1)) * most;
  };
  const strokes = pads.map((_, place) => [
    Array.from({ length: letters.length / width }, (_, row) => {
      const at = row * width + 4 * place;
      return { seconds: (row * Number(slow)) / ROWS_A_SECOND, x: value(at, WIDTH), y: value(at + 2, HEIGHT) };
    }),
  ]);
  const drawing = drawingOf(strokes);
  return drawing && { drawing, pads };
}

/** Keeps the drawing in the address, and learns that of a link. */
export function keepInAddress(store: DrawingStore, settings: SettingsStore): void {
  /** Whether the drawing on show, or that which is learned, is of a link. */
  let isLinked = false;
  /** What the address says of the drawing on show, or of that which is learned, with the line of its sender. */
  let [said, line] = ["", ""];
  let [shown, comes] = [store.drawn, false];
  const restore = () => settings.change({ drawing: said, says: line });
  const follow = () => {
    const { drawing, says } = settings.values;
    if (drawing === said) {
      line = says;
      return;
    }
    // A way to the view that names no drawing loses none.
    if (drawing === "") return restore();
    const found = drawingIn(drawing);
    if (!found) {
      store.refuse();
      return restore();
    }
    [said, line, comes, isLinked] = [drawing, says, true, true];
    void store.learn(found.drawing, found.pads);
  };
  store.on(() => {
    const { drawn } = store;
    if (drawn === shown) return;
    shown = drawn;
    const isSent = comes && drawn !== null;
    comes = false;
    // The link that brought a drawing stays as it was sent.
    if (isSent) return;
    [said, line] = [drawn ? textOf(drawn.drawing, drawn.pads) : "", ""];
    restore();
    // A dare belongs to the drawing of its link, an exercise to each.
    if (isLinked) settings.change({ exercise: 0 });
    isLinked = false;
  });
  settings.on(follow);
  follow();
}
