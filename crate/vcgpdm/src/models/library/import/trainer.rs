//! The training of primitives that are learned again.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, block_diagonal, stacked, symmetric};
use crate::models::data::dataset::DatasetError;
use crate::models::data::sequence_info::SequenceInfo;
use crate::models::fitted::provenance::Provenance;
use crate::models::library::coupling::MOST_ITERATIONS;
use crate::models::library::import::frames::{of_clips, shown};
use crate::models::library::import::request::{ImportError, ImportFrames, ImportRequest, Planned};
use crate::models::library::import::start::trainer;
use crate::models::library::known::Known;
use crate::models::library::{
    CombinationError, CouplingsFrom, LearnedMovement, LibraryExpert, ObservedClip, Origin, Primitive,
    Relearned, TrainedLibrary,
};
use crate::models::training::error::in_range;
use crate::models::training::progress::Progress;
use crate::models::training::trainer::run_with;
use crate::models::variational::{FittedExpert, VariationalTrainer, expert_offsets, stack_offsets};
use nalgebra::DMatrix;
use std::ops::ControlFlow;

/// A primitive that is learned again.
struct Arriving {
    name: String,
    part: usize,
    relearned: Relearned,
}

/// An import under way.
pub struct ImportTrainer {
    trainer: VariationalTrainer,
    host: TrainedLibrary,
    /// The primitives of this library that take part: the first of the training.
    companions: Vec<usize>,
    arriving: Vec<Arriving>,
    movements: Vec<Planned>,
    sequences: Vec<SequenceInfo>,
    note: Option<String>,
}

impl ImportTrainer {
    /// Ready to learn all primitives of `donor` again, in the latent spaces of `host`.
    ///
    /// # Errors
    ///
    /// When the bodies or their parts differ, a primitive has no frames to learn from, what stands in for
    /// other parts does not fit them, or the bound cannot be computed at the start.
    pub fn new(
        host: &TrainedLibrary,
        donor: &TrainedLibrary,
        frames: ImportFrames,
        request: &ImportRequest,
    ) -> Result<Self, ImportError> {
        host.check_body(donor)?;
        check_companions(host, &request.companions)?;
        in_range("the number of iterations", request.max_iterations, MOST_ITERATIONS)?;
        let shown = match frames {
            ImportFrames::Clips(clips) => vec![of_clips(donor, clips)?],
            ImportFrames::Remembered | ImportFrames::Generated => shown(host, donor, frames.from())?,
        };
        let is_shown = |a: usize| shown.iter().any(|movement| movement.uses.contains(&Some(a)));
        if !(0..donor.library.primitives.len()).all(is_shown) {
            return Err(ImportError::NoFrames);
        }
        let mut companions: Vec<usize> = Vec::new();
        for movement in &shown {
            for (part, companion) in request.companions.iter().enumerate() {
                if movement.uses[part].is_none() {
                    let part = || host.body.layout.parts()[part].name.clone();
                    companions.push(companion.ok_or_else(|| ImportError::NoCompanion { part: part() })?);
                }
            }
        }
        companions.sort_unstable();
        companions.dedup();
        let place = |(own, companion): (&Option<usize>, &Option<usize>)| match own {
            Some(a) => companions.len() + a,
            None => companions.iter().position(|known| Some(known) == companion.as_ref()).unwrap_or_default(),
        };
        let mut movements: Vec<Planned> = Vec::new();
        for movement in &shown {
            let first = movements.last().map_or(0, |before| before.which.end);
            let uses = movement.uses.iter().zip(&request.companions).map(place).collect();
            movements.push(Planned {
                name: movement.name.clone(),
                which: first..first + movement.clips.len(),
                uses,
            });
        }
        let clips: Vec<&ObservedClip> = shown.iter().flat_map(|movement| &movement.clips).collect();
        let y = (0..host.library.part_count())
            .map(|part| stacked(clips.iter().map(|clip| &clip.y[part])))
            .collect();
        let sequences: Vec<SequenceInfo> = clips.iter().map(|clip| clip.info.clone()).collect();
        let lengths = sequences.iter().map(|info| info.frames).collect();
        let trainer = trainer(host, donor, &companions, &movements, y, lengths, request);
        let trainer = trainer.map_err(|error| match error {
            ImportError::Training(reason) => DatasetError::about(reason, &sequences).into(),
            error => error,
        })?;
        let primitives = donor.library.primitives.iter().enumerate();
        let arriving = primitives.map(|(a, primitive)| Arriving {
            name: primitive.name.clone(),
            part: primitive.part,
            relearned: Relearned {
                primitive: primitive.name.clone(),
                clips: donor.origin(a).clips,
                frames: frames.from(),
            },
        });
        let arriving = arriving.collect();
        let note = donor.provenance.note.clone();
        Ok(Self { trainer, host: host.clone(), companions, arriving, movements, sequences, note })
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

    /// How far the import is. The bound is that of the frames under what stays.
    pub fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    /// How much of what the frames show of each part the pose maps of this library do not reproduce at the
    /// best latents so far `[M]`: the squared distance of their columns from the frames' over that of the
    /// frames from the library's mean pose. 0: nothing is lost; 1: the mean pose would do as well. No
    /// dynamics can bring it back.
    pub fn lost(&self) -> Vec<f64> {
        let (objective, best) = (self.trainer.objective(), self.trainer.best());
        let parts = objective.observations().iter().zip(&best.parts).zip(&self.host.library.parts);
        let lost = parts.map(|((y, part), map)| {
            let missed = (y - map.observations(&part.latents.mean)).norm_squared();
            missed / y.norm_squared().max(f64::MIN_POSITIVE)
        });
        lost.collect()
    }

    /// The library with the primitives as they are at the best bound so far, and the movements that they were
    /// learned from.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn finish(&self) -> Result<TrainedLibrary, NumericsError> {
        let mut library = self.host.clone();
        let first = library.library.primitives.len();
        let (best, objective) = (self.trainer.best(), self.trainer.objective());
        let sums = objective.posteriors(&best)?.sums;
        let whole = |movement: &Planned| movement.uses.iter().all(|a| *a >= self.companions.len());
        let mut experts: Vec<Vec<LibraryExpert>> = self.arriving.iter().map(|_| Vec::new()).collect();
        for i in 0..best.part_count() {
            let offsets = expert_offsets(&best, i);
            let latent = best.parts[i].latents.mean.ncols();
            // What the rows say, and what those say that no movement of the library will hold.
            let height = offsets[offsets.len() - 1];
            let (mut all, mut elsewhere) = (Known::nothing(height, latent), Known::nothing(height, latent));
            for ((movement, alpha), sums) in self.movements.iter().zip(&best.alpha).zip(&sums) {
                let places: Vec<_> = movement.uses.iter().map(|a| offsets[*a]..offsets[*a + 1]).collect();
                all.add(&sums[i], alpha.column(i).as_slice(), &places);
                if !whole(movement) {
                    elsewhere.add(&sums[i], alpha.column(i).as_slice(), &places);
                }
            }
            let kept = self.host.library.kept(i, &self.companions)?;
            let (all, elsewhere) = (all.beside(kept.coefficients()), elsewhere.beside(kept.coefficients()));
            let jitter = self.host.library.jitter;
            let new = best.experts[self.companions.len()..].iter().map(|row| &row[i]);
            let blocks: Vec<_> = new.clone().map(|e| e.kernel.inducing_covariance(&e.z, jitter)).collect();
            let k = block_diagonal(&blocks);
            let a = Factor::new(
                &(&k + &all.precision),
                "covariance of the data at the dynamics inducing points",
            )?;
            let (mean, covariance) = (&k * a.solve(&all.b), symmetric(&k * a.solve(&k)));
            let own = stack_offsets(blocks.iter().map(DMatrix::nrows));
            for (place, (expert, into)) in new.zip(&mut experts).enumerate() {
                let (at, points) = (own[place], expert.z.nrows());
                let used: Vec<usize> = (at..at + points).collect();
                let rest: Vec<usize> = (0..k.nrows()).filter(|row| !used.contains(row)).collect();
                let mean = mean.rows(at, points).into_owned();
                into.push(LibraryExpert {
                    fitted: FittedExpert::new(expert.z.clone(), expert.kernel.clone(), mean, jitter)?,
                    covariance: symmetric(covariance.view((at, at), (points, points)).into_owned()),
                    elsewhere: elsewhere.about(&used, &rest, || k.clone())?.kept(),
                });
            }
        }
        for ((place, arriving), experts) in self.arriving.iter().enumerate().zip(experts) {
            let name = library.free_name(arriving.part, &arriving.name);
            let origin = Some(Box::new(self.origin(place)));
            let (part, excerpts) = (arriving.part, Vec::new());
            library.library.primitives.push(Primitive { name, part, experts, origin, excerpts });
        }
        let ranges: Vec<_> = objective.sequences().ranges().collect();
        for ((movement, alpha), sums) in self.movements.iter().zip(&best.alpha).zip(sums) {
            let place = |a: &usize| match a.checked_sub(self.companions.len()) {
                Some(new) => first + new,
                None => self.companions[*a],
            };
            let starts =
                ranges[movement.which.clone()].iter().map(|range| best.latent_means(range)).collect();
            let learned = LearnedMovement {
                name: library.free_movement_name(&movement.name),
                uses: movement.uses.iter().map(place).collect(),
                alpha: alpha.clone(),
                sums: whole(movement).then_some(sums),
                starts,
                couplings: CouplingsFrom::Training,
            };
            library.library.movements.push(learned);
            library.body.sequences.extend_from_slice(&self.sequences[movement.which.clone()]);
        }
        Ok(library)
    }

    /// Where the new primitive of this place comes from.
    fn origin(&self, place: usize) -> Origin {
        let used = self.companions.len() + place;
        let using = self.movements.iter().filter(|movement| movement.uses.contains(&used));
        let training = self.trainer.provenance(self.host.provenance.frames_per_second);
        Origin {
            training: Provenance { note: self.note.clone(), ..training },
            clips: using.flat_map(|movement| self.sequences[movement.which.clone()].to_vec()).collect(),
            relearned: Some(self.arriving[place].relearned.clone()),
        }
    }
}

/// Checks that what stands in for a part is a primitive of it.
fn check_companions(host: &TrainedLibrary, companions: &[Option<usize>]) -> Result<(), CombinationError> {
    let expected = host.library.part_count();
    if companions.len() != expected {
        return Err(CombinationError::Count { expected, found: companions.len() });
    }
    let wrong = |(part, found): (usize, &Option<usize>)| {
        let found = (*found)?;
        let known = host.library.primitives.get(found);
        known.is_none_or(|primitive| primitive.part != part).then_some((part, found))
    };
    match companions.iter().enumerate().find_map(wrong) {
        Some((part, found)) => Err(CombinationError::Primitive { part, found }),
        None => Ok(()),
    }
}
