// A picture of a part of the page: a copy of its elements and styles that the browser draws.
import { lab } from "../words/lab";

const SIDES = ["top", "right", "bottom", "left"];

/** The copied properties. Sizes follow from the content, which the browser lays out again. */
const PROPERTIES = [
  "display",
  "box-sizing",
  "flex-direction",
  "flex-wrap",
  "flex-grow",
  "flex-shrink",
  "flex-basis",
  "align-items",
  "justify-content",
  "justify-items",
  "align-self",
  "justify-self",
  "row-gap",
  "column-gap",
  "grid-template-columns",
  "grid-column-start",
  "grid-column-end",
  ...SIDES.flatMap((side) => [`margin-${side}`, `padding-${side}`]),
  "min-width",
  "max-width",
  "border-collapse",
  "border-spacing",
  ...SIDES.flatMap((side) => ["width", "style", "color"].map((what) => `border-${side}-${what}`)),
  ...["top-left", "top-right", "bottom-left", "bottom-right"].map((corner) => `border-${corner}-radius`),
  "background-color",
  "color",
  "opacity",
  "visibility",
  "font-family",
  "font-size",
  "font-style",
  "font-weight",
  "font-variant-numeric",
  "line-height",
  "letter-spacing",
  "text-align",
  "vertical-align",
  "white-space",
  "overflow-wrap",
  "list-style-type",
  "fill",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "stroke-linecap",
  "stroke-linejoin",
  "paint-order",
  "text-anchor",
];

/** The largest canvas of browsers, pixels. */
const LARGEST = 16_384;

/** A copy of the visible elements that needs no stylesheet. */
function styled(element: Element): Element | null {
  const style = getComputedStyle(element);
  if (style.display === "none" || element.hasAttribute("data-not-in-picture")) return null;
  const copy = element.cloneNode(false) as HTMLElement | SVGElement;
  copy.removeAttribute("class");
  copy.removeAttribute("id");
  // The content security policy forbids a style attribute.
  copy.style.cssText = PROPERTIES.map((name) => `${name}:${style.getPropertyValue(name)}`).join(";");
  // A drawing was made for its size.
  if (element instanceof SVGSVGElement) {
    const { width, height } = element.getBoundingClientRect();
    copy.style.width = `${width}px`;
    copy.style.height = `${height}px`;
  }
  for (const child of element.childNodes) {
    const made =
      child instanceof Element ? styled(child) : child.nodeType === Node.TEXT_NODE ? child.cloneNode() : null;
    if (made) copy.append(made);
  }
  return copy;
}

/** The width at which the element does not scroll. */
function wholeWidth(element: HTMLElement): number {
  const scrolls = (part: Element) => /auto|scroll/.test(getComputedStyle(part).overflowX);
  const beyond = [...element.querySelectorAll("div")]
    .filter(scrolls)
    .map(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
  return Math.ceil(element.getBoundingClientRect().width + Math.max(0, ...beyond));
}

/** The first opaque colour behind an element. */
function ground(element: Element | null): string {
  for (let at = element; at; at = at.parentElement) {
    const colour = getComputedStyle(at).backgroundColor;
    if (colour !== "transparent" && !/(,|\/)\s*0\)$/.test(colour)) return colour;
  }
  return "white";
}

/** The height of the copy at a width. */
function heightAt(copy: HTMLElement, width: number): number {
  const box = document.createElement("div");
  box.style.cssText = `position:fixed;left:0;top:0;width:${width}px;visibility:hidden;pointer-events:none`;
  box.inert = true;
  box.append(copy);
  document.body.append(box);
  const height = Math.ceil(copy.getBoundingClientRect().height);
  box.remove();
  return height;
}

/**
 * The element as a PNG with a margin, with `scale` pixels for each pixel of the page. Errors are sentences.
 */
export async function pictureOf(element: HTMLElement, scale = 2, margin = 20): Promise<Blob> {
  const width = wholeWidth(element);
  const copy = styled(element) as HTMLElement | null;
  if (!copy || width === 0) throw new Error(lab().files.figures.notOnPage);
  copy.style.margin = "0";
  const height = heightAt(copy, width);
  const [fullWidth, fullHeight] = [width + 2 * margin, height + 2 * margin];
  const [across, down] = [Math.round(scale * fullWidth), Math.round(scale * fullHeight)];
  if (Math.max(across, down) > LARGEST) {
    throw new Error(lab().files.figures.tooLarge(across, down, LARGEST));
  }
  const html = new XMLSerializer().serializeToString(copy);
  const drawing = `<svg xmlns="http://www.w3.org/2000/svg" width="${across}" height="${down}" viewBox="0 0 ${fullWidth} ${fullHeight}">
    <foreignObject x="${margin}" y="${margin}" width="${width}" height="${height}">${html}</foreignObject></svg>`;
  const image = new Image();
  // A canvas that has drawn a blob with foreign content cannot be read; a data URL is allowed.
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(drawing)}`;
  await image.decode().catch(() => {
    throw new Error(lab().files.figures.notDrawn);
  });
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [across, down];
  const context = canvas.getContext("2d");
  if (!context) throw new Error(lab().files.figures.notDrawn);
  context.fillStyle = ground(element);
  context.fillRect(0, 0, across, down);
  context.drawImage(image, 0, 0, across, down);
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error(lab().files.figures.notDrawn))),
      "image/png",
    );
  });
}
