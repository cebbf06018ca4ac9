//! Where an import begins.

use crate::models::library::TrainedLibrary;
use crate::models::library::import::request::{ImportError, ImportRequest, Planned};
use crate::models::training::error::TrainingError;
use crate::models::training::latents::{check_training, starting_couplings};
use crate::models::variational::{
    Objective, Params, Repertoire, VariationalTrainer, schedule, starting_experts,
};
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// The training, ready to begin: latents of the host nearest to the frames, its pose maps and companions
/// held.
pub(super) fn trainer(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    companions: &[usize],
    movements: &[Planned],
    y: Vec<DMatrix<f64>>,
    lengths: Vec<usize>,
    request: &ImportRequest,
) -> Result<VariationalTrainer, ImportError> {
    let library = &host.library;
    let sequences = check_training(&y, lengths, library.largest_latent(), library.order)?;
    let parts_of = |a: &usize| library.primitives[*a].part;
    let new = donor.library.primitives.iter().map(|primitive| primitive.part);
    let primitives: Vec<usize> = companions.iter().map(parts_of).chain(new).collect();
    let uses = movements.iter().map(|movement| (movement.which.len(), movement.uses.clone())).collect();
    let repertoire =
        Repertoire::new(sequences, y.len(), primitives.clone(), uses).map_err(TrainingError::Repertoire)?;
    let parts = library.parts_near(&y, repertoire.sequences());
    let mut rng = ChaCha8Rng::seed_from_u64(u64::from(request.seed));
    let mut experts = library.experts_of(companions);
    for primitive in &donor.library.primitives {
        let counts: Vec<usize> = primitive.experts.iter().map(|e| e.fitted.z().nrows()).collect();
        let x = &parts[primitive.part].latents.mean;
        experts.push(starting_experts(experts.len(), &repertoire, x, &counts, &mut rng));
    }
    let alpha = vec![starting_couplings(y.len()); movements.len()];
    let start = Params { parts, experts, alpha };
    let settings = library.settings_of(&start.experts[companions.len()..], request.max_iterations);
    let mut held = start.zeros_like();
    for part in &mut held.parts {
        part.r.fill(1.0);
        part.kernel.lambda.fill(1.0);
        (part.kernel.variance, part.beta) = (1.0, 1.0);
    }
    for expert in held.experts[..companions.len()].iter_mut().flatten() {
        expert.z.fill(1.0);
        expert.kernel.lambda.fill(1.0);
    }
    let stored = library.stored(companions)?;
    let objective = Objective::of_movements(y, repertoire, library.jitter).under(stored);
    let phases = schedule(request.max_iterations);
    let mut trainer = VariationalTrainer::from_start(objective, start, phases, &settings, request.seed)?;
    trainer.hold(&held);
    Ok(trainer)
}
