//! Plan of a library: its movements, and the parts that use one primitive in all of them.

use crate::models::errors::PlanError;

/// A movement to be learned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedMovement {
    /// Its name.
    pub name: String,
    /// Its number of sequences. The data set has the sequences of all movements in the order of the plan.
    pub sequences: usize,
}

/// The movements of a library, and for each part whether it uses one primitive in all of them or another
/// primitive in each.
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

/// Names are used in options such as `lower=walk,upper=wave`; the name of a shared primitive joins them with
/// "+".
fn is_name(name: &str) -> bool {
    let fits = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_' | '.');
    !name.trim().is_empty() && name.trim() == name && name.chars().count() <= 60 && name.chars().all(fits)
}

impl LibraryPlan {
    /// A plan of these movements; `shared[part]` says whether the part uses one primitive in all of them.
    ///
    /// # Errors
    ///
    /// When a name is empty, has other characters than letters, digits, spaces, "-", "_" and ".", or occurs
    /// twice.
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

    /// Whether each part uses one primitive in all movements `[M]`.
    pub fn shared(&self) -> &[bool] {
        &self.shared
    }

    /// Checks that the plan has this number of `parts`.
    pub(super) fn check(&self, parts: usize) -> Result<(), PlanError> {
        if self.shared.len() == parts {
            return Ok(());
        }
        Err(PlanError::Parts { expected: parts, found: self.shared.len() })
    }

    /// The primitives, part by part. A shared primitive has the names of all movements, another one the name
    /// of its movement.
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

    /// The number of sequences of each movement, and the primitive of each part in it.
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
        let message = plan.check(3).unwrap_err().to_string();
        assert_eq!(message, "expected shared or not for each of 3 parts, found 2");
    }

    #[test]
    fn refuses_names_with_other_characters_and_equal_names() {
        for name in ["", " walk", "a=b", "walk+wave", "a,b", "\u{7}"] {
            assert_eq!(plan(&[name], &[true]), Err(PlanError::Name(name.to_owned())));
        }
        assert_eq!(plan(&["walk", "walk"], &[true]), Err(PlanError::Twice("walk".to_owned())));
    }
}
