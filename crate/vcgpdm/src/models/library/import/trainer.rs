//! Trainings of imports.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, block_diagonal, symmetric};
use crate::gp::tall::product;
use crate::models::data::dataset::DatasetError;
use crate::models::data::sequence_info::SequenceInfo;
use crate::models::fitted::provenance::Provenance;
use crate::models::library::coupling_trainer::MOST_ITERATIONS;
use crate::models::library::import::frames::{DonorMovement, clip_movement, stored_movements};
use crate::models::library::import::request::{ImportError, ImportFrames, ImportRequest, ImportedMovement};
use crate::models::library::import::start::starting_trainer;
use crate::models::library::information::Information;
use crate::models::library::{
    CombinationError, CouplingsFrom, LearnedMovement, LibraryExpert, Origin, Primitive, Relearned,
    TrainedLibrary,
};
use crate::models::training::error::in_range;
use crate::models::training::progress::Progress;
use crate::models::training::trainer::run_with;
use crate::models::variational::{FittedExpert, VariationalTrainer, expert_offsets, stack_offsets};
use nalgebra::DMatrix;
use std::ops::ControlFlow;

/// A primitive that is learned again.
struct NewPrimitive {
    name: String,
    part: usize,
    relearned: Relearned,
}

/// A training of an import.
pub struct ImportTrainer {
    trainer: VariationalTrainer,
    host: TrainedLibrary,
    /// The primitives of the host that are used: the first of the training.
    companions: Vec<usize>,
    new_primitives: Vec<NewPrimitive>,
    movements: Vec<ImportedMovement>,
    sequences: Vec<SequenceInfo>,
    note: Option<String>,
}

impl ImportTrainer {
    /// A training of all primitives of `donor` under the pose maps of `host`, before its first iteration.
    ///
    /// # Errors
    ///
    /// When the bodies or their parts differ, a primitive has no frames to learn from, a companion is missing
    /// or does not belong to its part, or the bound cannot be computed at the start.
    pub fn new(
        host: &TrainedLibrary,
        donor: &TrainedLibrary,
        frames: ImportFrames,
        request: &ImportRequest,
    ) -> Result<Self, ImportError> {
        host.check_body(donor)?;
        check_companions(host, &request.companions)?;
        in_range("the number of iterations", request.max_iterations, MOST_ITERATIONS)?;
        let donor_movements = match frames {
            ImportFrames::Clips(clips) => vec![clip_movement(donor, clips)?],
            ImportFrames::Remembered | ImportFrames::Generated => {
                stored_movements(host, donor, frames.source())?
            }
        };
        let has_frames = |a: usize| donor_movements.iter().any(|movement| movement.uses.contains(&Some(a)));
        if !(0..donor.library.primitives.len()).all(has_frames) {
            return Err(ImportError::NoFrames);
        }
        let companions = used_companions(host, &donor_movements, &request.companions)?;
        let place = |(own, companion): (&Option<usize>, &Option<usize>)| match own {
            Some(a) => companions.len() + a,
            None => companions.iter().position(|a| Some(a) == companion.as_ref()).unwrap_or_default(),
        };
        let mut movements: Vec<ImportedMovement> = Vec::new();
        for movement in &donor_movements {
            let first = movements.last().map_or(0, |before| before.sequences.end);
            let uses = movement.uses.iter().zip(&request.companions).map(place).collect();
            movements.push(ImportedMovement {
                name: movement.name.clone(),
                sequences: first..first + movement.clips.len(),
                uses,
            });
        }
        let clips = donor_movements.iter().flat_map(|movement| &movement.clips);
        let (y, sequences) = host.library.stack_clips(clips);
        let lengths = sequences.iter().map(|info| info.frames).collect();
        let trainer = starting_trainer(host, donor, &companions, &movements, y, lengths, request);
        let trainer = trainer.map_err(|error| match error {
            ImportError::Training(reason) => DatasetError::from_training(reason, &sequences).into(),
            error => error,
        })?;
        let primitives = donor.library.primitives.iter().enumerate();
        let new_primitives = primitives.map(|(a, primitive)| NewPrimitive {
            name: primitive.name.clone(),
            part: primitive.part,
            relearned: Relearned {
                primitive: primitive.name.clone(),
                clips: donor.origin(a).clips,
                frames: frames.source(),
            },
        });
        let new_primitives = new_primitives.collect();
        let note = donor.provenance.note.clone();
        Ok(Self { trainer, host: host.clone(), companions, new_primitives, movements, sequences, note })
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        self.trainer.step()
    }

    /// Trains to the end.
    pub fn run(&mut self) -> Progress {
        self.run_with(|_| ControlFlow::Continue(()))
    }

    /// Trains to the end, or until `watch`, which is called after every iteration, breaks.
    pub fn run_with(&mut self, watch: impl FnMut(&Progress) -> ControlFlow<()>) -> Progress {
        run_with(|| self.trainer.step(), watch)
    }

    /// How far the import is. The bound is that of the frames under the fixed maps.
    pub fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    /// The share of each part's motion that the pose maps of the host cannot reproduce, at the best latents
    /// so far `[M]`: the squared distance of their columns from the frames, divided by that of the mean pose.
    /// 0: nothing is lost; 1: the mean pose is as good.
    pub fn lost(&self) -> Vec<f64> {
        let (objective, best) = (self.trainer.objective(), self.trainer.best());
        let parts = objective.observations().iter().zip(&best.parts).zip(&self.host.library.parts);
        let lost = parts.map(|((y, part), map)| {
            let error = (y - map.observations(&part.latents.mean)).norm_squared();
            error / y.norm_squared().max(f64::MIN_POSITIVE)
        });
        lost.collect()
    }

    /// The host with the new primitives of the best bound so far, and the movements that they learned from.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn finish(&self) -> Result<TrainedLibrary, NumericsError> {
        let mut library = self.host.clone();
        let first = library.library.primitives.len();
        let (best, objective) = (self.trainer.best(), self.trainer.objective());
        let sums = objective.posteriors(&best)?.sums;
        let whole = |movement: &ImportedMovement| movement.uses.iter().all(|a| *a >= self.companions.len());
        let mut experts: Vec<Vec<LibraryExpert>> = self.new_primitives.iter().map(|_| Vec::new()).collect();
        for i in 0..best.part_count() {
            let offsets = expert_offsets(&best, i);
            let latent = best.parts[i].latents.mean.ncols();
            // From all rows, and from those that are in no movement of the new library.
            let height = offsets[offsets.len() - 1];
            let (mut all, mut external) =
                (Information::zeros(height, latent), Information::zeros(height, latent));
            for ((movement, alpha), sums) in self.movements.iter().zip(&best.alpha).zip(&sums) {
                let places: Vec<_> = movement.uses.iter().map(|a| offsets[*a]..offsets[*a + 1]).collect();
                all.add(&sums[i], alpha.column(i).as_slice(), &places);
                if !whole(movement) {
                    external.add(&sums[i], alpha.column(i).as_slice(), &places);
                }
            }
            let fixed = self.host.library.fixed_dynamics_outputs(i, &self.companions)?;
            let fixed = fixed.coefficients();
            let (all, external) = (all.given_first(fixed), external.given_first(fixed));
            let jitter = self.host.library.jitter;
            let new = best.experts[self.companions.len()..].iter().map(|row| &row[i]);
            let blocks: Vec<_> = new.clone().map(|e| e.kernel.inducing_covariance(&e.z, jitter)).collect();
            let k = block_diagonal(&blocks);
            let a = Factor::new(
                &(&k + &all.precision),
                "covariance of the data at the dynamics inducing points",
            )?;
            let (mean, covariance) = (product(&k, &a.solve(&all.b)), symmetric(product(&k, &a.solve(&k))));
            let own = stack_offsets(blocks.iter().map(DMatrix::nrows));
            for (place, (expert, into)) in new.zip(&mut experts).enumerate() {
                let (at, points) = (own[place], expert.z.nrows());
                let used: Vec<usize> = (at..at + points).collect();
                let others: Vec<usize> = (0..k.nrows()).filter(|row| !used.contains(row)).collect();
                let mean = mean.rows(at, points).into_owned();
                into.push(LibraryExpert {
                    fitted: FittedExpert::new(expert.z.clone(), expert.kernel.clone(), mean, jitter)?,
                    covariance: symmetric(covariance.view((at, at), (points, points)).into_owned()),
                    external: external.marginal(&used, &others, || k.clone())?.nonzero(),
                });
            }
        }
        for ((place, new), experts) in self.new_primitives.iter().enumerate().zip(experts) {
            let name = library.unused_name(new.part, &new.name);
            let origin = Some(Box::new(self.origin(place)));
            let (part, excerpts) = (new.part, Vec::new());
            library.library.primitives.push(Primitive { name, part, experts, origin, excerpts });
        }
        let ranges: Vec<_> = objective.sequences().ranges().collect();
        for ((movement, alpha), sums) in self.movements.iter().zip(&best.alpha).zip(sums) {
            let place = |a: &usize| match a.checked_sub(self.companions.len()) {
                Some(new) => first + new,
                None => self.companions[*a],
            };
            let starts =
                ranges[movement.sequences.clone()].iter().map(|range| best.latent_means(range)).collect();
            let learned = LearnedMovement {
                name: library.unused_movement_name(&movement.name),
                uses: movement.uses.iter().map(place).collect(),
                alpha: alpha.clone(),
                sums: whole(movement).then_some(sums),
                starts,
                couplings: CouplingsFrom::Training,
                rollout_rounds: 0,
            };
            library.library.movements.push(learned);
            library.body.sequences.extend_from_slice(&self.sequences[movement.sequences.clone()]);
        }
        Ok(library)
    }

    /// The origin of the new primitive at this place.
    fn origin(&self, place: usize) -> Origin {
        let used = self.companions.len() + place;
        let using = self.movements.iter().filter(|movement| movement.uses.contains(&used));
        let training = self.trainer.provenance(self.host.provenance.frames_per_second);
        Origin {
            training: Provenance { note: self.note.clone(), ..training },
            clips: using.flat_map(|movement| self.sequences[movement.sequences.clone()].to_vec()).collect(),
            relearned: Some(self.new_primitives[place].relearned.clone()),
        }
    }
}

/// The companions that the movements need, each once.
fn used_companions(
    host: &TrainedLibrary,
    movements: &[DonorMovement],
    companions: &[Option<usize>],
) -> Result<Vec<usize>, ImportError> {
    let mut used = Vec::new();
    for movement in movements {
        for (part, companion) in companions.iter().enumerate() {
            if movement.uses[part].is_none() {
                let part = || host.body.layout.parts()[part].name.clone();
                used.push(companion.ok_or_else(|| ImportError::NoCompanion { part: part() })?);
            }
        }
    }
    used.sort_unstable();
    used.dedup();
    Ok(used)
}

/// Checks that the companion of each part is one of its primitives.
fn check_companions(host: &TrainedLibrary, companions: &[Option<usize>]) -> Result<(), CombinationError> {
    let expected = host.library.part_count();
    if companions.len() != expected {
        return Err(CombinationError::Count { expected, found: companions.len() });
    }
    for (part, companion) in companions.iter().enumerate() {
        if let Some(companion) = companion {
            host.library.check_primitive(part, *companion)?;
        }
    }
    Ok(())
}
