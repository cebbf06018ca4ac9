//! New couplings for stored primitives: everything else stays as it was learned.

use crate::models::data::dataset::DatasetError;
use crate::models::data::sequences::SequenceInfo;
use crate::models::errors::{TrainingError, in_range};
use crate::models::kinds::trainer::run_with;
use crate::models::library::{
    CombinationError, CouplingsFrom, EncodedClip, LearnedMovement, Library, LibraryError, TrainedLibrary,
};
use crate::models::search::ascent::Phase;
use crate::models::search::parameters::Group;
use crate::models::training::latents::check_training;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::training::progress::Progress;
use crate::models::variational::{Objective, Params, VariationalTrainer};
use nalgebra::DMatrix;
use std::ops::ControlFlow;

/// The most iterations of a training with a library. Fits of couplings and imports need far fewer.
pub const MOST_ITERATIONS: usize = 10_000;
/// The couplings are fixed during the first 1/4 of the iterations, while the latents come near the new
/// frames.
const LATENTS_FIRST: usize = 4;

/// A fit of the couplings of a combination of stored primitives to clips. The fit learns couplings and the
/// latents of the clips; pose maps, primitives and their inducing outputs stay as they are.
pub struct CouplingTrainer {
    trainer: VariationalTrainer,
    library: TrainedLibrary,
    uses: Vec<usize>,
    sequences: Vec<SequenceInfo>,
}

impl CouplingTrainer {
    /// A fit before its first iteration, of at most `max_iterations` iterations, for the primitive
    /// `uses[part]` of each part.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, the clips do not fit the library, or the bound cannot
    /// be computed at the start; the error names the clip if the reason is in one clip.
    pub fn new(
        library: &TrainedLibrary,
        uses: &[usize],
        clips: &[EncodedClip],
        max_iterations: usize,
    ) -> Result<Self, LibraryError> {
        let (y, sequences) = library.library.stack_clips(clips.iter());
        let lengths = sequences.iter().map(|info| info.frames).collect();
        let trainer = fit_of(&library.library, uses, y, lengths, library.pose_weight(), max_iterations)
            .map_err(|reason| DatasetError::from_training(reason, &sequences))?;
        Ok(Self { trainer, library: library.clone(), uses: uses.to_vec(), sequences })
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        self.trainer.step()
    }

    /// Fits to the end.
    pub fn run(&mut self) -> Progress {
        self.run_with(|_| ControlFlow::Continue(()))
    }

    /// Fits to the end, or until `watch`, which is called after every iteration, breaks.
    pub fn run_with(&mut self, watch: impl FnMut(&Progress) -> ControlFlow<()>) -> Progress {
        run_with(|| self.trainer.step(), watch)
    }

    /// How far the fit is. The bound is that of the clips under the stored primitives.
    pub fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    /// The couplings of the best bound so far [M x M].
    pub fn alpha(&self) -> DMatrix<f64> {
        self.trainer.best().alpha.swap_remove(0)
    }

    /// The library with the combination under the best couplings so far as its last movement, which has this
    /// name and starts where the clips do. It replaces a combination of the same name.
    ///
    /// # Errors
    ///
    /// When a learned movement has the name.
    pub fn finish(&self, name: &str) -> Result<TrainedLibrary, CombinationError> {
        let mut library = self.library.clone();
        library.add(fitted_movement(&self.trainer, &self.uses, name), self.sequences.clone())?;
        Ok(library)
    }
}

/// A fit to the observations `y` [N x D_i] of each part, centred by the means of the library's columns and
/// stacked by the `lengths` of the sequences.
pub(super) fn fit_of(
    library: &Library,
    uses: &[usize],
    y: Vec<DMatrix<f64>>,
    lengths: Vec<usize>,
    pose_weight: PoseWeight,
    max_iterations: usize,
) -> Result<VariationalTrainer, TrainingError> {
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
        parts: library.starting_parts(&y, &sequences),
        experts: library.expert_parameters(uses),
        alpha: vec![library.couplings_of_sources(uses)],
    };
    let settings = library.training_settings(&start.experts, pose_weight, max_iterations);
    let fixed = library.fixed_outputs(uses)?;
    let objective = Objective::new(y, sequences, library.jitter).under(fixed);
    VariationalTrainer::from_start(objective, start, phases(max_iterations), &settings, 0)
}

/// The combination with the best couplings of a fit so far, as a movement of this name. It has no sums,
/// because the primitives learned nothing from the new frames.
pub(super) fn fitted_movement(trainer: &VariationalTrainer, uses: &[usize], name: &str) -> LearnedMovement {
    let (mut best, progress) = (trainer.best(), trainer.progress());
    let objective = trainer.objective();
    let starts = objective.sequences().ranges().map(|range| best.latent_means(&range)).collect();
    LearnedMovement {
        name: name.to_owned(),
        uses: uses.to_vec(),
        alpha: best.alpha.swap_remove(0),
        sums: None,
        starts,
        couplings: CouplingsFrom::Clips {
            bound: trainer.best_terms().total(),
            iterations: progress.iteration,
        },
        rollout_rounds: 0,
    }
}

fn phases(max_iterations: usize) -> Vec<Phase> {
    use Group::{Couplings, Latents};
    let first = Phase { groups: &[Latents], iterations: max_iterations / LATENTS_FIRST };
    vec![first, Phase { groups: &[Latents, Couplings], iterations: max_iterations }]
}
