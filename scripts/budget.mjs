// The largest sizes of a visit, in gzipped bytes; the build and a test in a browser check them. A view has its own
// in its folder (www/src/*/entry.ts). And the largest size of the project: lower it when the project becomes smaller.
export const budget = {
  /** Lines of product and of tests, and files; `npm test` counts them. */
  lines: { product: 109_814, tests: 48_597, files: 1_260 },
  firstVisit: 500_000,
  /** Of it what is not wasm, in `npm test`, whose quick wasm comes with more JavaScript. */
  firstScripts: 258_400,
  /** The wasm of a first visit. */
  wasm: 250_000,
  /** The views of the Lab. */
  lab: 50_800,
  /** The chapters of the story after the first. */
  story: 60_000,
  /** Help, details of the Lab and its recordings that move parts, with their words in two languages. */
  whenAsked: 60_500,
  /**
   * The whole program, with the filter that completes and recognises recordings, ten kinds of models to compare
   * and the samples that do not walk; charts; the writer of GIF files.
   */
  onDemand: 925_000,
  /** The movements of the page's own study. */
  study: 170_000,
  /** The writer of GLB files. */
  glb: 15_000,
  /** `vcgpdm/figure` of the npm package, with three.js. */
  figure: 150_000,
  /** The page for teachers in two languages, with the writer of QR codes and of links with a model. */
  teach: 30_000,
};
