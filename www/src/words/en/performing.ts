// The words of what a visitor does live and records, in English.
import { decimal } from "../../ui/decimal";

export const words = {
  record: (seconds: number) => `Record ${seconds} s`,
  recordMeaning: "Records what the figure does while you move it: it becomes a clip",
  left: (seconds: number) => `Stop, ${seconds} s left`,
  making: "The recording becomes a clip …",
  title: (number: number) => `performed ${number}`,
  live: (model: string) => `live from ${model}`,
  note: (model: string, did: readonly string[]) =>
    `Made by you, live from the model ${model}${did.length > 0 ? `, with ${did.join("; ")}` : ", without a change"}.`,
  did: {
    feet: "two fingers as the feet",
    wheel: (part: string) => `the wheel for ${part}`,
    push: (part: string) => `pushes of ${part}`,
    record: (part: string, title: string) => `a recording of ${part} (${title})`,
    cut: (source: string, target: string) => `${source} → ${target} cut`,
    couplings: "changed couplings",
  },
  notRecorded: "Nothing was recorded",
  tooShort: "A clip needs at least one second of motion.",
  play: (title: string) => `Play ${title}`,
  train: "Train on what I did",
  trainMeaning: "Trains a model on this clip alone, with the settings of the panel Learn",
  sound: "Sound",
  soundMeaning: "A click for each foot that comes down, a tone for each hand that draws",
  notFilmed: "No moving picture was saved",
  film: {
    title: "Moving picture",
    about: "Some seconds of the stage, to show and to send",
    left: (seconds: number) => `Recording, ${seconds} s left`,
  },
  feet: "Two fingers as the feet",
  feetMeaning: "Each press is a step: the legs follow your rhythm, your limp and your pause",
  noLegs: "Needs a motion that repeats itself, and one part with the root and both feet",
  foot: ["Left foot", "Right foot"],
  waits: "One moment: the feet begin after one whole stride.",
  says: {
    step: "Left, right, left: each press is a step. Where you wait, the body waits.",
    same: "One foot twice is no step of this cycle: the other foot steps in between.",
    fast: "Faster than the model knows: it walks at twice the pace that it learned.",
  },
  handles: {
    caption: "A model without couplings: drag the figure, or change its tempo below",
    captionMap: "Its own couplings are below",
    couplings: "Couplings of the MAP CGPDM",
    kept: "One latent path, trained together with these couplings; a vCGPDM learns a distribution of paths. The smaller α, the more that part decides.",
    title: "Handles of the movement primitive",
    curve: "A curve over time: let a dragged limb go, and it is back on its curve at once.",
    system: "A dynamical system: let a dragged limb go, and a spring takes it back.",
    tempo: (times: number) => `Tempo ${decimal("en", times, 2)}`,
    drag: "Drag moves",
    pose: "this pose",
    poseMeaning: "In the first frame a drag moves the start",
    goal: "the goal",
    centre: "the centre",
    lift: "Lift a hand",
    liftMeaning: "As a drag of a hand by 30 cm",
    reset: "As learned",
  },
};

export type PerformingWords = typeof words;
