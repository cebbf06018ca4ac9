//! One trial held out, and each of its parts inferred from the others.

use crate::completing::answer::{Answer, constant_share, finite, share};
use crate::completing::results::{
    ColumnCoverage, CompletedPart, CompletedTrial, Limits, Method, MethodScore,
};
use crate::completing::rivals::{HISTORY, Regressions, answer};
use crate::completing::training_trial::training_trial;
use crate::evaluation::{EvaluationError, ObservedFold};
use nalgebra::DMatrix;
use std::ops::Range;
use vcgpdm::models::variational::{Filter, LatentMoments};
use vcgpdm::models::{Body, Coupled, Model, Progress, RolloutRequest, Settings, VariationalSettings};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::PartSpec;
use vcgpdm::motion::pose::ColumnKind;

/// Seconds in which the filter searches its place in the movement.
const SEARCHED: f64 = 0.5;
/// Frames from one gap to the next, and missing frames in each.
const GAPS: (usize, usize) = (20, 8);
/// Frames after the given parts are cut off: at 30 frames a second the first quarter of a second, the first
/// half, and the second half.
pub const AFTER_CUT: [Range<usize>; 3] = [0..8, 0..15, 15..30];
/// A column never changes in training if it is nowhere larger.
const CHANGES: f64 = 1e-9;
/// Trials with which one half of the training trials can be predicted from the other.
const LEAST_TRIALS: usize = 3;

/// Which frames of the given parts are observed.
#[derive(Clone, Copy)]
enum Sense {
    All,
    Gaps,
    CutAt(usize),
}

impl Sense {
    /// The columns with NaN in every frame that is not observed. Each method sees its first history.
    fn observed(self, given: &DMatrix<f64>) -> DMatrix<f64> {
        let mut given = given.clone();
        for t in HISTORY.min(given.nrows())..given.nrows() {
            let missing = match self {
                Sense::All => false,
                Sense::Gaps => t % GAPS.0 >= GAPS.0 - GAPS.1,
                Sense::CutAt(frame) => t >= frame,
            };
            if missing {
                given.row_mut(t).fill(f64::NAN);
            }
        }
        given
    }
}

/// One trial held out.
pub struct CompletingFold {
    fold: ObservedFold,
    held_out: usize,
}

impl CompletingFold {
    /// The trial `held_out`, counted from 0, against all others.
    ///
    /// # Errors
    /// There are fewer than three trials or two parts, or the trials cannot be trained on together at this
    /// frame rate.
    pub fn new(
        trials: &[Clip],
        held_out: usize,
        parts: &[PartSpec],
        frames_per_second: f64,
    ) -> Result<Self, EvaluationError> {
        if trials.len() < LEAST_TRIALS {
            return Err(EvaluationError::FewTrials { least: LEAST_TRIALS, found: trials.len() });
        }
        let fold = ObservedFold::new(trials, held_out, trials.len() - 1, parts, frames_per_second)?;
        Ok(Self { fold, held_out })
    }

    /// Trains both variational models on the other trials, and completes the trial by every method. `watch`
    /// gets the share that is done; if it returns false, there are no results.
    ///
    /// # Errors
    /// A model cannot be trained, or a part cannot be inferred.
    pub fn evaluate(
        &self,
        settings: &VariationalSettings,
        seed: u32,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Option<CompletedTrial>, EvaluationError> {
        let mut first = |progress: &Progress| watch(0.5 * progress.fraction);
        let Some(model) = self.fold.train(&Settings::Vcgpdm(settings.clone()), seed, &mut first)? else {
            return Ok(None);
        };
        let mut second = |progress: &Progress| watch(0.5 + 0.5 * progress.fraction);
        let Some(whole) = self.fold.train(&Settings::Vgpdm(settings.clone()), seed, &mut second)? else {
            return Ok(None);
        };
        self.complete(&model, &whole).map(Some)
    }

    /// Completes the trial by models of the other trials: one of the parts, and one of the whole body.
    fn complete(&self, model: &Model, whole: &Model) -> Result<CompletedTrial, EvaluationError> {
        let trial = self.trial(model, whole)?;
        let parts = (0..trial.held_out.len()).map(|part| trial.completed(part));
        Ok(CompletedTrial { held_out: self.held_out, parts: parts.collect::<Result<_, _>>()? })
    }

    fn trial<'a>(&self, model: &'a Model, whole: &'a Model) -> Result<Trial<'a>, EvaluationError> {
        let (Some(parts), Some(one_part)) = (model.coupled(), whole.coupled()) else {
            return Err(EvaluationError::NoFilter { model: model.kind().id() });
        };
        let mut begin = 0;
        let training = self.fold.movements().sequences.iter().map(|sequence| {
            begin += sequence.frames;
            let rows = |y: &DMatrix<f64>| y.rows(begin - sequence.frames, sequence.frames).into_owned();
            self.fold.movements().y.iter().map(rows).collect()
        });
        Ok(Trial {
            parts,
            whole: one_part,
            training: training.collect(),
            held_out: self.fold.body().centred(self.fold.actual()),
        })
    }
}

/// A trial held out, with the models of the others.
struct Trial<'a> {
    parts: Coupled<'a>,
    /// The model of the whole body, which has one part.
    whole: Coupled<'a>,
    /// Centred columns of each part: `training[trial][part]`.
    training: Vec<Vec<DMatrix<f64>>>,
    held_out: Vec<DMatrix<f64>>,
}

impl Trial<'_> {
    fn body(&self) -> &Body {
        self.parts.body
    }

    /// The columns of a part that change in training.
    fn changing(&self, part: usize) -> Vec<usize> {
        let changes = |&c: &usize| self.training.iter().any(|y| y[part].column(c).amax() > CHANGES);
        (0..self.held_out[part].ncols()).filter(changes).collect()
    }

    /// The columns of all parts but one, side by side.
    fn given(parts: &[DMatrix<f64>], other: usize) -> DMatrix<f64> {
        let given: Vec<&DMatrix<f64>> =
            parts.iter().enumerate().filter(|(part, _)| *part != other).map(|(_, y)| y).collect();
        let mut joined = DMatrix::zeros(parts[other].nrows(), given.iter().map(|y| y.ncols()).sum());
        let mut at = 0;
        for y in given {
            joined.columns_mut(at, y.ncols()).copy_from(y);
            at += y.ncols();
        }
        joined
    }

    fn searched(&self) -> usize {
        (SEARCHED / self.body().frame_time).round() as usize
    }

    /// The observed columns as those of the only part of the whole body.
    fn side_by_side(&self, observed: &[DMatrix<f64>]) -> DMatrix<f64> {
        let whole = self.whole.body.layout.columns(0);
        let mut joined = DMatrix::from_element(observed[0].nrows(), whole.len(), f64::NAN);
        for (part, y) in observed.iter().enumerate() {
            for (place, column) in self.places_in_whole(part).into_iter().zip(y.column_iter()) {
                joined.set_column(place, &column);
            }
        }
        joined
    }

    /// The places of the columns of a part among those of the whole body.
    fn places_in_whole(&self, part: usize) -> Vec<usize> {
        let whole = self.whole.body.layout.columns(0);
        let place = |column: &usize| whole.iter().position(|other| other == column);
        self.body().layout.columns(part).iter().filter_map(place).collect()
    }

    /// What the methods infer about a part, in the order of [`Method::ALL`].
    fn answers(
        &self,
        other: usize,
        sense: Sense,
        regressions: &Regressions,
    ) -> Result<Vec<Answer>, EvaluationError> {
        let (recorded, changing) = (&self.held_out[other], self.changing(other));
        let observed = self.observed(other, sense);
        let filter = self.parts.filter(&RolloutRequest::default())?;
        let run = filter.run_from_best(&observed, self.searched())?;
        let likeliest = filter.smoothed(&filter.run_likeliest(&observed, self.searched())?)?;
        let mut answers = Vec::new();
        for latents in [filter.filtered(&run), filter.smoothed(&run)?, likeliest] {
            answers.push(self.of_latents(&filter, &latents, other)?);
        }

        let filter = self.whole.filter(&RolloutRequest::default())?;
        let run = filter.run_from_best(&[self.side_by_side(&observed)], self.searched())?;
        let places = self.places_in_whole(other);
        let latents = filter.filtered(&run);
        answers.push(Answer::of_latents(&filter, &latents, 0, &places, recorded, &changing)?);

        for prediction in regressions.predict(&Self::given(&observed, other))? {
            answers.push(answer(prediction, recorded, &changing));
        }
        Ok(answers)
    }

    /// The columns of all parts, of which one is missing and the others are observed.
    fn observed(&self, other: usize, sense: Sense) -> Vec<DMatrix<f64>> {
        let mut observed: Vec<DMatrix<f64>> = self.held_out.iter().map(|y| sense.observed(y)).collect();
        observed[other].fill(f64::NAN);
        observed
    }

    /// What the smoother of a vCGPDM infers about a part.
    fn smoother(
        &self,
        parts: Coupled,
        other: usize,
        observed: &[DMatrix<f64>],
    ) -> Result<Answer, EvaluationError> {
        let filter = parts.filter(&RolloutRequest::default())?;
        let latents = filter.smoothed(&filter.run_from_best(observed, self.searched())?)?;
        self.of_latents(&filter, &latents, other)
    }

    /// The columns of a part under latents of the vCGPDM.
    fn of_latents(
        &self,
        filter: &Filter,
        latents: &LatentMoments,
        part: usize,
    ) -> Result<Answer, EvaluationError> {
        let (recorded, changing) = (&self.held_out[part], self.changing(part));
        let columns: Vec<usize> = (0..recorded.ncols()).collect();
        Ok(Answer::of_latents(filter, latents, part, &columns, recorded, &changing)?)
    }

    fn regressions(&self, other: usize) -> Result<Regressions, EvaluationError> {
        let trials = self.training.iter().map(|y| (Self::given(y, other), y[other].clone()));
        Ok(Regressions::new(&trials.collect::<Vec<_>>())?)
    }

    /// A part inferred from the others by every method.
    fn completed(&self, part: usize) -> Result<CompletedPart, EvaluationError> {
        let (recorded, changing) = (&self.held_out[part], self.changing(part));
        let last = recorded.nrows();
        let (frames, cut) = (HISTORY.min(last) - 1..last, last / 2);
        let regressions = self.regressions(part)?;
        let seen = self.answers(part, Sense::All, &regressions)?;
        let gaps = self.answers(part, Sense::Gaps, &regressions)?;
        let after = self.answers(part, Sense::CutAt(cut), &regressions)?;
        let error = |answer: &Answer, frames: &Range<usize>| {
            finite("the error of a part", share(&answer.mean, recorded, frames))
        };
        let score = |(k, method): (usize, &Method)| -> Result<MethodScore, EvaluationError> {
            let answer = &seen[k];
            let after_cut = AFTER_CUT.iter().map(|range| {
                let frames = (cut + range.start).min(last)..(cut + range.end).min(last);
                (!frames.is_empty()).then(|| error(&after[k], &frames)).transpose()
            });
            Ok(MethodScore {
                method: *method,
                error: error(answer, &frames)?,
                joints: finite("the error of the joints", self.joints(part, &answer.mean, &frames)?)?,
                coverage: finite("the coverage", answer.coverage(recorded, &changing, &frames))?,
                log_density: finite("the log density", answer.log_density(&frames))?,
                gaps: error(&gaps[k], &frames)?,
                after_cut: after_cut.collect::<Result<_, _>>()?,
            })
        };
        let scores = Method::ALL.iter().enumerate().map(score).collect::<Result<_, _>>()?;
        Ok(CompletedPart { scores, limits: self.limits(part, &seen, &frames)? })
    }

    fn limits(&self, part: usize, seen: &[Answer], frames: &Range<usize>) -> Result<Limits, EvaluationError> {
        let (recorded, changing) = (&self.held_out[part], self.changing(part));
        let all = &self.smoother(self.parts, part, &self.held_out)?;
        let mut of_beta = self.parts.model.clone();
        of_beta.parts = of_beta.parts.into_iter().map(|map| map.with_column_noise(Vec::new())).collect();
        let of_beta = Coupled { model: &of_beta, ..self.parts };
        let of_beta = &self.smoother(of_beta, part, &self.observed(part, Sense::All))?;
        let [filter, smoother, _, _, ridge, ..] = seen else {
            return Err(EvaluationError::NoFilter { model: "vcgpdm" });
        };
        let offset =
            |answer: &Answer| finite("an offset", constant_share(&(&answer.mean - recorded), frames));
        let squares =
            |answer: &Answer| finite("squared error : variance", answer.squares(recorded, &changing, frames));
        let columns = changing.iter().map(|&c| ColumnCoverage {
            column: self.column_name(part, c),
            coverage: smoother.coverage_of(recorded, c, frames),
        });
        Ok(Limits {
            all_observed: finite("the error of a part", share(&all.mean, recorded, frames))?,
            all_observed_coverage: finite("the coverage", all.coverage(recorded, &changing, frames))?,
            all_observed_squares: squares(all)?,
            filter_squares: squares(filter)?,
            smoother_squares: squares(smoother)?,
            beta_coverage: finite("the coverage", of_beta.coverage(recorded, &changing, frames))?,
            beta_log_density: finite("the log density", of_beta.log_density(frames))?,
            posture: finite("an offset", constant_share(recorded, frames))?,
            offset: offset(filter)?,
            ridge_offset: offset(ridge)?,
            columns: columns.collect(),
            training: training_trial(self.parts, &self.training[0], part, self.searched())?,
        })
    }

    /// Joint and kind of a column of a part.
    fn column_name(&self, part: usize, place: usize) -> String {
        let mapping = &self.body().mapping;
        let columns = mapping.columns();
        let Some(column) = columns.get(self.body().layout.columns(part)[place]) else { return String::new() };
        let joint = mapping.skeleton().joints.get(column.joint).map_or("", |joint| joint.name.as_str());
        format!("{joint} {}", column.kind.name())
    }

    /// The error of joint positions relative to the hips, as a share of that of the mean pose. Root and given
    /// parts are as recorded.
    fn joints(
        &self,
        part: usize,
        mean: &DMatrix<f64>,
        frames: &Range<usize>,
    ) -> Result<f64, EvaluationError> {
        let body = self.body();
        let positions = |y: DMatrix<f64>| {
            let mut parts = self.held_out.clone();
            parts[part] = y;
            let (mut all, recorded) = (body.columns(&parts), body.columns(&self.held_out));
            for (c, column) in body.mapping.columns().iter().enumerate() {
                match column.kind {
                    ColumnKind::YawRate
                    | ColumnKind::Forward
                    | ColumnKind::Sideways
                    | ColumnKind::HeightRate => {
                        all.column_mut(c).fill(0.0);
                    }
                    ColumnKind::Height | ColumnKind::Pitch | ColumnKind::Roll => {
                        all.set_column(c, &recorded.column(c));
                    }
                    ColumnKind::Rotation(_) => {}
                }
            }
            body.positions(&all)
        };
        let recorded = positions(self.held_out[part].clone())?;
        let width = recorded.len() / mean.nrows();
        let error = |found: &[f32]| -> f64 {
            let numbers = frames.start * width..frames.end * width;
            let pairs = found[numbers.clone()].iter().zip(&recorded[numbers]);
            pairs.map(|(a, b)| f64::from(a - b).powi(2)).sum()
        };
        Ok(error(&positions(mean.clone())?) / error(&positions(mean * 0.0)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm::motion::{parts, samples};

    fn trials() -> Vec<Clip> {
        ["walk-1", "walk-2", "walk-3"].map(|id| samples::clip(id).unwrap()).into()
    }

    fn fold(trials: &[Clip]) -> CompletingFold {
        let presets = parts::presets(&trials[0].skeleton);
        let parts = presets.into_iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
        CompletingFold::new(trials, 1, &parts, 20.0).unwrap()
    }

    fn settings() -> VariationalSettings {
        VariationalSettings {
            latent: 2,
            dynamics_ips: 8,
            pose_ips: 8,
            max_iterations: 60,
            ..VariationalSettings::default()
        }
    }

    /// No method sees the part that it infers: when the recorded part is another one, all infer the same.
    #[test]
    fn infers_the_same_whatever_the_inferred_part_does() {
        let fold = fold(&trials());
        let train = |settings| fold.fold.train(&settings, 0, &mut |_| true).unwrap().unwrap();
        let (model, whole) = (train(Settings::Vcgpdm(settings())), train(Settings::Vgpdm(settings())));
        let mut trial = fold.trial(&model, &whole).unwrap();
        let regressions = trial.regressions(1).unwrap();
        let all_observed = |trial: &Trial| trial.smoother(trial.parts, 1, &trial.held_out).unwrap().mean;
        for sense in [Sense::All, Sense::CutAt(20)] {
            let (before, seen) = (trial.answers(1, sense, &regressions).unwrap(), all_observed(&trial));
            let upper = trial.held_out[1].clone();
            trial.held_out[1] *= -2.0;
            let (after, seen_after) = (trial.answers(1, sense, &regressions).unwrap(), all_observed(&trial));
            trial.held_out[1] = upper;
            for (k, (before, after)) in before.iter().zip(&after).enumerate() {
                assert_eq!(before.mean, after.mean, "{:?}", Method::ALL[k]);
                assert_eq!(before.variance, after.variance, "{:?}", Method::ALL[k]);
            }
            assert_ne!(seen, seen_after);
        }
    }

    /// Arms of a walk follow from its legs, better still when they are observed, and the same seed gives the
    /// same numbers.
    #[test]
    fn completes_a_walk_by_every_method() {
        let fold = fold(&trials());
        let evaluate = || fold.evaluate(&settings(), 0, &mut |_| true).unwrap().unwrap();
        let found = evaluate();
        assert_eq!((found.held_out, found.parts.len()), (1, 2));
        for CompletedPart { scores, limits } in &found.parts {
            assert_eq!(scores.iter().map(|score| score.method).collect::<Vec<_>>(), Method::ALL);
            for score in scores {
                assert!(score.error > 0.0 && score.error < 1.0, "{score:?}");
                assert!(score.joints > 0.0 && score.joints < 1.0, "{score:?}");
                assert!((0.3..=1.0).contains(&score.coverage), "{score:?}");
                assert!(score.after_cut.iter().all(Option::is_some), "{score:?}");
            }
            assert!(limits.all_observed < scores[0].error, "{limits:?}");
            assert!((0.0..=1.0).contains(&limits.posture) && (0.0..=1.0).contains(&limits.offset));
            assert!(limits.columns.iter().any(|column| !column.column.is_empty()));
            let training = limits.training;
            assert!(training.all_observed < training.completed, "{training:?}");
            assert!(training.one_frame > 0.0 && training.given_latents > 0.0, "{training:?}");
        }
        assert_eq!(found, evaluate());
        assert_eq!(fold.evaluate(&settings(), 0, &mut |_| false).unwrap(), None);
    }

    #[test]
    fn refuses_two_trials() {
        let trials = trials();
        let found = CompletingFold::new(&trials[..2], 0, &[], 20.0).err().map(|error| error.to_string());
        assert_eq!(found.as_deref(), Some("expected 3 trials or more, found 2"));
    }
}
