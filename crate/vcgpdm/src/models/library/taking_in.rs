//! Primitives of one library taken into another.

use crate::models::library::{CombinationError, LearnedMovement, Primitive, TrainedLibrary};
use crate::motion::BodyMismatch;
use thiserror::Error;

/// Why primitives of another library do not fit this one as they are.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Misfit {
    /// They move another body.
    #[error("the skeletons differ: {0}")]
    Skeleton(Box<BodyMismatch>),
    /// The body is divided into other parts, so that a part has other columns.
    #[error("the columns differ: expected the parts {expected}, found {found}")]
    Parts {
        /// Parts of this library.
        expected: String,
        /// Parts of the other.
        found: String,
    },
    /// A part of the same name has other joints, and with them other columns.
    #[error("the columns differ: the part {part} has other joints")]
    Joints {
        /// Name of the part.
        part: String,
    },
    /// The columns are centred at other means, or measured from another pose.
    #[error("the columns differ: they are centred, or measured, in another way")]
    Centre,
    /// Another frame rate.
    #[error(
        "the columns differ: expected {expected:.6} seconds from one frame to the next, found {found:.6}"
    )]
    FrameTime {
        /// Seconds from one frame to the next, here.
        expected: f64,
        /// The same, there.
        found: f64,
    },
    /// Dynamics of another order.
    #[error("the order of the dynamics differs: expected {expected}, found {found}")]
    Order {
        /// The order here.
        expected: usize,
        /// The order there.
        found: usize,
    },
    /// A part has another number of latent dimensions.
    #[error("the latent dimensions of {part} differ: expected {expected}, found {found}")]
    Latent {
        /// Name of the part.
        part: String,
        /// Latent dimensions here.
        expected: usize,
        /// Latent dimensions there.
        found: usize,
    },
    /// A part's pose map is another one, so that the same latents mean other poses.
    #[error("the pose maps of {part} differ: they come from different trainings")]
    PoseMap {
        /// Name of the part.
        part: String,
    },
}

impl Misfit {
    /// Whether the primitives can be learned again under the pose maps of this library
    /// ([`ImportTrainer`](crate::models::library::ImportTrainer)): where they move the same parts of the same
    /// body.
    pub fn can_be_relearned(&self) -> bool {
        !matches!(self, Self::Skeleton(_) | Self::Parts { .. } | Self::Joints { .. })
    }
}

/// Why primitives were not taken in.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TakeInError {
    /// They do not fit as they are.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// What they learned cannot be taken apart.
    #[error(transparent)]
    Combination(#[from] CombinationError),
}

/// What became of primitives that were taken in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TakenIn {
    /// Of each primitive of the other library, its place here.
    pub primitives: Vec<usize>,
    /// The places of those that are new.
    pub added: Vec<usize>,
    /// The places of movements that came with them.
    pub movements: Vec<usize>,
}

impl TrainedLibrary {
    /// Checks that primitives of another library can be coupled with those of this one as they are: the same
    /// body in the same columns, and the same latent spaces, those of the pose maps.
    ///
    /// # Errors
    ///
    /// What differs first.
    pub fn check_fit(&self, other: &TrainedLibrary) -> Result<(), Misfit> {
        self.check_body(other)?;
        let (here, there) = (&self.library, &other.library);
        let names: Vec<String> = self.body.layout.parts().iter().map(|part| part.name.clone()).collect();
        if here.order != there.order {
            return Err(Misfit::Order { expected: here.order, found: there.order });
        }
        let latent = here.latent_dimensions().into_iter().zip(there.latent_dimensions()).zip(&names);
        for ((expected, found), part) in latent {
            if expected != found {
                return Err(Misfit::Latent { part: part.clone(), expected, found });
            }
        }
        let mut maps = here.parts.iter().zip(&there.parts).zip(names);
        if let Some((_, part)) = maps.find(|((a, b), _)| a != b) {
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

    /// Checks that both move the same parts of the same body.
    pub(super) fn check_body(&self, other: &TrainedLibrary) -> Result<(), Misfit> {
        let (here, there) = (self.body.mapping.skeleton(), other.body.mapping.skeleton());
        here.same_body(there).map_err(|reason| Misfit::Skeleton(Box::new(reason)))?;
        let (here, there) = (self.body.layout.parts(), other.body.layout.parts());
        if !here.iter().map(|part| &part.name).eq(there.iter().map(|part| &part.name)) {
            let names = |library: &TrainedLibrary| {
                let parts = library.body.layout.parts().iter();
                parts.map(|part| part.name.chars().take(60).collect()).collect::<Vec<String>>().join(", ")
            };
            return Err(Misfit::Parts { expected: names(self), found: names(other) });
        }
        let same = |part: usize| self.body.layout.columns(part) == other.body.layout.columns(part);
        match (0..here.len()).find(|part| !same(*part)) {
            Some(part) => Err(Misfit::Joints { part: here[part].name.clone() }),
            None => Ok(()),
        }
    }

    /// Adds the primitives of another library that are not here yet, and its movements. A name that is taken
    /// gets a number. What a new primitive learned together with one that is here already is kept of the new
    /// one alone: the other has learned it before.
    ///
    /// # Errors
    ///
    /// When they do not fit as they are; then nothing has changed.
    pub fn take_in(&mut self, other: &TrainedLibrary) -> Result<TakenIn, TakeInError> {
        self.check_fit(other)?;
        let known = |primitive: &Primitive| {
            let same = |own: &Primitive| {
                own.part == primitive.part
                    && own.experts.iter().zip(&primitive.experts).all(|(a, b)| a.fitted == b.fitted)
            };
            self.library.primitives.iter().position(same)
        };
        let found: Vec<Option<usize>> = other.library.primitives.iter().map(known).collect();
        let new: Vec<usize> = (0..found.len()).filter(|a| found[*a].is_none()).collect();
        let arriving = if new.is_empty() { None } else { Some(other.select(&new)?) };

        let mut places: Vec<usize> = found.iter().map(|place| place.unwrap_or_default()).collect();
        let mut taken = TakenIn { primitives: Vec::new(), added: Vec::new(), movements: Vec::new() };
        let arriving = arriving.map(|library| library.library.primitives).unwrap_or_default();
        for (a, primitive) in new.iter().zip(arriving) {
            let name = self.free_name(primitive.part, &primitive.name);
            // The movements that it would keep excerpts of come along below.
            let excerpts = other.library.primitives[*a].excerpts.clone();
            places[*a] = self.library.primitives.len();
            taken.added.push(places[*a]);
            self.library.primitives.push(Primitive { name, excerpts, ..primitive });
        }
        for (m, movement) in other.library.movements.iter().enumerate() {
            let uses: Vec<usize> = movement.uses.iter().map(|a| places[*a]).collect();
            let same = |own: &LearnedMovement| own.uses == uses && own.alpha == movement.alpha;
            if self.library.movements.iter().any(same) {
                continue;
            }
            let name = self.free_movement_name(&movement.name);
            let all_new = movement.uses.iter().all(|a| new.contains(a));
            let sums = movement.sums.clone().filter(|_| all_new);
            taken.movements.push(self.library.movements.len());
            self.library.movements.push(LearnedMovement { name, uses, sums, ..movement.clone() });
            self.body.sequences.extend(other.sequences_of(m).iter().cloned());
        }
        taken.primitives = places;
        Ok(taken)
    }

    /// The name, or the name with a number that no primitive of the part has.
    pub(super) fn free_name(&self, part: usize, name: &str) -> String {
        let primitives = || self.library.primitives.iter().filter(|own| own.part == part);
        free(name, |name| primitives().any(|own| own.name == name))
    }

    /// The name, or the name with a number that no movement has.
    pub(super) fn free_movement_name(&self, name: &str) -> String {
        free(name, |name| self.library.movements.iter().any(|own| own.name == name))
    }
}

fn free(name: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let mut found = name.to_owned();
    let mut number = 2;
    while is_taken(&found) {
        found = format!("{name} {number}");
        number += 1;
    }
    found
}
