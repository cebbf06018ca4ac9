/** The dialog with help, keys and facts about the page. */
export const words = {
  title: "How this works",
  close: "Close",
  model:
    "The model splits a body into parts. Each part’s poses are points in a small latent space, and a walk is a loop in it. Where a part goes next is predicted by every part, from its own last frames; the weights w say whose word counts. A coupling’s α is the variance of one such prediction: small α, large weight.",
  points:
    "Inducing points are the few examples that the model keeps in place of the data: poses (diamonds), and short pieces of movement (arrows). Point at one to see its pose, and the frames it speaks for on the time line.",
  training:
    "Training climbs the evidence lower bound, or a sum like it with weighted poses: how well the model explains the clips, less its cost.",
  method: "The method: equations, symbols, references",
  keysTitle: "Keys",
  keys: [
    ["space", "play or pause"],
    ["← →", "one frame back or forward"],
    ["0", "reset all couplings"],
    ["delete", "on a slider: reset it"],
    ["c", "held: cut a coupling, that of the slider in focus or the strongest between parts, and watch live"],
    ["f j", "while two fingers are the feet: a step of the left foot, of the right foot"],
    ["p", "for a projector: only the picture, in large type; escape brings the rest back"],
    ["w a s d", "on the stage: look from another side"],
    ["+ −", "on the stage: nearer, farther"],
    ["q", "the link to this state, with its QR code"],
    ["?", "this help"],
  ] as [key: string, does: string][],
  about: "About",
  licences: "Licences",
  local: "Nothing you load leaves your machine: everything is computed in this browser.",
  samples:
    "The sample clips are made by a program of this project. The model that walks at the start was trained on recordings of CMU subject 7.",
  provenance: (engine: string, seed: number, clips: string, version: string) =>
    `The model now: trained by ${engine} with seed ${seed} on ${clips || "clips it does not name"}. This page runs version ${version}.`,
};

export type HelpWords = typeof words;
