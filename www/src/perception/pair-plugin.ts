// jsPsych's plugin for a trial: a cross, two movements on one clock, and the question on which side the more
// natural one was.
import { type JsPsych, type JsPsychPlugin, ParameterType, type TrialType } from "jspsych";
import type { StudyTrial } from "../engine/whole-protocol";
import { PairClock } from "./pair-clock";
import type { PairStage } from "./pair-stage";
import { type Side, SIDES, trialView } from "./trial-view";

const info = {
  name: "vcgpdm-pair",
  version: "1.0.0",
  parameters: {
    /** The movements, their sides and their heading. */
    pair: { type: ParameterType.OBJECT, default: undefined },
    question: { type: ParameterType.STRING, default: undefined },
    /** Seconds. */
    cross: { type: ParameterType.FLOAT, default: 0.75 },
    /** Seconds. */
    movement: { type: ParameterType.FLOAT, default: 3.5 },
    /** Whether an answer is possible during the movements; it then ends the trial. */
    answer_during_movement: { type: ParameterType.BOOL, default: false },
  },
  data: {
    /** "left" or "right". */
    response: { type: ParameterType.STRING },
    /** Milliseconds from the beginning of the movements to the answer. */
    rt: { type: ParameterType.FLOAT },
    /** Milliseconds between the first pictures of both movements. */
    started_apart_ms: { type: ParameterType.FLOAT },
    /** Milliseconds from the first picture to the first without them. */
    lasted_ms: { type: ParameterType.FLOAT },
    /** The length of a display frame in milliseconds, measured during the cross. */
    frame_ms: { type: ParameterType.FLOAT },
    /** Display frames that the machine was too slow to draw. */
    frames_dropped: { type: ParameterType.INT },
  },
  citations: {},
} as const;

type Info = typeof info;
type Pair = TrialType<Info>;

interface Answer {
  response: Side;
  rt: number;
}

/** The simulated participant waits for these milliseconds before it answers. */
const SIMULATED_WAIT = 200;

const tenth = (value: number | null) => (value === null ? null : Math.round(10 * value) / 10);

/** When a side was first drawn, by the browser's own performance marks. */
function marked(side: number): number {
  const name = `vcgpdm ${SIDES[side]} movement`;
  const { startTime } = performance.mark(name);
  performance.clearMarks(name);
  return startTime;
}

/** The plugin that draws on this stage. */
export function pairPlugin(stage: PairStage) {
  return class PairPlugin implements JsPsychPlugin<Info> {
    static readonly info = info;
    readonly #jsPsych: JsPsych;

    constructor(jsPsych: JsPsych) {
      this.#jsPsych = jsPsych;
    }

    trial(display: HTMLElement, pair: Pair, loaded?: () => void) {
      return this.#run(display, pair, loaded, () => {});
    }

    simulate(
      pair: Pair,
      mode: "visual" | "data-only",
      options: { data?: Partial<Answer> },
      loaded?: () => void,
    ) {
      const { pluginAPI } = this.#jsPsych;
      const { movement = 3.5 } = pair;
      const chance: Side = Math.random() < 0.5 ? "left" : "right";
      const given = { response: chance, rt: 1000 * movement + SIMULATED_WAIT };
      const answer = pluginAPI.mergeSimulationData(given, options) as Answer;
      if (mode === "data-only") {
        loaded?.();
        const untimed = { started_apart_ms: null, lasted_ms: null, frame_ms: null, frames_dropped: null };
        return Promise.resolve({ ...answer, ...untimed });
      }
      const key = answer.response === "left" ? "ArrowLeft" : "ArrowRight";
      return this.#run(this.#jsPsych.getDisplayElement(), pair, loaded, () =>
        pluginAPI.pressKey(key, SIMULATED_WAIT),
      );
    }

    /** Calls `asked` when answers become possible. */
    #run(display: HTMLElement, pair: Pair, loaded: (() => void) | undefined, asked: () => void) {
      const { cross = 0.75, movement = 3.5, question = "", answer_during_movement: early = false } = pair;
      const clock = new PairClock({ crossSeconds: cross, seconds: movement });
      const view = trialView(display, stage.element, question);
      stage.take(pair.pair as StudyTrial);
      loaded?.();
      return new Promise<object>((end) => {
        let answer: Answer | null = null;
        let begun = 0;
        const take = () => {
          const answered = (response: Side) => {
            answer ??= { response, rt: Math.round(performance.now() - begun) };
          };
          view.answered(answered);
          this.#jsPsych.pluginAPI.getKeyboardResponse({
            callback_function: ({ key }: { key: string }) =>
              answered(key.toLowerCase() === "arrowleft" ? "left" : "right"),
            valid_responses: ["ArrowLeft", "ArrowRight"],
            rt_method: "performance",
            persist: false,
            allow_held_key: false,
          });
          asked();
        };
        const finish = () => {
          const { startedApart, lasted, frame, dropped } = clock.shown;
          end({
            ...answer,
            started_apart_ms: startedApart === null ? null : Math.round(1000 * startedApart) / 1000,
            lasted_ms: tenth(lasted),
            frame_ms: tenth(frame),
            frames_dropped: dropped,
          });
        };
        let taking = false;
        const tick = (now: number) => {
          // The trial ended when its display left the page.
          if (!view.root.isConnected) return;
          if (answer !== null) clock.stop(now);
          const { phase, seconds, hold } = clock.at(now);
          if (phase === "movement" && seconds === 0) begun = now;
          if (phase === "movement" && !hold)
            stage.draw(seconds, (side) => seconds === 0 && clock.drawn(side, marked(side)));
          view.show(phase === "over" ? "question" : phase);
          if (!taking && (phase === "over" || (early && phase === "movement"))) {
            taking = true;
            take();
          }
          if (answer !== null) finish();
          else requestAnimationFrame(tick);
        };
        requestAnimationFrame(tick);
      });
    }
  };
}
