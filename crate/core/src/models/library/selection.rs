//! Some primitives of a library, as a library of their own.

use crate::models::kinds::body::Body;
use crate::models::library::origin::{Excerpt, Origin};
use crate::models::library::{
    CombinationError, LearnedMovement, Library, LibraryExpert, Primitive, TrainedLibrary,
};

impl LearnedMovement {
    /// Whether all primitives of the movement are among these.
    fn uses_only(&self, primitives: &[usize]) -> bool {
        self.uses.iter().all(|a| primitives.contains(a))
    }
}

impl Library {
    /// The `chosen` primitives with the pose maps of all parts, and the movements that use only chosen
    /// primitives.
    ///
    /// What a primitive learned from other movements stays in `LibraryExpert::external`, with all other
    /// primitives integrated out, and the primitive gets an `Excerpt` of each of these movements.
    ///
    /// # Errors
    ///
    /// When no primitive is chosen, one does not exist, or a covariance cannot be factorised.
    pub fn select(&self, chosen: &[usize]) -> Result<Library, CombinationError> {
        let count = self.primitives.len();
        let unknown = |found: String| CombinationError::Unknown { count, found };
        if chosen.is_empty() {
            return Err(unknown("none".to_owned()));
        }
        if let Some(found) = chosen.iter().find(|a| **a >= count) {
            return Err(unknown(found.to_string()));
        }
        // Each once, in the order of this library.
        let chosen: Vec<usize> = (0..count).filter(|a| chosen.contains(a)).collect();
        let whole = |movement: &LearnedMovement| movement.uses_only(&chosen);
        let place = |a: &usize| chosen.iter().position(|b| a == b);
        let mut primitives = Vec::with_capacity(chosen.len());
        for &a in &chosen {
            let before = &self.primitives[a];
            let mut experts = Vec::with_capacity(before.experts.len());
            for (i, expert) in before.experts.iter().enumerate() {
                let external = self.information(i, &[a], &whole)?.nonzero();
                experts.push(LibraryExpert { external, ..expert.clone() });
            }
            let others = self.movements.iter().filter(|movement| !whole(movement));
            let using = others.filter(|movement| movement.uses[before.part] == a);
            let excerpt = |movement: &LearnedMovement| Excerpt {
                movement: movement.name.clone(),
                alpha: movement.alpha.row(before.part).iter().copied().collect(),
                starts: movement.starts.clone(),
            };
            let excerpts = before.excerpts.iter().cloned().chain(using.map(excerpt)).collect();
            primitives.push(Primitive { experts, excerpts, ..before.clone() });
        }
        let movements = self.movements.iter().filter(|movement| whole(movement));
        let movements = movements.map(|movement| LearnedMovement {
            uses: movement.uses.iter().filter_map(place).collect(),
            ..movement.clone()
        });
        Ok(Library { primitives, movements: movements.collect(), ..self.clone() })
    }
}

impl TrainedLibrary {
    /// As [`Library::select`]; every primitive keeps its origin.
    ///
    /// # Errors
    ///
    /// As [`Library::select`].
    pub fn select(&self, chosen: &[usize]) -> Result<TrainedLibrary, CombinationError> {
        let mut library = self.library.select(chosen)?;
        let places = (0..self.library.primitives.len()).filter(|a| chosen.contains(a));
        for (primitive, a) in library.primitives.iter_mut().zip(places) {
            primitive.origin = Some(Box::new(self.origin(a)));
        }
        let movements =
            (0..self.library.movements.len()).filter(|m| self.library.movements[*m].uses_only(chosen));
        let sequences = movements.flat_map(|m| self.sequences_of(m).to_vec()).collect();
        let body = Body { sequences, ..self.body.clone() };
        Ok(TrainedLibrary { library, body, provenance: self.provenance.clone() })
    }

    /// The origin of a primitive. A primitive without one of its own comes from the training of the library
    /// and the clips of the movements that use it.
    pub fn origin(&self, primitive: usize) -> Origin {
        if let Some(origin) = self.library.primitives.get(primitive).and_then(|own| own.origin.as_ref()) {
            return Origin::clone(origin);
        }
        let movements = self.library.movements.iter().enumerate();
        let using = movements.filter(|(_, m)| m.sums.is_some() && m.uses.contains(&primitive));
        let clips = using.flat_map(|(m, _)| self.sequences_of(m).to_vec()).collect();
        Origin { training: self.provenance.clone(), clips, relearned: None }
    }
}
