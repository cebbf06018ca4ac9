//! Movements and the primitives that their parts use (Velychko et al. 2018, section 5.5).
//!
//! A primitive belongs to one part and consists of its experts about every part. A movement is a set of
//! sequences that uses one primitive of each part and has its own couplings. The plain model has one movement
//! and one primitive for each part.

use crate::models::data::sequences::Sequences;
use crate::models::errors::RepertoireError;

/// One movement: the place of its sequences, and the primitive of each part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Movement {
    sequences: Sequences,
    uses: Vec<usize>,
}

impl Movement {
    /// The sequences, with their places in the stack of all frames.
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The primitive that each part uses `[M]`.
    pub fn uses(&self) -> &[usize] {
        &self.uses
    }
}

/// All primitives, and the movements that are made of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repertoire {
    sequences: Sequences,
    primitives: Vec<usize>,
    movements: Vec<Movement>,
}

impl Repertoire {
    /// One movement, in which each of M = `parts` parts has its own primitive: the plain model.
    pub fn plain(sequences: Sequences, parts: usize) -> Self {
        let movement = Movement { sequences: sequences.clone(), uses: (0..parts).collect() };
        Self { sequences, primitives: (0..parts).collect(), movements: vec![movement] }
    }

    /// Primitives of M = `parts` parts: `primitives` are the parts to which they belong. Each movement has a
    /// number of `sequences`, one movement after the other, and the primitive of each part.
    ///
    /// # Errors
    ///
    /// When there is no movement, the movements do not have all sequences between them, or a part uses a
    /// primitive that is not its own.
    pub fn new(
        sequences: Sequences,
        parts: usize,
        primitives: Vec<usize>,
        movements: Vec<(usize, Vec<usize>)>,
    ) -> Result<Self, RepertoireError> {
        if movements.is_empty() {
            return Err(RepertoireError::NoMovement);
        }
        if let Some(primitive) = primitives.iter().position(|part| *part >= parts) {
            return Err(RepertoireError::Part { primitive, parts, found: primitives[primitive] });
        }
        let expected = sequences.lengths().len();
        let mut first = 0;
        let mut out = Vec::with_capacity(movements.len());
        for (movement, (count, uses)) in movements.into_iter().enumerate() {
            if uses.len() != parts {
                return Err(RepertoireError::Uses { movement, parts, found: uses.len() });
            }
            for (part, used) in uses.iter().enumerate() {
                if primitives.get(*used) != Some(&part) {
                    return Err(RepertoireError::Primitive { movement, part, found: *used });
                }
            }
            let found = first + count;
            let some = sequences.subset(first..found);
            let sequences = some.map_err(|_| RepertoireError::Sequences { expected, found })?;
            out.push(Movement { sequences, uses });
            first = found;
        }
        if first != expected {
            return Err(RepertoireError::Sequences { expected, found: first });
        }
        Ok(Self { sequences, primitives, movements: out })
    }

    /// The sequences of all movements.
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The part to which each primitive belongs.
    pub fn primitives(&self) -> &[usize] {
        &self.primitives
    }

    /// The movements.
    pub fn movements(&self) -> &[Movement] {
        &self.movements
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sequences() -> Sequences {
        Sequences::new(vec![5, 4, 6], 2).unwrap()
    }

    #[test]
    fn movements_take_the_sequences_in_order() {
        let movements = vec![(2, vec![0, 1]), (1, vec![0, 2])];
        let repertoire = Repertoire::new(sequences(), 2, vec![0, 1, 1], movements).unwrap();
        let lengths: Vec<_> = repertoire.movements().iter().map(|m| m.sequences().lengths()).collect();
        assert_eq!(lengths, [&[5, 4][..], &[6][..]]);
        assert_eq!(repertoire.movements()[1].sequences().ranges().next(), Some(9..15));
        let plain = Repertoire::plain(sequences(), 2);
        assert_eq!(plain, Repertoire::new(sequences(), 2, vec![0, 1], vec![(3, vec![0, 1])]).unwrap());
    }

    #[test]
    fn refuses_movements_that_do_not_fit() {
        let words = |primitives: &[usize], movements: &[(usize, &[usize])]| {
            let movements = movements.iter().map(|(count, uses)| (*count, uses.to_vec())).collect();
            Repertoire::new(sequences(), 2, primitives.to_vec(), movements).unwrap_err().to_string()
        };
        assert_eq!(words(&[0, 1], &[]), "expected at least one movement, found none");
        assert_eq!(
            words(&[0, 2], &[(3, &[0, 1])]),
            "expected primitive 1 to belong to a part from 0 to 1, found 2"
        );
        assert_eq!(
            words(&[0, 1], &[(3, &[0])]),
            "expected movement 0 to name a primitive for each of 2 parts, found 1"
        );
        for wrong in [0, 7] {
            assert_eq!(
                words(&[0, 1], &[(3, &[0, wrong])]),
                format!(
                    "expected movement 0 to give part 1 a primitive of that part, found primitive {wrong}"
                )
            );
        }
        for counts in [[2, 2], [3, 0], [1, 1]] {
            let movements: &[(usize, &[usize])] = &[(counts[0], &[0, 1]), (counts[1], &[0, 1])];
            let found = counts[0] + counts[1];
            assert_eq!(
                words(&[0, 1], movements),
                format!("expected movements of 3 sequences in all, one or more each, found {found}")
            );
        }
    }
}
