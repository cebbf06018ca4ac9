//! Random problems for tests, of the shapes of the golden cases.

use crate::gp::{Gaussians, Kernel};
use crate::models::data::sequences::Sequences;
use crate::models::variational::elbo::Objective;
use crate::models::variational::model::Vcgpdm;
use crate::models::variational::params::{Expert, Params, PartParams};
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal, Uniform};

/// Parameters and an objective: 1, 2, 2 or 3 parts, order 2, 2, 1 or 2.
pub fn random_case(seed: u64) -> (Params, Objective) {
    type Shape = (Vec<usize>, Vec<usize>, Vec<usize>, usize, Vec<usize>, usize);
    let (q, d, l, k, lengths, order): Shape = match seed % 4 {
        0 => (vec![2], vec![5], vec![5], 4, vec![12], 2),
        1 => (vec![2, 3], vec![4, 6], vec![5, 6], 5, vec![11, 8], 2),
        2 => (vec![2, 1], vec![3, 3], vec![4, 4], 4, vec![14], 1),
        _ => (vec![1, 2, 2], vec![3, 4, 2], vec![4, 5, 4], 4, vec![9, 7, 6], 2),
    };
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let n: usize = lengths.iter().sum();
    let mut normal = |rows: usize, columns: usize, scale: f64| {
        DMatrix::from_fn(rows, columns, |_, _| {
            let value: f64 = StandardNormal.sample(&mut rng);
            scale * value
        })
    };
    let mut rng2 = ChaCha8Rng::seed_from_u64(seed + 1000);
    let mut uniform = |low: f64, high: f64| Uniform::new(low, high).unwrap().sample(&mut rng2);
    let parts = (0..q.len())
        .map(|i| PartParams {
            latents: Gaussians {
                mean: normal(n, q[i], 1.0),
                variance: DMatrix::from_fn(n, q[i], |_, _| uniform(0.01, 0.3)),
            },
            r: normal(l[i], q[i], 1.3),
            kernel: Kernel {
                lambda: DVector::from_fn(q[i], |_, _| uniform(0.5, 2.0)),
                variance: uniform(0.6, 1.6),
            },
            beta: uniform(0.05, 0.4),
        })
        .collect();
    let experts = q.iter().map(|&qj| {
        let expert = |_| Expert {
            z: normal(k, order * qj, 1.2),
            kernel: Kernel { lambda: DVector::from_fn(order * qj, |_, _| uniform(0.7, 3.0)), variance: 1.0 },
        };
        q.iter().map(expert).collect()
    });
    let experts = experts.collect();
    let alpha = DMatrix::from_fn(q.len(), q.len(), |_, _| uniform(0.02, 1.5));
    let y = d.iter().map(|&d| normal(n, d, 1.0)).collect();
    let objective = Objective::new(y, Sequences::new(lengths, order).unwrap(), 0.0);
    (Params { parts, experts, alpha: vec![alpha] }, objective)
}

/// The model fitted to the random problem of this seed.
pub fn fitted(seed: u64) -> Vcgpdm {
    let (params, objective) = random_case(seed);
    let terms = objective.terms(&params).unwrap();
    Vcgpdm::at_optimum(&objective, &params, terms).unwrap()
}
