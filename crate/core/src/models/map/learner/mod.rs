//! Trainings of MAP models.

use crate::gp::NumericsError;
use crate::models::data::movements::Movements;
use crate::models::data::sequences::Sequences;
use crate::models::errors::TrainingError;
use crate::models::map::density::{LogDensity, MapTerms};
use crate::models::map::model::MapModel;
use crate::models::map::params::{MapParams, MapPart};
use crate::models::search::ascent::{Ascent, Phase, SearchEnd, Target};
use crate::models::search::parameters::Group;
use crate::models::training::interface::Training;
use crate::models::training::latents::{
    check_training, principal_components, starting_couplings, starting_dynamics, starting_pose,
};
use crate::models::training::progress::{EndReason, Progress};
use crate::models::training::settings::MapSettings;
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// The most iterations of the first phase, in which the latents are fixed.
const BLOCK_ITERATIONS: usize = 50;
/// Starting variance of a linear term; that of the squared exponential is 1.
const START_LINEAR: f64 = 0.1;
/// Standard deviation of the noise that is added to the starting latents, which have unit variance.
const SPREAD: f64 = 0.01;

/// The density with its value at the last point.
struct Evaluated {
    density: LogDensity,
    terms: MapTerms,
    gradient: MapParams,
}

impl Target for Evaluated {
    type Parameters = MapParams;
    type Terms = MapTerms;

    fn compute(&mut self, at: &MapParams) -> Result<f64, NumericsError> {
        (self.terms, self.gradient) = self.density.terms_and_gradient(at)?;
        Ok(self.terms.total())
    }

    fn copy_terms(&self, into: &mut MapTerms) {
        into.clone_from(&self.terms);
    }

    fn gradient(&self) -> &MapParams {
        &self.gradient
    }
}

/// A training of a MAP GPDM (one part) or a MAP CGPDM.
pub struct MapLearner {
    ascent: Ascent<Evaluated>,
}

impl MapLearner {
    /// A training before its first iteration. A partial trial counts as a short sequence.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, or the model cannot learn from the movements.
    pub fn new(movements: Movements, settings: &MapSettings, seed: u32) -> Result<Self, TrainingError> {
        let sequences = check_training(&movements.y, movements.lengths(), settings.latent, settings.order)?;
        let params = starting_point(&movements, &sequences, settings, seed);
        let density = LogDensity::new(movements.y, sequences, settings.balanced);
        let terms = density.terms(&params)?;
        let start = (terms.total(), terms.clone());
        let target = Evaluated { density, terms, gradient: params.zeros_like() };
        let phases = vec![
            Phase {
                groups: &[Group::Couplings, Group::Kernels],
                iterations: BLOCK_ITERATIONS.min(settings.max_iterations / 8),
            },
            Phase {
                groups: &[Group::Latents, Group::Couplings, Group::Kernels],
                iterations: settings.max_iterations,
            },
        ];
        let ascent = Ascent::new(target, params, start, phases, settings.max_iterations);
        Ok(Self { ascent })
    }

    /// The parameters of the best density so far.
    pub fn best(&self) -> MapParams {
        self.ascent.search().best_parameters()
    }

    /// The terms of the best density so far.
    pub fn terms(&self) -> MapTerms {
        self.ascent.search().best_terms.clone()
    }

    /// Evaluations of the density with its gradient so far.
    pub fn evaluations(&self) -> usize {
        self.ascent.search().evaluations
    }

    /// The model of the best density so far.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn fitted(&self) -> Result<MapModel, NumericsError> {
        let search = self.ascent.search();
        MapModel::fit(&search.target.density, &search.best_parameters())
    }
}

/// Starting values as for a variational model, with a little noise on the latents. Without missing principal
/// components, this noise is all that depends on the seed.
fn starting_point(
    movements: &Movements,
    sequences: &Sequences,
    settings: &MapSettings,
    seed: u32,
) -> MapParams {
    let random = || ChaCha8Rng::seed_from_u64(u64::from(seed));
    let mut rng = random();
    let mut latents = Vec::with_capacity(movements.y.len());
    for y in &movements.y {
        latents.push(principal_components(y, settings.latent, &mut rng));
    }
    // A new generator, so that the noise does not depend on the numbers drawn before.
    let mut rng = random();
    let mut parts = Vec::with_capacity(movements.y.len());
    for (mut latents, y) in latents.into_iter().zip(&movements.y) {
        for x in latents.iter_mut() {
            let noise: f64 = StandardNormal.sample(&mut rng);
            *x += SPREAD * noise;
        }
        let (kernel, beta) = starting_pose(y, settings.latent);
        parts.push(MapPart { latents, kernel, beta });
    }
    let m = parts.len();
    let dynamics = vec![vec![starting_dynamics(settings.latent, sequences.order()); m]; m];
    let linear =
        if settings.linear { DMatrix::from_element(m, m, START_LINEAR) } else { DMatrix::zeros(0, 0) };
    MapParams { parts, dynamics, linear, alpha: starting_couplings(m) }
}

impl Training for MapLearner {
    fn step(&mut self) -> Progress {
        self.ascent.step();
        self.progress()
    }

    fn progress(&self) -> Progress {
        let (ascent, search) = (&self.ascent, self.ascent.search());
        Progress {
            iteration: ascent.iteration(),
            max_iterations: ascent.max_iterations(),
            evaluations: 0,
            setbacks: search.setbacks,
            objective: ascent.value(),
            best: search.best,
            terms: None,
            phase: None,
            done: ascent.reason().is_some(),
            reason: ascent.reason().map(|end| match end {
                SearchEnd::Settled => EndReason::DensitySettled,
                SearchEnd::Iterations => EndReason::Iterations,
            }),
            fraction: ascent.fraction(),
        }
    }
}

#[cfg(test)]
mod tests;
