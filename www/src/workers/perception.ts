// What a worker does for the graphics Turing test: reads studies, draws trials, and analyses answers. No DOM.
import { analysePerception, perceptionJson, Study, StudyMaker } from "vcgpdm";
import type {
  PerceptionWorker,
  StudyChange,
  StudyInfo,
  StudyPreset,
  StudyView,
} from "../engine/whole-protocol";
import { readClip } from "./clips";
import { transfer } from "./transfer";
import { using } from "./using";

/** What a study has that is made here. */
const [SECONDS, DESIGN, LOOK, SEED] = [3.5, "class", "figure", 0] as const;

const PRESETS: readonly StudyPreset[] = ["class", "p3-part-1", "p3-part-2", "p2"];

const trialsOf = (study: Study) => study.trials(0).length;

function view(study: Study): StudyView {
  const { info } = study;
  const times = ({ crossSeconds, seconds, design }: StudyInfo) => ({ crossSeconds, seconds, design });
  const now = JSON.stringify(times(info));
  const plan = (preset: StudyPreset) =>
    using(study.withDesign(preset), (planned) => {
      const its = times(planned.info);
      return { preset, trials: trialsOf(planned), ...its, chosen: JSON.stringify(its) === now };
    });
  return { text: study.toJson(), info, trials: trialsOf(study), plans: PRESETS.map(plan) };
}

/** The study after these changes, one after the other. */
function changed(study: Study, { preset, look, texts, failed }: StudyChange): StudyView {
  if (preset) return using(study.withDesign(preset), (next) => changed(next, { look, texts, failed }));
  if (look) return using(study.withLook(look), (next) => changed(next, { texts, failed }));
  if (texts) return using(study.withTexts(texts), (next) => changed(next, { failed }));
  if (failed) return using(study.withFailed(failed), view);
  return view(study);
}

export const perceptionWorker: PerceptionWorker = {
  openStudy: (text) => using(Study.fromJson(text), view),
  changeStudy: (text, change) => using(Study.fromJson(text), (study) => changed(study, change)),
  drawTrials: (text, seed) => using(Study.fromJson(text), (study) => study.trials(seed)),
  movements: (text) =>
    using(Study.fromJson(text), (study) => {
      const movements = study.info.stimuli.map((_, stimulus) => study.positions(stimulus));
      return transfer(movements, ...movements);
    }),
  analysePerception: (text, answers) => analysePerception(text, answers),
  perceptionJson: (text, answers) => perceptionJson(text, answers),
  async makeStudy({ title, body, framesPerSecond, natural, generated }) {
    const maker = using(
      await readClip(body.source),
      (clip) => new StudyMaker(clip, SECONDS, framesPerSecond),
    );
    return using(maker, () => {
      for (const { positions, ...movement } of natural) maker.addNatural(movement, positions, true);
      for (const { positions, candidate, seed, outcome, ...movement } of generated)
        maker.addGenerated(movement, positions, candidate, seed, outcome);
      return using(maker.study(title, DESIGN, LOOK, SEED), (study) => study.toJson());
    });
  },
};
