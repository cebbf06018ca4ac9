//! Which movements a library learns, and which parts use the same primitive in all of them.

use thiserror::Error;

/// Why a plan cannot be followed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A movement has no name, or one that would not be understood.
    #[error(
        "expected a name for each movement, of letters, digits, spaces, \"-\", \"_\" or \".\", found {0:?}"
    )]
    Name(String),
    /// Two movements have the same name.
    #[error("expected a name of its own for each movement, found {0:?} twice")]
    Twice(String),
    /// It is not said of each part whether its primitive is shared.
    #[error("expected same or own for each of {expected} parts, found {found}")]
    Parts {
        /// Parts there are.
        expected: usize,
        /// Parts of the plan.
        found: usize,
    },
}

/// A movement to be learned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedMovement {
    /// Its name.
    pub name: String,
    /// How many of the sequences are its own; they follow those of the movements before it.
    pub sequences: usize,
}

/// The movements of a library to be learned, and of each part whether it uses the same primitive in all of
/// them, or its own in each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LibraryPlan {
    movements: Vec<PlannedMovement>,
    shared: Vec<bool>,
}

/// A primitive of a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PlannedPrimitive {
    pub name: String,
    pub part: usize,
}

/// Names stand in options such as `lower=walk,upper=wave`, and join to names of shared primitives with "+".
fn is_name(name: &str) -> bool {
    let fits = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_' | '.');
    !name.trim().is_empty() && name.trim() == name && name.chars().count() <= 60 && name.chars().all(fits)
}

impl LibraryPlan {
    /// A plan of these movements; `shared[part]` says whether the part uses the same primitive in all of
    /// them.
    ///
    /// # Errors
    ///
    /// When a name is empty, has other signs than letters, digits, spaces, "-", "_" and ".", or stands twice.
    pub fn new(movements: Vec<PlannedMovement>, shared: Vec<bool>) -> Result<Self, PlanError> {
        for (k, movement) in movements.iter().enumerate() {
            if !is_name(&movement.name) {
                return Err(PlanError::Name(movement.name.chars().take(60).collect()));
            }
            if movements[..k].iter().any(|other| other.name == movement.name) {
                return Err(PlanError::Twice(movement.name.clone()));
            }
        }
        Ok(Self { movements, shared })
    }

    /// The movements.
    pub fn movements(&self) -> &[PlannedMovement] {
        &self.movements
    }

    /// Of each part, whether it uses the same primitive in all movements.
    pub fn shared(&self) -> &[bool] {
        &self.shared
    }

    /// Checks that the plan is about so many parts.
    pub(super) fn check(&self, parts: usize) -> Result<(), PlanError> {
        if self.shared.len() == parts {
            return Ok(());
        }
        Err(PlanError::Parts { expected: parts, found: self.shared.len() })
    }

    /// The primitives, part by part: one for all movements, named after them all, or one for each, named
    /// after it.
    pub(super) fn primitives(&self) -> Vec<PlannedPrimitive> {
        let mut primitives = Vec::new();
        for (part, shared) in self.shared.iter().enumerate() {
            let names = self.movements.iter().map(|movement| movement.name.clone());
            if *shared {
                let name = names.collect::<Vec<_>>().join("+");
                primitives.push(PlannedPrimitive { name, part });
            } else {
                primitives.extend(names.map(|name| PlannedPrimitive { name, part }));
            }
        }
        primitives
    }

    /// How many sequences each movement has, and the primitive that each part uses in it.
    pub(super) fn uses(&self) -> Vec<(usize, Vec<usize>)> {
        let count = self.movements.len();
        let uses = |m: usize| {
            let mut first = 0;
            let mut uses = Vec::with_capacity(self.shared.len());
            for shared in &self.shared {
                uses.push(if *shared { first } else { first + m });
                first += if *shared { 1 } else { count };
            }
            uses
        };
        self.movements.iter().enumerate().map(|(m, movement)| (movement.sequences, uses(m))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(names: &[&str], shared: &[bool]) -> Result<LibraryPlan, PlanError> {
        let movements = names.iter().map(|name| PlannedMovement { name: (*name).to_owned(), sequences: 2 });
        LibraryPlan::new(movements.collect(), shared.to_vec())
    }

    #[test]
    fn shared_parts_have_one_primitive_and_others_one_for_each_movement() {
        let plan = plan(&["walk", "wave"], &[true, false]).unwrap();
        let primitives = plan.primitives();
        let names: Vec<_> = primitives.iter().map(|p| (p.part, p.name.as_str())).collect();
        assert_eq!(names, [(0, "walk+wave"), (1, "walk"), (1, "wave")]);
        assert_eq!(plan.uses(), [(2, vec![0, 1]), (2, vec![0, 2])]);
        assert!(plan.check(2).is_ok());
        let words = plan.check(3).unwrap_err().to_string();
        assert_eq!(words, "expected same or own for each of 3 parts, found 2");
    }

    #[test]
    fn names_that_would_not_be_understood_are_refused() {
        for name in ["", " walk", "a=b", "walk+wave", "a,b", "\u{7}"] {
            assert_eq!(plan(&[name], &[true]), Err(PlanError::Name(name.to_owned())));
        }
        assert_eq!(plan(&["walk", "walk"], &[true]), Err(PlanError::Twice("walk".to_owned())));
    }
}
