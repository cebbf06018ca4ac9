/** The view Time series. */
export const words = {
  setup: "Tables and training",
  tables: "Tables",
  open: "Open",
  openMeaning: "Open tables (.csv) or a model of tables (.json)",
  /** Around the name of the column. */
  drop: [
    "Drop CSV files anywhere, one a trial: names in the first row, then a row of numbers a moment. A column",
    "holds seconds. They stay on this machine, and only as long as this page is open.",
  ],
  train: "Train",
  training: "Training",
  trained: "Trained",
  hint: "Learns how the columns of each part go on, and how much each part’s past tells about the others.",
  openFirst: "Open a table, or tick one.",
  clash: "The ticked tables do not go together.",
  fields: {
    latent: { label: "Latent dimensions", hint: "The dimensions of each part’s latent space" },
    dynamicsIps: { label: "Dynamics points", hint: "Inducing points of each coupling’s dynamics" },
    poseIps: {
      label: "Observation points",
      hint: "Inducing points of the map from each part’s latents to its columns",
    },
    order: { label: "Rows of history", hint: "The order of the dynamics" },
    maxIterations: { label: "Iterations at most", hint: "The optimiser stops here at the latest" },
    seed: { label: "Seed", hint: "The seed of everything random" },
    framesPerSecond: {
      label: "Rows a second",
      hint: "How fast rows follow each other: the tables have no column of times",
    },
  },
  begin: {
    title: "Curves that are no body",
    text: "Forces, joint torques, muscle activity, prices, two machines: whatever you measured several of at once. Columns are put into parts; each part gets a latent space, and the couplings say which part’s past helps to predict which. A model of tables is one file, like all others.",
    example: "Open an example",
    machines: "Two made-up machines, by a formula; the second follows the first a little later.",
  },
  leaveOut: {
    label: "Leave out",
    hint: "Names of columns, with commas between them. * at the beginning or end stands for any letters",
  },
  parts: "Parts",
  columns: "Columns and their parts",
  size: (rows: number, columns: number, seconds: string | null) =>
    `${rows} rows of ${columns}${seconds === null ? "" : `, ${seconds}`}`,
  row: "Row",
  rowOf: (row: number, rows: number) => `Row ${row} of ${rows}`,
  of: (rows: number) => `of ${rows}`,
  curves: "Curves",
  startAs: "Start as",
  saveCurves: "Curves, CSV",
  saveCurvesMeaning: "A row a frame, a column for each curve",
  saveModel: "Model, JSON",
  saveModelMeaning: "Opens here and in the terminal",
  recorded:
    "In colour: the model on its own, from the first rows of the table on, or what it infers from the columns that are given. Dashed: what was recorded.",
  notRecorded:
    "The model on its own. Its file does not hold what was recorded: open the tables to see them dashed.",
  provenance: (engine: string, iterations: number, seed: number) =>
    `Trained by ${engine}, ${iterations} iterations, seed ${seed}.`,
  noCouplings: "Of a model of this kind only the curves are shown, no couplings and no latent spaces.",
  overTime: "Columns over time",
  figure: "The columns NAME.x, NAME.y and NAME.z as points, joined by bones",
  time: "time (s)",
  curve: (name: string, recorded: boolean) =>
    `${name} against time, rolled out${recorded ? " and recorded" : ""}`,
  /** Who moves a column. */
  givers: {
    who: (name: string) => `Who gives ${name}`,
    model: "the model",
    recording: "the recording",
    hand: "you, by hand",
    draw: (name: string) =>
      `${name} by hand: drag to draw its curve, or bend the curve at the time shown with the arrow keys.`,
  },
  unsaved: "the model of tables that was trained here",
  noModel: "There is no model yet: train one or open one.",
};

export type SeriesWords = typeof words;
