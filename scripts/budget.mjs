// What a first visit may cost, in gzipped bytes. The build, and the page's test in a browser, hold these.
export const budget = {
  firstVisit: 500_000,
  wasm: 250_000,
};
