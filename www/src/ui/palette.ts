// One colour a part, everywhere: the Okabe-Ito colours, which colour-blind people can tell apart,
// shifted in lightness (never in hue) for the dark page.

interface Shades {
  light: string;
  dark: string;
}

const BLUE: Shades = { light: "#0072b2", dark: "#3ea3e6" };
const PARTS: Shades[] = [
  BLUE,
  { light: "#e08a00", dark: "#f0a52a" }, // orange
  { light: "#009e73", dark: "#1fbf92" }, // bluish green
  { light: "#c0609a", dark: "#d98bb8" }, // reddish purple
  { light: "#d55e00", dark: "#ec7a2c" }, // vermillion
  { light: "#3f9fd6", dark: "#7cc5f0" }, // sky blue
  { light: "#a89a00", dark: "#e3d64a" }, // yellow
  { light: "#6b6b6b", dark: "#a5a5a5" }, // grey, for an eighth part
];

export interface Theme {
  dark: boolean;
  ground: string;
  ink: string;
  quiet: string;
  faint: string;
  line: string;
  ghost: string;
}

const LIGHT: Theme = {
  dark: false,
  ground: "#f3f2ef",
  ink: "#1d2329",
  quiet: "#5c6670",
  faint: "#8b949c",
  line: "#dcdad5",
  ghost: "#8d9399",
};
const DARK: Theme = {
  dark: true,
  ground: "#13161a",
  ink: "#e9ebed",
  quiet: "#a3abb3",
  faint: "#7a838b",
  line: "#31373d",
  ghost: "#8b939a",
};

const darkQuery = () =>
  typeof matchMedia === "function" ? matchMedia("(prefers-color-scheme: dark)") : null;
const darkScheme = darkQuery();
/** Never read: Chromium sends no event from a list whose `matches` was read since the colours changed. */
const schemeChanges = darkQuery();

/** The colours of a dark or light picture. Without `dark`, those that the system asks for now. */
export function theme(dark = darkScheme?.matches ?? false): Theme {
  return dark ? DARK : LIGHT;
}

const shadesOf = (part: number): Shades => PARTS[part % PARTS.length] ?? BLUE;

/** The colour of a part for styles. It follows the page from light to dark by itself. */
export function partColour(part: number): string {
  const { light, dark } = shadesOf(part);
  return `light-dark(${light}, ${dark})`;
}

/** The present colour, for canvases, WebGL and files. Drawings with it must be redrawn `onThemeChange`. */
export function partColourNow(part: number, { dark: isDark } = theme()): string {
  const { light, dark } = shadesOf(part);
  return isDark ? dark : light;
}

/** Calls back when the page turns dark or light. Returns a function that stops the calls. */
export function onThemeChange(listener: () => void): () => void {
  schemeChanges?.addEventListener("change", listener);
  return () => schemeChanges?.removeEventListener("change", listener);
}
