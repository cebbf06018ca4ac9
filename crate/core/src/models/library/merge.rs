//! Merges the primitives of one library into another.

use crate::models::library::{CombinationError, LearnedMovement, Primitive, TrainedLibrary};
use crate::motion::BodyMismatch;
use thiserror::Error;

/// Why primitives of another library cannot be used in this one without a new training.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Misfit {
    /// They move another body.
    #[error("the skeletons differ: {0}")]
    Skeleton(Box<BodyMismatch>),
    /// The body is divided into other parts.
    #[error("the columns differ: expected the parts {expected}, found {found}")]
    Parts {
        /// Parts of this library.
        expected: String,
        /// Parts of the other.
        found: String,
    },
    /// A part of the same name has other joints.
    #[error("the columns differ: the part {part} has other joints")]
    Joints {
        /// Name of the part.
        part: String,
    },
    /// The columns have other means, or are measured from another pose.
    #[error("the columns differ: they are centred, or measured, in another way")]
    Centre,
    /// Another frame rate.
    #[error(
        "the columns differ: expected {expected:.6} seconds from one frame to the next, found {found:.6}"
    )]
    FrameTime {
        /// Seconds from one frame to the next in this library.
        expected: f64,
        /// Seconds from one frame to the next in the other library.
        found: f64,
    },
    /// Dynamics of another order.
    #[error("the order of the dynamics differs: expected {expected}, found {found}")]
    Order {
        /// The order in this library.
        expected: usize,
        /// The order in the other library.
        found: usize,
    },
    /// A part has another number of latent dimensions.
    #[error("the latent dimensions of {part} differ: expected {expected}, found {found}")]
    Latent {
        /// Name of the part.
        part: String,
        /// Latent dimensions in this library.
        expected: usize,
        /// Latent dimensions in the other library.
        found: usize,
    },
    /// A part has another pose map, so the same latents mean other poses.
    #[error("the pose maps of {part} differ: they come from different trainings")]
    PoseMap {
        /// Name of the part.
        part: String,
    },
}

/// Why two libraries cannot be merged.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MergeError {
    /// The primitives of one do not fit the other.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// The new primitives cannot be separated from the others of their library.
    #[error(transparent)]
    Combination(#[from] CombinationError),
}

impl TrainedLibrary {
    /// Checks that primitives of another library can be coupled with those of this one: both need the same
    /// body, the same columns and the same pose maps.
    ///
    /// # Errors
    ///
    /// The first difference.
    pub fn check_fit(&self, other: &TrainedLibrary) -> Result<(), Misfit> {
        self.check_body(other)?;
        let (own, others) = (&self.library, &other.library);
        let names: Vec<String> = self.body.layout.parts().iter().map(|part| part.name.clone()).collect();
        if own.order != others.order {
            return Err(Misfit::Order { expected: own.order, found: others.order });
        }
        let latent = own.latent_dimensions().into_iter().zip(others.latent_dimensions()).zip(&names);
        for ((expected, found), part) in latent {
            if expected != found {
                return Err(Misfit::Latent { part: part.clone(), expected, found });
            }
        }
        let mut maps = own.parts.iter().zip(&others.parts).zip(names);
        if let Some((_, part)) = maps.find(|((a, b), _)| !a.is_same_map(b)) {
            return Err(Misfit::PoseMap { part });
        }
        let (expected, found) = (self.body.frame_time, other.body.frame_time);
        if expected != found {
            return Err(Misfit::FrameTime { expected, found });
        }
        if self.body.column_means != other.body.column_means || self.body.mapping != other.body.mapping {
            return Err(Misfit::Centre);
        }
        Ok(())
    }

    /// Checks that both libraries move the same parts of the same body.
    pub(super) fn check_body(&self, other: &TrainedLibrary) -> Result<(), Misfit> {
        let (own, others) = (self.body.mapping.skeleton(), other.body.mapping.skeleton());
        own.same_body(others).map_err(|reason| Misfit::Skeleton(Box::new(reason)))?;
        if self.body.mapping.climbs() != other.body.mapping.climbs() {
            return Err(Misfit::Centre);
        }
        let (own, others) = (self.body.layout.parts(), other.body.layout.parts());
        if !own.iter().map(|part| &part.name).eq(others.iter().map(|part| &part.name)) {
            let names = |library: &TrainedLibrary| {
                let parts = library.body.layout.parts().iter();
                parts.map(|part| part.name.chars().take(60).collect()).collect::<Vec<String>>().join(", ")
            };
            return Err(Misfit::Parts { expected: names(self), found: names(other) });
        }
        let same = |part: usize| self.body.layout.columns(part) == other.body.layout.columns(part);
        match (0..own.len()).find(|part| !same(*part)) {
            Some(part) => Err(Misfit::Joints { part: own[part].name.clone() }),
            None => Ok(()),
        }
    }

    /// Adds the primitives and movements of another library that this library does not have yet. A name that
    /// is in use gets a number. Rows from which a new primitive learned together with one of this library
    /// count for the new primitive alone: the other has learned from them before.
    ///
    /// # Errors
    ///
    /// When the primitives do not fit; then nothing changes.
    pub fn merge(&mut self, other: &TrainedLibrary) -> Result<(), MergeError> {
        self.check_fit(other)?;
        let own_place = |primitive: &Primitive| {
            let same = |own: &Primitive| {
                own.part == primitive.part
                    && own.experts.iter().zip(&primitive.experts).all(|(a, b)| a.fitted == b.fitted)
            };
            self.library.primitives.iter().position(same)
        };
        let found: Vec<Option<usize>> = other.library.primitives.iter().map(own_place).collect();
        let new: Vec<usize> = (0..found.len()).filter(|a| found[*a].is_none()).collect();
        let arriving = if new.is_empty() { None } else { Some(other.select(&new)?) };

        let mut places: Vec<usize> = found.iter().map(|place| place.unwrap_or_default()).collect();
        let arriving = arriving.map(|library| library.library.primitives).unwrap_or_default();
        for (a, primitive) in new.iter().zip(arriving) {
            let name = self.unused_name(primitive.part, &primitive.name);
            // The movements of which `select` made excerpts are added below.
            let excerpts = other.library.primitives[*a].excerpts.clone();
            places[*a] = self.library.primitives.len();
            self.library.primitives.push(Primitive { name, excerpts, ..primitive });
        }
        for (m, movement) in other.library.movements.iter().enumerate() {
            let uses: Vec<usize> = movement.uses.iter().map(|a| places[*a]).collect();
            let same = |own: &LearnedMovement| own.uses == uses && own.alpha == movement.alpha;
            if self.library.movements.iter().any(same) {
                continue;
            }
            let name = self.unused_movement_name(&movement.name);
            let all_new = movement.uses.iter().all(|a| new.contains(a));
            let sums = movement.sums.clone().filter(|_| all_new);
            self.library.movements.push(LearnedMovement { name, uses, sums, ..movement.clone() });
            self.body.sequences.extend(other.sequences_of(m).iter().cloned());
        }
        Ok(())
    }

    /// The name, with a number where a primitive of the part has the name.
    pub(super) fn unused_name(&self, part: usize, name: &str) -> String {
        let primitives = || self.library.primitives.iter().filter(|own| own.part == part);
        numbered(name, |name| primitives().any(|own| own.name == name))
    }

    /// The name, with a number where a movement has the name.
    pub(super) fn unused_movement_name(&self, name: &str) -> String {
        numbered(name, |name| self.library.movements.iter().any(|own| own.name == name))
    }
}

fn numbered(name: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let mut found = name.to_owned();
    let mut number = 2;
    while is_taken(&found) {
        found = format!("{name} {number}");
        number += 1;
    }
    found
}

crate::coded!(MergeError { Self::Combination(reason) => reason.code(), _ => Model });
