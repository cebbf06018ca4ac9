use crate::models::training::parameters::Parameters;
use crate::models::variational::testing::random_case;
use approx::assert_relative_eq;

/// Every entry of the gradient, in every block, by central differences on the flat vector.
#[test]
fn gradient_agrees_with_differences_in_every_block() {
    for seed in 0..8 {
        let (mut params, objective) = random_case(seed);
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
                objective.terms(&params).unwrap().total()
            };
            let difference = (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
            assert!(
                (analytic[k] - difference).abs() < 1e-7 * scale,
                "seed {seed}, entry {k} ({:?}): {} against {difference}",
                params.flat_kinds()[k].group,
                analytic[k],
            );
        }
    }
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
