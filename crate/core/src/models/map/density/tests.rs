use super::*;
use crate::models::map::params::MapPart;
use crate::models::search::parameters::Parameters;
use crate::models::variational::testing::random_case;
use approx::assert_relative_eq;

/// Random cases with the shapes of those of the vCGPDM: 1, 2, 2 or 3 parts, order 2, 2, 1 or 2. They are
/// balanced from seed 4 on; every third has linear terms.
pub fn random_map_case(seed: u64) -> (MapParams, LogDensity) {
    let (params, objective) = random_case(seed);
    let parts = params.parts.into_iter();
    let parts = parts.map(|p| MapPart { latents: p.latents.mean, kernel: p.kernel, beta: p.beta }).collect();
    let dynamics =
        params.experts.into_iter().map(|row| row.into_iter().map(|expert| expert.kernel).collect()).collect();
    let density =
        LogDensity::new(objective.observations().to_vec(), objective.sequences().clone(), seed % 8 > 3);
    let m = params.alpha[0].nrows();
    let linear = if seed % 3 == 1 {
        DMatrix::from_fn(m, m, |j, i| 0.2 + 0.3 * (j + 2 * i) as f64)
    } else {
        DMatrix::zeros(0, 0)
    };
    (MapParams { parts, dynamics, linear, alpha: params.alpha[0].clone() }, density)
}

/// Every entry of the gradient, in every block, by central differences on the flat vector.
#[test]
fn gradient_agrees_with_differences_in_every_block() {
    for seed in 0..8 {
        let (mut params, density) = random_map_case(seed);
        let (terms, gradient) = density.terms_and_gradient(&params).unwrap();
        assert_relative_eq!(terms.total(), density.terms(&params).unwrap().total(), max_relative = 1e-12);
        let mut analytic = Vec::new();
        gradient.flat_gradient_into(&params, &mut analytic);
        let flat = params.to_flat();
        let h = 1e-5;
        for k in 0..flat.len() {
            let mut at = |step: f64| {
                let mut moved = flat.clone();
                moved[k] += step;
                params.set_flat(&moved);
                density.terms(&params).unwrap().total()
            };
            let difference = (at(h) - at(-h)) / (2.0 * h);
            assert_relative_eq!(analytic[k], difference, epsilon = 1e-5, max_relative = 1e-6);
        }
    }
}

/// The density by its formula, with inverses instead of factors.
#[test]
fn value_agrees_with_the_formula() {
    for seed in 0..8 {
        let (params, density) = random_map_case(seed);
        let gaussian = |c: DMatrix<f64>, t: &DMatrix<f64>| {
            let fit = (t.transpose() * c.clone().try_inverse().unwrap() * t).trace();
            -0.5 * (t.len() as f64 * TAU.ln() + t.ncols() as f64 * c.determinant().ln() + fit)
        };
        let order = density.sequences.order();
        let mut targets = Vec::new();
        for range in density.sequences.ranges() {
            targets.extend(range.start + order..range.end);
        }
        let mut expected = 0.0;
        for (i, part) in params.parts.iter().enumerate() {
            let n = part.latents.nrows();
            let noise = DMatrix::identity(n, n) * part.beta;
            let k = part.kernel.cross_covariance(&part.latents, &part.latents) + noise;
            expected += gaussian(k, &density.y[i]);
            let combined = 1.0 / params.alpha.column(i).iter().map(|a| 1.0 / a).sum::<f64>();
            let x =
                DMatrix::from_fn(targets.len(), part.latents.ncols(), |r, q| part.latents[(targets[r], q)]);
            let mut c = DMatrix::identity(targets.len(), targets.len()) * combined;
            for (j, source) in params.parts.iter().enumerate() {
                let w = combined / params.alpha[(j, i)];
                let q = source.latents.ncols();
                let lambda = &params.dynamics[j][i].lambda;
                c += DMatrix::from_fn(targets.len(), targets.len(), |a, b| {
                    let before = |r: usize, d: usize| source.latents[(targets[r] - order + d / q, d % q)];
                    let d2: f64 =
                        (0..order * q).map(|d| (before(a, d) - before(b, d)).powi(2) / lambda[d]).sum();
                    let product: f64 = (0..order * q).map(|d| before(a, d) * before(b, d)).sum();
                    let theta = params.linear_term(j, i).unwrap_or(0.0);
                    w * w * ((-0.5 * d2).exp() + theta * product)
                });
            }
            let balance = density.y[i].ncols() as f64 / x.ncols() as f64;
            expected += gaussian(c, &x) * if density.balanced { balance } else { 1.0 };
            for t in (0..n).filter(|t| !targets.contains(t)) {
                expected -= 0.5 * part.latents.row(t).iter().map(|x| TAU.ln() + x * x).sum::<f64>();
            }
        }
        assert_relative_eq!(density.terms(&params).unwrap().total(), expected, max_relative = 1e-9);
    }
}
