// QR codes, as the path of an SVG.
import encodeQR from "qr";

/** The quiet zone around a code, in modules. */
const BORDER = 2;

/** Bytes of the longest text in a code of this error correction: ISO 18004, version 40-M. */
export const LONGEST_CODE = 2331;

/** The number of modules of a side, and a path of the dark modules, each a unit square. */
export function codeOf(text: string): { side: number; path: string } {
  const rows = encodeQR(text, "raw", { ecc: "medium", border: BORDER });
  const path = rows
    .flatMap((row, y) => row.map((isDark, x) => (isDark ? `M${x} ${y}h1v1h-1z` : "")))
    .join("");
  return { side: rows.length, path };
}

/** The address of a state of this page. `query`: "?embed" for a frame in another page. */
export const addressOf = (fragment: string, query: "" | "?embed" = ""): string =>
  `${location.origin}${location.pathname}${query}#${fragment}`;

/** A line of HTML that shows an address in a frame. Browsers start no workers without allow-same-origin. */
export function frameLine(address: string, title: string): string {
  const escaped = (text: string) =>
    text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
  const sandbox = "allow-scripts allow-same-origin";
  return `<iframe src="${escaped(address)}" title="${escaped(title)}" width="800" height="500" sandbox="${sandbox}"></iframe>`;
}
