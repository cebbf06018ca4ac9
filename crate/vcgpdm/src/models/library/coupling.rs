//! New couplings for stored primitives: everything else stays as it was learned.

use crate::models::library::{CouplingsFrom, LearnedMovement, Library};
use crate::models::search::ascent::Phase;
use crate::models::training::error::{TrainingError, in_range};
use crate::models::training::latents::check_training;
use crate::models::training::parameters::Group;
use crate::models::training::progress::Progress;
use crate::models::variational::{Objective, Params, VariationalTrainer};
use nalgebra::DMatrix;

/// More iterations than any fit of couplings needs, or learning primitives again.
pub const MOST_ITERATIONS: usize = 10_000;
/// Iterations in which the latents come near the new frames, before the couplings are free too, as a part of
/// all.
const LATENTS_FIRST: usize = 4;

/// A fit of couplings under way: of a combination of stored primitives, to new frames. Latents of these
/// frames and couplings are learned; pose maps, primitives and their inducing outputs stay.
pub struct CouplingTrainer {
    trainer: VariationalTrainer,
    uses: Vec<usize>,
}

impl CouplingTrainer {
    /// Ready to fit the combination `uses` of a library to the observations `y` [N x D_i] of each part,
    /// centred by the means of the library's columns and stacked as the `lengths` of the sequences say, in at
    /// most so many iterations.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, the observations do not fit the library or the
    /// lengths, or the bound cannot be computed at the start.
    pub fn new(
        library: &Library,
        uses: &[usize],
        y: Vec<DMatrix<f64>>,
        lengths: Vec<usize>,
        max_iterations: usize,
    ) -> Result<Self, TrainingError> {
        library.check_uses(uses)?;
        in_range("the number of iterations", max_iterations, MOST_ITERATIONS)?;
        let sequences = check_training(&y, lengths, library.largest_latent(), library.order)?;
        if y.len() != library.part_count() {
            let (expected, found) = (library.part_count(), y.len());
            return Err(TrainingError::Parts { expected, found });
        }
        for (part, (y, map)) in y.iter().zip(&library.parts).enumerate() {
            if y.ncols() != map.mean().ncols() {
                let (expected, found) = (map.mean().ncols(), y.ncols());
                return Err(TrainingError::Columns { part, expected, found });
            }
        }
        let start = Params {
            parts: library.parts_near(&y, &sequences),
            experts: library.experts_of(uses),
            alpha: vec![library.nearest_couplings(uses)],
        };
        let settings = library.settings_of(&start.experts, max_iterations);
        let stored = library.stored(uses)?;
        let objective = Objective::new(y, sequences, library.jitter).under(stored);
        let trainer = VariationalTrainer::from_start(objective, start, phases(max_iterations), &settings, 0)?;
        Ok(Self { trainer, uses: uses.to_vec() })
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        self.trainer.step()
    }

    /// How far the fit is. The bound is that of the new frames under the stored primitives.
    pub fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    /// The couplings of the best bound so far [M x M].
    pub fn alpha(&self) -> DMatrix<f64> {
        self.trainer.best().alpha.swap_remove(0)
    }

    /// The combination with the best couplings so far, as a movement of that name that starts where the new
    /// frames do. It has no sums: the primitives have learned nothing from these frames.
    pub fn movement(&self, name: &str) -> LearnedMovement {
        let (mut best, progress) = (self.trainer.best(), self.trainer.progress());
        let objective = self.trainer.objective();
        let starts = objective.sequences().ranges().map(|range| best.latent_means(&range)).collect();
        LearnedMovement {
            name: name.to_owned(),
            uses: self.uses.clone(),
            alpha: best.alpha.swap_remove(0),
            sums: None,
            starts,
            couplings: CouplingsFrom::Clips { bound: progress.best, iterations: progress.iteration },
        }
    }
}

fn phases(max_iterations: usize) -> Vec<Phase> {
    use Group::{Couplings, Latents};
    let first = Phase { groups: &[Latents], iterations: max_iterations / LATENTS_FIRST };
    vec![first, Phase { groups: &[Latents, Couplings], iterations: max_iterations }]
}
