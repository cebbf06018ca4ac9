//! Starting point of an import.

use crate::models::library::TrainedLibrary;
use crate::models::library::import::request::{ImportError, ImportRequest, ImportedMovement};
use crate::models::training::error::TrainingError;
use crate::models::training::latents::{check_training, starting_couplings};
use crate::models::variational::{
    Objective, Params, Repertoire, VariationalTrainer, schedule, starting_experts,
};
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// The training before its first iteration. Its latents are those of the host whose poses are nearest to the
/// frames; pose maps and companions are fixed.
pub(super) fn starting_trainer(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    companions: &[usize],
    movements: &[ImportedMovement],
    y: Vec<DMatrix<f64>>,
    lengths: Vec<usize>,
    request: &ImportRequest,
) -> Result<VariationalTrainer, ImportError> {
    let library = &host.library;
    let sequences = check_training(&y, lengths, library.largest_latent(), library.order)?;
    let parts_of = |a: &usize| library.primitives[*a].part;
    let new = donor.library.primitives.iter().map(|primitive| primitive.part);
    let primitives: Vec<usize> = companions.iter().map(parts_of).chain(new).collect();
    let uses = movements.iter().map(|movement| (movement.sequences.len(), movement.uses.clone())).collect();
    let repertoire =
        Repertoire::new(sequences, y.len(), primitives.clone(), uses).map_err(TrainingError::Repertoire)?;
    let parts = library.starting_parts(&y, repertoire.sequences());
    let mut rng = ChaCha8Rng::seed_from_u64(u64::from(request.seed));
    let mut experts = library.expert_parameters(companions);
    for primitive in &donor.library.primitives {
        let counts: Vec<usize> = primitive.experts.iter().map(|e| e.fitted.z().nrows()).collect();
        let x = &parts[primitive.part].latents.mean;
        experts.push(starting_experts(experts.len(), &repertoire, x, &counts, &mut rng));
    }
    let alpha = vec![starting_couplings(y.len()); movements.len()];
    let start = Params { parts, experts, alpha };
    let new = &start.experts[companions.len()..];
    let settings = library.training_settings(new, host.pose_weight(), request.max_iterations);
    let mut fixed = start.zeros_like();
    for part in &mut fixed.parts {
        part.r.fill(1.0);
        part.kernel.lambda.fill(1.0);
        (part.kernel.variance, part.beta) = (1.0, 1.0);
    }
    for expert in fixed.experts[..companions.len()].iter_mut().flatten() {
        expert.z.fill(1.0);
        expert.kernel.lambda.fill(1.0);
    }
    let outputs = library.fixed_outputs(companions)?;
    let objective = Objective::of_movements(y, repertoire, library.jitter).under(outputs);
    let phases = schedule(request.max_iterations);
    let mut trainer = VariationalTrainer::from_start(objective, start, phases, &settings, request.seed)?;
    trainer.fix_parameters(&fixed);
    Ok(trainer)
}
