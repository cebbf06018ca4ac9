// What a worker of the whole program answers: it reads clips, trains, compares, does the synthetic experiment, holds a library of
// primitives, finds the uncertainty of a rollout, knows the graphics Turing test, and models time series that
// are no body. No DOM.
import {
  Model,
  type Rollout,
  SyntheticExperiment,
  Trainer,
  analysePerception,
  perceptionJson,
  Study,
  StudyMaker,
} from "vcgpdm";
import type {
  WholeWorker,
  AnyModelWorker,
  ByHand,
  Drag,
  ExperimentWorker,
  Handles,
  PerceptionWorker,
  StudyChange,
  StudyInfo,
  StudyPreset,
  StudyView,
} from "../engine/whole-protocol";
import { clipsWorker, clipSet, readClip } from "./clips";
import { comparisonWorker } from "./evaluation";
import { libraryWorker } from "./library";
import { seriesWorker } from "./series";
import { uncertaintyWorker } from "./uncertainty";
import { transfer, using } from "./using";
import { follow } from "./follow";
import type {
  Couplings,
  Health,
  Report,
  TrainedModel,
  Trainee,
  TrainingJob,
  TrainingOutcome,
} from "../engine/protocol";

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

const perceptionWorker: PerceptionWorker = {
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

/** The newest training, which can continue. */
let kept: { trainer: Trainer; job: TrainingJob } | null = null;

function healthOf(model: Model, frames: number): Health | null {
  try {
    return using(model.rollout({ frames, sequence: 0 }), (rollout) => rollout.health());
  } catch {
    // A rollout with numbers that are not finite has no poses.
    return null;
  }
}

/** The best model so far. Its error takes longest, and decides only after the end. */
function bestSoFar(trainer: Trainer, { settings, frames }: TrainingJob, isEnd: boolean): TrainedModel {
  return using(trainer.model(), (model) => {
    const error = isEnd ? (trainer.rolloutError() ?? null) : null;
    const latents = settings.parts.map((_, part) => trainer.latents(part));
    return { text: model.toJson(), latents, health: healthOf(model, frames), error };
  });
}

function carryOut(
  report: Report<TrainedModel>,
  signal: AbortSignal,
  start?: number,
): Promise<TrainingOutcome> {
  if (!kept) throw new Error("There is no training to go on with.");
  const { trainer, job } = kept;
  const training = {
    step: () => trainer.step(),
    notices: () => trainer.notices(),
    find: (isEnd: boolean) => bestSoFar(trainer, job, isEnd),
  };
  return follow(training, report, signal, start);
}

const trainee: Omit<Trainee, "start"> = {
  async train(job, report, signal) {
    const start = performance.now();
    kept?.trainer.free();
    kept = null;
    const trainer = using(await clipSet(job.clips), (set) => new Trainer(set, job.settings));
    trainer.extend(job.more);
    kept = { trainer, job };
    return carryOut(report, signal, start);
  },
  async goOn(iterations, report, signal) {
    kept?.trainer.extend(iterations);
    return carryOut(report, signal);
  },
};

const experimentWorker: ExperimentWorker = {
  drawExperiment: ({ seed, driving, points }) =>
    using(new SyntheticExperiment(seed, driving, points), (experiment) => experiment.truth()),
  trainExperiment: ({ seed, driving, points }, report, signal) =>
    using(new SyntheticExperiment(seed, driving, points), (experiment) => {
      const find = (isEnd: boolean) => ({
        ...experiment.findings(),
        text: isEnd ? using(experiment.model(), (model) => model.toJson()) : "",
      });
      return follow({ step: () => experiment.step(), find }, report, signal);
    }),
};

/** The handles with a drag. `by`: its displacement of all columns, under these handles. */
function dragged(
  handles: Handles,
  { frame, changes }: Drag,
  by: (handles: Handles) => Float64Array,
): Handles {
  const { push: _, ...others } = handles;
  if (changes === "pose") return { ...handles, push: { frame, by: [...by(others)] } };
  const goal = Array.from(
    by(handles),
    (displacement, column) => displacement + (handles.goal?.[column] ?? 0),
  );
  return { ...handles, goal };
}

/** Of its document. */
type MapCgpdm = { model: { alpha: Couplings } };

const anyModelWorker: AnyModelWorker = {
  rollOutAny: (text, frames, before = {}, drag) =>
    using(Model.fromJson(text), (model) => {
      const roll = <T>({ alpha, ...handles }: ByHand, use: (rollout: Rollout) => T) =>
        using(model.rollout({ frames, sequence: 0, alpha, handles }), use);
      const handles = drag
        ? dragged(before, drag, (under) =>
            roll(under, (rollout) => rollout.dragged(drag.frame, drag.node, ...drag.place)),
          )
        : before;
      const { kind, figure, joints, parts, frameTime } = model.info();
      const isAsLearned = kind === "map-cgpdm" && !before.alpha;
      const alpha = isAsLearned ? (JSON.parse(text) as MapCgpdm).model.alpha : [];
      if (!figure || !joints) throw new Error("expected a model of a body, found a model of tables");
      return roll(handles, (rollout) => {
        const positions = rollout.positions();
        const motion = { positions, frames: rollout.frames, nodes: figure.nodes.length, frameTime };
        return transfer(
          { kind, figure, joints, parts, motion, bvh: rollout.toBvh({ plainNames: true }), handles, alpha },
          positions,
        );
      });
    }),
};

export const wholeCalls: Omit<WholeWorker, "start"> = {
  ...clipsWorker,
  ...anyModelWorker,
  ...trainee,
  ...comparisonWorker,
  ...experimentWorker,
  ...libraryWorker,
  ...uncertaintyWorker,
  ...perceptionWorker,
  ...seriesWorker,
};
