//! A library with the body that it moves and its provenance.

use crate::models::data::dataset::DatasetError;
use crate::models::data::sequences::SequenceInfo;
use crate::models::kinds::body::Body;
use crate::models::kinds::fitted_model::FittedModel;
use crate::models::kinds::model::Model;
use crate::models::library::{CombinationError, CouplingsFrom, LearnedMovement, Library};
use crate::models::rollout::request::RolloutError;
use crate::models::training::provenance::Provenance;
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
    /// From columns to poses; its sequences are those of the movements, one movement after the other.
    pub body: Body,
    /// How the library was trained.
    pub provenance: Provenance,
}

/// Why a clip does not fit a library, or a choice of primitives cannot be read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LibraryError {
    /// The clip has another body.
    #[error("{clip} does not have the body of the library: {reason}")]
    Body {
        /// The clip.
        clip: String,
        /// The difference.
        reason: Box<BodyMismatch>,
    },
    /// The clip cannot be brought to the library's frame rate.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// The clip's poses cannot be turned into rows.
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
        /// A choice of this library.
        example: String,
        /// The text found.
        found: String,
    },
    /// There is no part or primitive of this name.
    #[error("expected {what} to be one of {names}, found {found:?}")]
    Unknown {
        /// "the part" or "the primitive".
        what: &'static str,
        /// The names that exist.
        names: String,
        /// The text found.
        found: String,
    },
    /// The primitives cannot be combined.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// A movement cannot be rolled out.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// The couplings cannot be learned.
    #[error(transparent)]
    Training(#[from] DatasetError),
}

/// A clip as centred columns of the parts of a library.
#[derive(Clone, Debug)]
pub struct EncodedClip {
    /// Columns of each part, centred by the library's means [T x D_i].
    pub y: Vec<DMatrix<f64>>,
    /// The clip that they came from.
    pub info: SequenceInfo,
}

impl TrainedLibrary {
    /// The model of a movement, as it was learned.
    ///
    /// # Errors
    ///
    /// When there is no such movement, or a covariance cannot be factorised.
    pub fn movement(&self, index: usize) -> Result<Model, CombinationError> {
        let model = self.library.movement(index)?;
        let sequences = (0..model.starts.len()).map(|s| (index, s)).collect();
        Ok(self.with_sequences(model, sequences))
    }

    /// The model of the primitive `uses[part]` of each part under the couplings `alpha` [M x M].
    ///
    /// # Errors
    ///
    /// As [`Library::combination`].
    pub fn combination(&self, uses: &[usize], alpha: &DMatrix<f64>) -> Result<Model, CombinationError> {
        let model = self.library.combination(uses, alpha)?;
        Ok(self.with_sequences(model, self.library.start_sequences(uses)))
    }

    /// The sequences that a combination can start from.
    pub fn start_infos(&self, uses: &[usize]) -> Vec<SequenceInfo> {
        self.infos(self.library.start_sequences(uses))
    }

    /// The sequences at these places: (movement, sequence of the movement).
    fn infos(&self, chosen: Vec<(usize, usize)>) -> Vec<SequenceInfo> {
        let info = |(movement, sequence): (usize, usize)| self.sequences_of(movement).get(sequence).cloned();
        chosen.into_iter().filter_map(info).collect()
    }

    /// The sequences of a movement.
    pub fn sequences_of(&self, movement: usize) -> &[SequenceInfo] {
        let mut counts = self.library.movements.iter().map(|m| m.starts.len());
        let first: usize = counts.clone().take(movement).sum();
        let end = first + counts.nth(movement).unwrap_or(0);
        self.body.sequences.get(first..end).unwrap_or_default()
    }

    fn with_sequences(&self, model: Vcgpdm, chosen: Vec<(usize, usize)>) -> Model {
        let body = Body { sequences: self.infos(chosen), ..self.body.clone() };
        Model { fitted: FittedModel::Vcgpdm(Box::new(model)), body, provenance: self.provenance.clone() }
    }

    /// Reads the primitive of each part from a text such as `lower=walk,upper=wave`. A name is that of a
    /// primitive of the part, or of a movement that uses one.
    ///
    /// # Errors
    ///
    /// When a part or primitive does not exist, or the text does not have one primitive for each part.
    pub fn read_uses(&self, text: &str) -> Result<Vec<usize>, LibraryError> {
        let mut uses: Vec<Option<usize>> = vec![None; self.library.part_count()];
        for a in self.read_primitives(text)? {
            if uses[self.library.primitives[a].part].replace(a).is_some() {
                return Err(self.choice_error(text));
            }
        }
        let whole: Option<Vec<usize>> = uses.into_iter().collect();
        whole.ok_or_else(|| self.choice_error(text))
    }

    /// As [`read_uses`](Self::read_uses), of any number of primitives of any parts.
    ///
    /// # Errors
    ///
    /// When a part or primitive does not exist.
    pub fn read_primitives(&self, text: &str) -> Result<Vec<usize>, LibraryError> {
        let parts: Vec<&str> = self.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
        let choice = |choice: &str| {
            let (part, name) = choice.split_once('=').ok_or_else(|| self.choice_error(choice))?;
            let (part, name) = (part.trim(), name.trim());
            let place = parts.iter().position(|name| *name == part).ok_or_else(|| LibraryError::Unknown {
                what: "the part",
                names: parts.join(", "),
                found: shortened(part),
            })?;
            self.primitive(place, name).ok_or_else(|| LibraryError::Unknown {
                what: "the primitive",
                names: self.names(place),
                found: shortened(name),
            })
        };
        text.split(',').map(choice).collect()
    }

    fn choice_error(&self, text: &str) -> LibraryError {
        let parts: Vec<&str> = self.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
        LibraryError::Choice { example: self.example(&parts), found: shortened(text) }
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

    /// A clip at the library's frame rate, as centred columns of the parts.
    ///
    /// # Errors
    ///
    /// When the clip has another body, or cannot be resampled or turned into rows.
    pub fn encode(&self, clip: &Clip) -> Result<EncodedClip, LibraryError> {
        let columns = self.body.encode(clip).map_err(|reason| match reason {
            DatasetError::OtherBody { clip, reason } => LibraryError::Body { clip, reason },
            DatasetError::Clip(reason) => LibraryError::Clip(reason),
            DatasetError::Pose { clip, reason } => LibraryError::Pose { clip, reason },
            reason => LibraryError::Training(reason),
        })?;
        let info = SequenceInfo {
            name: clip.name.clone(),
            sha256: clip.sha256.clone(),
            frames: columns.nrows(),
            rests_from: None,
            piece: clip.piece,
            bones_of: clip.bones_of.clone(),
            whole: true,
        };
        Ok(EncodedClip { y: self.body.centred(&columns), info })
    }

    /// Adds a combination under the couplings `alpha` [M x M] as a movement of this name, which replaces a
    /// combination of the same name. It starts as the movements that share most primitives with it. `from` is
    /// the origin of the couplings; without it, they are the nearest couplings or chosen by the user.
    ///
    /// # Errors
    ///
    /// As [`Library::combination`], and when a learned movement has the name.
    pub fn add_combination(
        &mut self,
        name: &str,
        uses: &[usize],
        alpha: &DMatrix<f64>,
        from: Option<CouplingsFrom>,
    ) -> Result<(), CombinationError> {
        // The same checks as those of a model that is rolled out.
        self.combination(uses, alpha)?;
        let nearest = self.library.nearest_combination(name, uses)?;
        let couplings = match from {
            None if nearest.alpha == *alpha => nearest.couplings,
            from => from.unwrap_or(CouplingsFrom::Hand),
        };
        let infos = self.start_infos(uses);
        self.add(LearnedMovement { alpha: alpha.clone(), couplings, ..nearest }, infos)
    }

    /// Checks that a combination can have this name. It must not replace a learned movement, whose rows hold
    /// what the primitives learned.
    ///
    /// # Errors
    ///
    /// When a learned movement has the name.
    pub fn check_name(&self, name: &str) -> Result<(), CombinationError> {
        let has_rows = |m: &LearnedMovement| m.name == name && m.sums.is_some();
        if self.library.movements.iter().any(has_rows) {
            return Err(CombinationError::Learned { found: shortened(name) });
        }
        Ok(())
    }

    /// Adds a movement that starts as these sequences; it replaces a combination of the same name.
    ///
    /// # Errors
    ///
    /// When a learned movement has the name.
    pub fn add(
        &mut self,
        movement: LearnedMovement,
        sequences: Vec<SequenceInfo>,
    ) -> Result<(), CombinationError> {
        self.check_name(&movement.name)?;
        if let Some(old) = self.library.movements.iter().position(|m| m.name == movement.name) {
            let before: usize = self.library.movements[..old].iter().map(|m| m.starts.len()).sum();
            let count = self.library.movements.remove(old).starts.len();
            self.body.sequences.drain(before..before + count);
        }
        self.library.movements.push(movement);
        self.body.sequences.extend(sequences);
        Ok(())
    }
}

fn shortened(found: &str) -> String {
    found.chars().take(60).collect()
}

crate::coded!(LibraryError {
    Self::Body { reason, .. } if reason.only_bones_differ() => Bones,
    Self::Body { .. } => Clips,
    Self::Clip(reason) => reason.code(),
    Self::Pose { reason, .. } => reason.code(),
    Self::Combination(reason) => reason.code(),
    Self::Rollout(reason) => reason.code(),
    Self::Training(reason) => reason.code(),
    _ => Model,
});
