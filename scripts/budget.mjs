// What a first visit may cost, and what may be loaded after it: what a visitor of the first view may ask for, and what compares
// models, and besides that the graphics Turing test with jsPsych and its study; in gzipped bytes. The build, and the page's test in a browser, hold these.
export const budget = {
  firstVisit: 450_000,
  wasm: 210_000,
  whenAsked: 70_000,
  onDemand: 530_000,
  perception: 250_000,
};
