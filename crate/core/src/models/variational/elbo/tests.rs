use crate::models::search::parameters::Parameters;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::variational::elbo::Objective;
use crate::models::variational::params::Params;
use crate::models::variational::repertoire::Repertoire;
use crate::models::variational::testing::random_case;
use approx::assert_relative_eq;
use nalgebra::DMatrix;

/// Every entry of the gradient, in every block, by central differences on the flat vector.
fn check_gradient(mut params: Params, objective: &Objective, name: &str) {
    let (terms, gradient) = objective.terms_and_gradient(&params).unwrap();
    assert_relative_eq!(terms.total(), objective.terms(&params).unwrap().total(), max_relative = 1e-13);
    let mut analytic = Vec::new();
    gradient.flat_gradient_into(&params, &mut analytic);
    let flat = params.to_flat();
    let h = 1e-3;
    let scale = 1.0 + analytic.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
    for k in 0..flat.len() {
        let mut value = |step: f64| {
            let mut moved = flat.clone();
            moved[k] += step;
            params.set_flat(&moved);
            objective.value(&params, &objective.terms(&params).unwrap())
        };
        let difference = (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
        assert!(
            (analytic[k] - difference).abs() < 1e-7 * scale,
            "{name}, entry {k} ({:?}): {} against {difference}",
            params.flat_kinds()[k].group,
            analytic[k],
        );
    }
}

#[test]
fn gradient_agrees_with_differences_in_every_block() {
    for seed in 0..8 {
        let (params, objective) = random_case(seed);
        check_gradient(params, &objective, &format!("seed {seed}"));
    }
}

#[test]
fn gradient_with_weighted_pose_terms_agrees_with_differences() {
    for seed in 0..4 {
        for weight in [PoseWeight::Balanced, PoseWeight::Fixed(0.1)] {
            let (params, objective) = random_case(seed);
            check_gradient(params, &objective.weighted(weight), &format!("seed {seed}, {weight:?}"));
        }
    }
}

/// Two movements share the primitive of the first part. Under stored maps, only the new ones are optimal.
#[test]
fn weighted_gradient_of_libraries_agrees_with_differences() {
    let (mut params, objective) = random_case(1);
    let stored = objective.stored(&params).unwrap();
    let movements = vec![(1, vec![0, 1]), (1, vec![0, 2])];
    let repertoire = Repertoire::new(objective.sequences().clone(), 2, vec![0, 1, 1], movements).unwrap();
    let (y, jitter) = (objective.observations().to_vec(), objective.jitter());
    let library = Objective::of_movements(y, repertoire, jitter).weighted(PoseWeight::Balanced);
    let mut third = params.experts[1].clone();
    third.iter_mut().for_each(|expert| expert.z *= 0.8);
    params.experts.push(third);
    params.alpha.push(0.7 * &params.alpha[0]);
    check_gradient(params.clone(), &library, "library");
    check_gradient(params, &library.under(stored), "library under stored maps");
}

#[test]
fn an_expert_without_weight_does_not_change_the_bound() {
    // With a very large alpha the prediction of the second part about the first has no weight.
    let (mut params, objective) = random_case(1);
    params.alpha[0][(1, 0)] = 1e12;
    let before = objective.terms(&params).unwrap();
    params.experts[1][0].z *= 0.5;
    assert_relative_eq!(before.total(), objective.terms(&params).unwrap().total(), max_relative = 1e-10);
}

/// A weighted pose term at its optimal q(v): gamma times the expected log density of the columns under q(v),
/// minus gamma times the divergence of q(v) from its prior. The other terms are those of the bound.
#[test]
fn the_weighted_bound_agrees_with_its_uncollapsed_form() {
    for seed in 0..4 {
        let (params, objective) = random_case(seed);
        let terms = objective.terms(&params).unwrap();
        let under_stored = objective.clone().under(objective.stored(&params).unwrap());
        let expected = under_stored.terms(&params).unwrap().kinematics;
        let posteriors = objective.posteriors(&params).unwrap();
        let balanced = objective.clone().weighted(PoseWeight::Balanced);
        let mut direct = terms.dynamics.iter().sum::<f64>() + terms.initial + terms.entropy;
        for (i, (part, v)) in params.parts.iter().zip(&posteriors.kinematics).enumerate() {
            let k = part.kernel.inducing_covariance(&part.r, objective.jitter());
            let (prior, posterior) =
                (k.clone().cholesky().unwrap(), v.covariance.clone().cholesky().unwrap());
            let log_determinant = |l: &DMatrix<f64>| 2.0 * l.diagonal().map(f64::ln).sum();
            let each_column = prior.solve(&v.covariance).trace() - k.nrows() as f64
                + log_determinant(&prior.l())
                - log_determinant(&posterior.l());
            let columns = v.mean.ncols() as f64;
            let divergence = 0.5 * (columns * each_column + v.mean.dot(&prior.solve(&v.mean)));
            direct += part.r.ncols() as f64 / columns * (expected[i] - divergence);
        }
        assert_relative_eq!(balanced.value(&params, &terms), direct, max_relative = 1e-9);
        // The weight changes neither the terms nor q(v).
        assert_eq!(balanced.terms(&params).unwrap(), terms);
        let weighted = balanced.posteriors(&params).unwrap();
        for (a, b) in weighted.kinematics.iter().zip(&posteriors.kinematics) {
            assert_eq!((&a.mean, &a.covariance), (&b.mean, &b.covariance));
        }
    }
}

#[test]
fn the_weight_one_is_exactly_the_bound() {
    for seed in 0..4 {
        let (params, objective) = random_case(seed);
        let (terms, gradient) = objective.terms_and_gradient(&params).unwrap();
        assert_eq!(objective.value(&params, &terms), terms.total());
        let one = objective.weighted(PoseWeight::Fixed(1.0));
        assert_eq!(one.terms_and_gradient(&params).unwrap(), (terms, gradient));
    }
}
