//! A library with the body that it moves, and how it was made.

use crate::models::data::dataset::DatasetError;
use crate::models::data::sequence_info::SequenceInfo;
use crate::models::fitted::body::Body;
use crate::models::fitted::fitted_model::FittedModel;
use crate::models::fitted::model::Model;
use crate::models::fitted::provenance::Provenance;
use crate::models::library::{CombinationError, CouplingsFrom, LearnedMovement, Library};
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
    pub provenance: Provenance,
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
    Training(#[from] DatasetError),
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

    /// Where the sequences come from that a combination can start from.
    pub fn start_infos(&self, uses: &[usize]) -> Vec<SequenceInfo> {
        self.infos(self.library.start_sequences(uses))
    }

    /// Of sequences by movement and place in it.
    fn infos(&self, chosen: Vec<(usize, usize)>) -> Vec<SequenceInfo> {
        let info = |(movement, sequence): (usize, usize)| self.sequences_of(movement).get(sequence).cloned();
        chosen.into_iter().filter_map(info).collect()
    }

    /// Where the sequences of a movement come from.
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

    /// The primitives that a text such as `lower=walk,upper=wave` names: of each part the primitive of that
    /// name, or the one that the movement of that name uses.
    ///
    /// # Errors
    ///
    /// When it names a part or a primitive that is not there, or not just one primitive for each part.
    pub fn uses(&self, text: &str) -> Result<Vec<usize>, LibraryError> {
        let mut uses: Vec<Option<usize>> = vec![None; self.library.part_count()];
        for a in self.chosen(text)? {
            if uses[self.library.primitives[a].part].replace(a).is_some() {
                return Err(self.misunderstood(text));
            }
        }
        let whole: Option<Vec<usize>> = uses.into_iter().collect();
        whole.ok_or_else(|| self.misunderstood(text))
    }

    /// The primitives that a text such as `lower=walk,upper=wave` names, as [`uses`](Self::uses): of any
    /// parts, one or more.
    ///
    /// # Errors
    ///
    /// When it names a part or a primitive that is not there.
    pub fn chosen(&self, text: &str) -> Result<Vec<usize>, LibraryError> {
        let parts: Vec<&str> = self.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
        let choice = |choice: &str| {
            let (part, name) = choice.split_once('=').ok_or_else(|| self.misunderstood(choice))?;
            let (part, name) = (part.trim(), name.trim());
            let place = parts.iter().position(|known| *known == part).ok_or_else(|| {
                LibraryError::Unknown { what: "the part", known: parts.join(", "), found: shown(part) }
            })?;
            self.primitive(place, name).ok_or_else(|| LibraryError::Unknown {
                what: "the primitive",
                known: self.names(place),
                found: shown(name),
            })
        };
        text.split(',').map(choice).collect()
    }

    fn misunderstood(&self, text: &str) -> LibraryError {
        let parts: Vec<&str> = self.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
        LibraryError::Choice { example: self.example(&parts), found: shown(text) }
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

    /// Adds a combination under the couplings `alpha` [M x M] as a movement of that name, which starts where
    /// the nearest movements do; a combination of the same name makes way. Couplings that are not the nearest
    /// ones come from where `from` says, else from somebody's hand.
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

    /// Checks that a combination can have this name: the rows of a learned movement, and with them where
    /// primitives come from, would go.
    ///
    /// # Errors
    ///
    /// When a learned movement has it.
    pub fn check_name(&self, name: &str) -> Result<(), CombinationError> {
        let has_rows = |m: &LearnedMovement| m.name == name && m.sums.is_some();
        if self.library.movements.iter().any(has_rows) {
            return Err(CombinationError::Learned { found: shown(name) });
        }
        Ok(())
    }

    /// Adds a movement that starts where these clips do; a combination of the same name makes way.
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
            let gone = self.library.movements.remove(old).starts.len();
            self.body.sequences.drain(before..before + gone);
        }
        self.library.movements.push(movement);
        self.body.sequences.extend(sequences);
        Ok(())
    }
}

fn shown(found: &str) -> String {
    found.chars().take(60).collect()
}
