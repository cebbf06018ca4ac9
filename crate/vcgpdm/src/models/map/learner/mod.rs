//! Training of MAP models.

use crate::gp::NumericsError;
use crate::models::flat::Group;
use crate::models::learner::{Learner, LearningProgress, MovementModel, Movements};
use crate::models::map::density::{LogDensity, MapTerms};
use crate::models::map::model::MapModel;
use crate::models::map::params::{MapParams, MapPart};
use crate::models::search::ascent::{Ascent, Phase, Target};
use crate::models::sequences::Sequences;
use crate::models::variational::trainer::{TrainingError, check_training};
use crate::models::variational::{TrainingSettings, starting_point};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Iterations before everything is optimised together, at most.
const BLOCK_ITERATIONS: usize = 50;
/// Standard deviation of what the seed adds to the latents at the start, which have unit variance.
const SPREAD: f64 = 0.01;

/// What training is asked to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapSettings {
    /// Latent dimensions Q of every part.
    pub latent: usize,
    /// Order p of the dynamics.
    pub order: usize,
    /// The seed of everything random.
    pub seed: u32,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
    /// The dynamics into each part weigh D_i / Q_i times as much (Urtasun, Fleet & Fua 2006); otherwise the latents are at the
    /// maximum of their posterior itself.
    pub balanced: bool,
}

impl Default for MapSettings {
    fn default() -> Self {
        let TrainingSettings { latent, order, seed, max_iterations, .. } = TrainingSettings::default();
        Self { latent, order, seed, max_iterations, balanced: false }
    }
}

/// The density with its last value.
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

    fn terms(&self) -> &MapTerms {
        &self.terms
    }

    fn gradient(&self) -> &MapParams {
        &self.gradient
    }
}

/// A training of a MAP GPDM (one part) or a MAP CGPDM under way.
pub struct MapLearner {
    ascent: Ascent<Evaluated>,
    settings: MapSettings,
}

impl MapLearner {
    /// Ready to train. A sequence that is not whole is a short one like any other.
    pub fn new(movements: Movements, settings: MapSettings) -> Result<Self, TrainingError> {
        let sequences = check_training(&movements.y, movements.lengths(), settings.latent, settings.order)?;
        let params = start(&movements, &sequences, &settings);
        let density = LogDensity::new(movements.y, sequences, settings.balanced);
        let terms = density.terms(&params)?;
        let start = (terms.total(), terms.clone());
        let target = Evaluated { density, terms, gradient: params.zeros_like() };
        let phases = vec![
            Phase {
                groups: &[Group::Kernels],
                iterations: BLOCK_ITERATIONS.min(settings.max_iterations / 8),
            },
            Phase { groups: &[Group::Latents, Group::Kernels], iterations: settings.max_iterations },
        ];
        let ascent = Ascent::new(target, params, start, phases, settings.max_iterations);
        Ok(Self { ascent, settings })
    }

    /// What training was asked to do.
    pub fn settings(&self) -> &MapSettings {
        &self.settings
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
    pub fn fitted(&self) -> Result<MapModel, NumericsError> {
        let search = self.ascent.search();
        MapModel::fit(&search.target.density, &search.best_parameters())
    }
}

/// Where the vCGPDM starts, without what is variational about it.
fn start(movements: &Movements, sequences: &Sequences, settings: &MapSettings) -> MapParams {
    let MapSettings { latent, order, seed, max_iterations, .. } = *settings;
    let variational = TrainingSettings { latent, order, seed, max_iterations, dynamics_ips: 1, pose_ips: 1 };
    let params = starting_point(&movements.y, sequences, &variational);
    let mut rng = ChaCha8Rng::seed_from_u64(u64::from(seed));
    let parts = params.parts.into_iter().map(|part| {
        let mut latents = part.latents.mean;
        for x in latents.iter_mut() {
            let noise: f64 = StandardNormal.sample(&mut rng);
            *x += SPREAD * noise;
        }
        MapPart { latents, kernel: part.kernel, beta: part.beta }
    });
    let experts = params.experts.into_iter();
    MapParams {
        parts: parts.collect(),
        dynamics: experts.map(|row| row.into_iter().map(|expert| expert.kernel).collect()).collect(),
        alpha: params.alpha,
    }
}

impl Learner for MapLearner {
    fn step(&mut self) -> LearningProgress {
        self.ascent.step();
        self.progress()
    }

    fn progress(&self) -> LearningProgress {
        self.ascent.progress("density")
    }

    fn model(&self) -> Result<Box<dyn MovementModel>, NumericsError> {
        Ok(Box::new(self.fitted()?))
    }
}

#[cfg(test)]
mod tests;
