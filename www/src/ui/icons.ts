// The few icons of the page, drawn on a 16 x 16 grid.
import { svg, type SVGTemplateResult } from "lit";

const SHAPES = {
  play: svg`<path d="M4.5 2.6v10.8a.6.6 0 0 0 .92.5l8.3-5.4a.6.6 0 0 0 0-1l-8.3-5.4a.6.6 0 0 0-.92.5z" fill="currentColor"/>`,
  pause: svg`<rect x="3.5" y="2.5" width="3.2" height="11" rx="1" fill="currentColor"/><rect x="9.3" y="2.5" width="3.2" height="11" rx="1" fill="currentColor"/>`,
  back: svg`<path d="M10.5 3.5L6 8l4.5 4.5M3.6 3.5v9"/>`,
  forward: svg`<path d="M5.5 3.5L10 8l-4.5 4.5M12.4 3.5v9"/>`,
  dice: svg`<rect x="2.5" y="2.5" width="11" height="11" rx="2.5"/><circle cx="5.7" cy="5.7" r=".9" fill="currentColor" stroke="none"/><circle cx="8" cy="8" r=".9" fill="currentColor" stroke="none"/><circle cx="10.3" cy="10.3" r=".9" fill="currentColor" stroke="none"/>`,
  close: svg`<path d="M4 4l8 8M12 4l-8 8"/>`,
  cut: svg`<circle cx="4.2" cy="4.4" r="1.9"/><circle cx="4.2" cy="11.6" r="1.9"/><path d="M5.8 5.5L13.5 11M5.8 10.5L13.5 5"/>`,
  eye: svg`<path d="M1.6 8S4 3.7 8 3.7 14.4 8 14.4 8 12 12.3 8 12.3 1.6 8 1.6 8z"/><circle cx="8" cy="8" r="1.9"/>`,
  save: svg`<path d="M8 2.2v8M4.8 7.2L8 10.4l3.2-3.2M2.8 13.4h10.4"/>`,
  open: svg`<path d="M8 10.4v-8M4.8 5.4L8 2.2l3.2 3.2M2.8 13.4h10.4"/>`,
  reset: svg`<path d="M3.2 8a4.8 4.8 0 1 0 1.5-3.5M3 2.4v2.8h2.8"/>`,
  help: svg`<path d="M5.7 5.9A2.3 2.3 0 0 1 8 3.8c1.3 0 2.4.9 2.4 2.1 0 1.7-2.3 1.9-2.3 3.6M8.05 12.3v.1"/>`,
};

export function icon(name: keyof typeof SHAPES): SVGTemplateResult {
  return svg`<svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" fill="none" stroke="currentColor" stroke-width="1.5" stroke-linecap="round" stroke-linejoin="round">${SHAPES[name]}</svg>`;
}
