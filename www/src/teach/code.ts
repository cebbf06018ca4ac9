// QR codes, as the path of an SVG.
import encodeQR from "qr";

/** The quiet zone around a code, in modules. */
const BORDER = 2;

/** The number of modules of a side, and a path of the dark modules, each a unit square. */
export function codeOf(text: string): { side: number; path: string } {
  const rows = encodeQR(text, "raw", { ecc: "medium", border: BORDER });
  const path = rows
    .flatMap((row, y) => row.map((isDark, x) => (isDark ? `M${x} ${y}h1v1h-1z` : "")))
    .join("");
  return { side: rows.length, path };
}

/** The address of a state of this page. */
export const addressOf = (fragment: string): string => `${location.origin}${location.pathname}#${fragment}`;
