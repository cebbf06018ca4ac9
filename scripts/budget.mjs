// What a first visit may cost, and what may be loaded after it: what a visitor of the first view may ask for;
// what compares models; what the graphics Turing test needs besides, with jsPsych; the movements of the study
// that comes with the page; the library of primitives with its view; the view of time series; and what writes
// a motion as GLB. In gzipped bytes. The build, and the page's test in a browser, hold these.
export const budget = {
  firstVisit: 500_000,
  wasm: 250_000,
  whenAsked: 70_000,
  onDemand: 805_000,
  perception: 50_000,
  study: 170_000,
  primitives: 75_000,
  series: 12_000,
  glb: 15_000,
};
