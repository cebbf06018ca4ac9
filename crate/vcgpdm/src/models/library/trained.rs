//! A library with the body that it moves, and how it was made.

use crate::gp::NumericsError;
use crate::models::body::Body;
use crate::models::dataset::{Dataset, SequenceInfo};
use crate::models::library::{CombinationError, CouplingTrainer, LearnedMovement, Library, LibraryTrainer};
use crate::models::provenance::{ENGINE, Provenance};
use crate::models::settings::VariationalSettings;
use crate::models::trained::TrainedModel;
use crate::models::training_error::TrainingError;
use crate::models::variational::Vcgpdm;
use crate::motion::pose::PoseError;
use crate::motion::{BodyMismatch, Clip, ClipError};
use nalgebra::DMatrix;
use thiserror::Error;

/// A trained library of primitives. It holds no training clip.
#[derive(Clone, Debug)]
pub struct TrainedLibrary {
    /// Pose maps, primitives and movements.
    pub library: Library,
    /// What turns columns into poses; its sequences are those of the movements, one movement after the other.
    pub body: Body,
    /// How the library was trained.
    pub provenance: Provenance<VariationalSettings>,
}

/// Why a clip cannot be looked at by a library, or a choice of primitives is not understood.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LibraryError {
    /// The clip's body is another one.
    #[error("{clip} does not have the body of the library: {reason}")]
    Body {
        /// The clip.
        clip: String,
        /// How it differs.
        reason: Box<BodyMismatch>,
    },
    /// The clip cannot be brought to the library's frame rate.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// Its poses cannot be turned into rows.
    #[error("{clip}: {reason}")]
    Pose {
        /// The clip.
        clip: String,
        /// Why.
        reason: Box<PoseError>,
    },
    /// A choice is not of the form part=primitive.
    #[error("expected PART=PRIMITIVE for each part, such as {example}, found {found:?}")]
    Choice {
        /// A choice that this library has.
        example: String,
        /// What was found.
        found: String,
    },
    /// There is no such part or primitive.
    #[error("expected {what} to be one of {known}, found {found:?}")]
    Unknown {
        /// What was named.
        what: &'static str,
        /// What there is.
        known: String,
        /// What was found.
        found: String,
    },
    /// The primitives cannot be combined.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The couplings cannot be learned.
    #[error(transparent)]
    Training(#[from] TrainingError),
}

/// A clip as a library sees it.
#[derive(Clone, Debug)]
pub struct ObservedClip {
    /// Columns of each part, centred by the library's means [T x D_i].
    pub y: Vec<DMatrix<f64>>,
    /// Where they came from.
    pub info: SequenceInfo,
}

impl TrainedLibrary {
    /// The best library of a training so far; `frames_per_second` is the rate that the data set was asked for.
    ///
    /// # Errors
    ///
    /// When a covariance of the library cannot be factorised.
    pub fn trained(
        dataset: &Dataset,
        trainer: &LibraryTrainer,
        frames_per_second: f64,
    ) -> Result<Self, NumericsError> {
        let progress = trainer.progress();
        let provenance = Provenance {
            engine: ENGINE.to_owned(),
            settings: trainer.settings().clone(),
            seed: trainer.seed(),
            frames_per_second,
            objective: progress.best,
            iterations: progress.iteration,
            evaluations: progress.evaluations,
            note: None,
        };
        Ok(Self { library: trainer.library()?, body: Body::new(dataset), provenance })
    }

    /// The model of a movement, as it was learned.
    ///
    /// # Errors
    ///
    /// When there is no such movement, or a covariance cannot be factorised.
    pub fn movement(&self, index: usize) -> Result<TrainedModel<Vcgpdm>, CombinationError> {
        let model = self.library.movement(index)?;
        let sequences = (0..model.starts.len()).map(|s| (index, s)).collect();
        Ok(self.with_sequences(model, sequences))
    }

    /// The model of the primitive `uses[part]` of each part under the couplings `alpha` [M x M].
    ///
    /// # Errors
    ///
    /// As [`Library::combination`].
    pub fn combination(
        &self,
        uses: &[usize],
        alpha: &DMatrix<f64>,
    ) -> Result<TrainedModel<Vcgpdm>, CombinationError> {
        let model = self.library.combination(uses, alpha)?;
        Ok(self.with_sequences(model, self.library.start_sequences(uses)))
    }

    /// Where the sequences come from that a combination can start from.
    pub fn start_infos(&self, uses: &[usize]) -> Vec<SequenceInfo> {
        self.infos(self.library.start_sequences(uses))
    }

    /// Of sequences by movement and place in it.
    fn infos(&self, chosen: Vec<(usize, usize)>) -> Vec<SequenceInfo> {
        let place = |(movement, sequence): (usize, usize)| {
            let before = self.library.movements[..movement].iter().map(|m| m.starts.len());
            before.sum::<usize>() + sequence
        };
        chosen.into_iter().filter_map(|at| self.body.sequences.get(place(at)).cloned()).collect()
    }

    fn with_sequences(&self, model: Vcgpdm, chosen: Vec<(usize, usize)>) -> TrainedModel<Vcgpdm> {
        let body = Body { sequences: self.infos(chosen), ..self.body.clone() };
        TrainedModel { model, body, provenance: self.provenance.clone() }
    }

    /// The primitives that a text such as `lower=walk,upper=wave` names: of each part the primitive of that name, or the one that
    /// the movement of that name uses.
    ///
    /// # Errors
    ///
    /// When it names a part or a primitive that is not there, or not one primitive for each part.
    pub fn uses(&self, text: &str) -> Result<Vec<usize>, LibraryError> {
        let parts: Vec<&str> = self.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
        let shown = |found: &str| found.chars().take(60).collect::<String>();
        let mut uses: Vec<Option<usize>> = vec![None; parts.len()];
        for choice in text.split(',') {
            let wrong = || LibraryError::Choice { example: self.example(&parts), found: shown(choice) };
            let (part, name) = choice.split_once('=').ok_or_else(wrong)?;
            let (part, name) = (part.trim(), name.trim());
            let place = parts.iter().position(|known| *known == part).ok_or_else(|| {
                LibraryError::Unknown { what: "the part", known: parts.join(", "), found: shown(part) }
            })?;
            uses[place] = Some(self.primitive(place, name).ok_or_else(|| LibraryError::Unknown {
                what: "the primitive",
                known: self.names(place),
                found: shown(name),
            })?);
        }
        let whole: Option<Vec<usize>> = uses.into_iter().collect();
        whole.ok_or_else(|| LibraryError::Choice { example: self.example(&parts), found: shown(text) })
    }

    /// The primitive of a part by its name, or by that of a movement that uses it.
    fn primitive(&self, part: usize, name: &str) -> Option<usize> {
        let own = |p: &crate::models::library::Primitive| p.part == part && p.name == name;
        self.library.primitives.iter().position(own).or_else(|| {
            let movement = self.library.movements.iter().find(|movement| movement.name == name)?;
            movement.uses.get(part).copied()
        })
    }

    fn names(&self, part: usize) -> String {
        let own = self.library.primitives.iter().filter(|primitive| primitive.part == part);
        own.map(|primitive| primitive.name.as_str()).collect::<Vec<_>>().join(", ")
    }

    fn example(&self, parts: &[&str]) -> String {
        let first = |part: usize| {
            let own = self.library.primitives.iter().find(|primitive| primitive.part == part);
            own.map_or("NAME", |primitive| primitive.name.as_str())
        };
        let choices = parts.iter().enumerate().map(|(part, name)| format!("{name}={}", first(part)));
        choices.collect::<Vec<_>>().join(",")
    }

    /// A clip at the library's frame rate, as centred columns of its parts.
    ///
    /// # Errors
    ///
    /// When its body is another one, or it cannot be resampled or turned into rows.
    pub fn observed(&self, clip: &Clip) -> Result<ObservedClip, LibraryError> {
        let clip = clip.resample(1.0 / self.body.frame_time)?;
        let name = || clip.name.clone();
        let mismatch = |reason| LibraryError::Body { clip: name(), reason: Box::new(reason) };
        self.body.mapping.skeleton().same_body(&clip.skeleton).map_err(mismatch)?;
        let failed = |reason| LibraryError::Pose { clip: name(), reason: Box::new(reason) };
        let mut rows = self.body.mapping.encode(&clip).map_err(failed)?.y;
        let frames = rows.nrows();
        for (mut column, mean) in rows.column_iter_mut().zip(&self.body.column_means) {
            column.add_scalar_mut(-mean);
        }
        let info = SequenceInfo {
            name: clip.name.clone(),
            sha256: clip.sha256.clone(),
            frames,
            rests_from: None,
            piece: clip.piece,
            bones_of: clip.bones_of.clone(),
            whole: true,
        };
        Ok(ObservedClip { y: self.body.layout.split(&rows), info })
    }

    /// A fit of the couplings of a combination to clips, ready to begin.
    ///
    /// # Errors
    ///
    /// As [`CouplingTrainer::new`].
    pub fn coupling_trainer(
        &self,
        uses: &[usize],
        clips: &[ObservedClip],
        max_iterations: usize,
    ) -> Result<CouplingTrainer, LibraryError> {
        let lengths = clips.iter().map(|clip| clip.info.frames).collect();
        let parts = 0..self.library.part_count();
        let stacked = parts.map(|part| {
            let rows = clips.iter().flat_map(|clip| clip.y[part].row_iter());
            let rows: Vec<_> = rows.map(|row| row.into_owned()).collect();
            if rows.is_empty() { DMatrix::zeros(0, 0) } else { DMatrix::from_rows(&rows) }
        });
        Ok(CouplingTrainer::new(&self.library, uses, stacked.collect(), lengths, max_iterations)?)
    }

    /// Adds a movement that starts where these clips do; one of the same name makes way.
    pub fn add(&mut self, movement: LearnedMovement, sequences: Vec<SequenceInfo>) {
        if let Some(old) = self.library.movements.iter().position(|m| m.name == movement.name) {
            let before: usize = self.library.movements[..old].iter().map(|m| m.starts.len()).sum();
            let gone = self.library.movements.remove(old).starts.len();
            self.body.sequences.drain(before..before + gone);
        }
        self.library.movements.push(movement);
        self.body.sequences.extend(sequences);
    }
}
