// What a first visit may cost, and what may be loaded after it when models are compared, in gzipped bytes. The build, and the
// page's test in a browser, hold these.
export const budget = {
  firstVisit: 500_000,
  wasm: 275_000,
  onDemand: 430_000,
};
