//! The statistics compared with integrals, and their adjoints with differences.

use super::*;
use crate::gp::lanes::{Level, levels};
use crate::gp::linalg::symmetric;
use crate::gp::{Gaussians, Kernel, KernelAdjoint};
use approx::assert_relative_eq;
use nalgebra::DMatrix;
use nalgebra::{DVector, dvector};
use proptest::prelude::*;

fn example(rows: usize, ips: usize, dims: usize, seed: f64) -> (Gaussians, DMatrix<f64>, Kernel) {
    let wave = |k: f64| (12.9898 * (k + seed)).sin() * 1.3;
    let x = Gaussians {
        mean: DMatrix::from_fn(rows, dims, |t, q| wave((t * 7 + q) as f64)),
        variance: DMatrix::from_fn(rows, dims, |t, q| 0.02 + 0.15 * wave((t + 31 * q) as f64).powi(2)),
    };
    let z = DMatrix::from_fn(ips, dims, |a, q| wave((a * 3 + q * 5 + 100) as f64));
    let kernel = Kernel { lambda: DVector::from_fn(dims, |q, _| 0.6 + 0.4 * q as f64), variance: 1.3 };
    (x, z, kernel)
}

fn psi_statistics(
    x: &Gaussians,
    z: &DMatrix<f64>,
    kernel: &Kernel,
    purpose: Purpose,
) -> (PsiStatistics, PairWorkspace) {
    let mut statistics = PsiStatistics::new(x.mean.nrows(), z.nrows(), z.ncols());
    let mut workspace = PairWorkspace::default();
    statistics.compute(x, z, kernel, purpose, &mut workspace);
    (statistics, workspace)
}

/// Gauss-Hermite nodes and weights for the standard normal, 24 points, by Newton's method on the Hermite
/// functions.
fn hermite() -> Vec<(f64, f64)> {
    let n = 24_usize;
    let polynomial = |x: f64| {
        let (mut previous, mut value) = (0.0, 1.0);
        for k in 0..n {
            let next = (x * value - (k as f64).sqrt() * previous) / ((k + 1) as f64).sqrt();
            (previous, value) = (value, next);
        }
        (value, previous)
    };
    let mut nodes: Vec<(f64, f64)> = Vec::new();
    let mut x = -10.0;
    let mut sign = polynomial(x).0.signum();
    while x < 10.0 {
        x += 1e-3;
        let (value, _) = polynomial(x);
        if value.signum() != sign {
            sign = value.signum();
            let mut root = x;
            for _ in 0..20 {
                let (value, previous) = polynomial(root);
                root -= value / ((n as f64).sqrt() * previous);
            }
            let previous = polynomial(root).1;
            nodes.push((root, 1.0 / (n as f64 * previous * previous)));
        }
    }
    assert_eq!(nodes.len(), n);
    nodes
}

#[test]
fn statistics_agree_with_quadrature() {
    let (x, z, kernel) = example(70, 4, 2, 0.3);
    let (statistics, _) = psi_statistics(&x, &z, &kernel, Purpose::Value);
    let nodes = hermite();
    let mut psi2 = DMatrix::zeros(4, 4);
    for t in 0..70 {
        let mut psi1 = DMatrix::zeros(1, 4);
        for (u, wu) in &nodes {
            for (v, wv) in &nodes {
                let point = DMatrix::from_row_slice(
                    1,
                    2,
                    &[
                        x.mean[(t, 0)] + u * x.variance[(t, 0)].sqrt(),
                        x.mean[(t, 1)] + v * x.variance[(t, 1)].sqrt(),
                    ],
                );
                let k = kernel.cross_covariance(&point, &z);
                psi2 += k.tr_mul(&k) * (wu * wv);
                psi1 += k * (wu * wv);
            }
        }
        assert_relative_eq!(statistics.psi1.rows(t, 1).into_owned(), psi1, epsilon = 1e-9);
    }
    assert_relative_eq!(statistics.psi2, psi2, epsilon = 1e-7);
    assert_relative_eq!(statistics.psi0, 70.0 * 1.3);
}

#[test]
fn without_variance_they_are_the_kernel() {
    let (mut x, z, kernel) = example(130, 5, 3, 0.7);
    x.variance.fill(0.0);
    let (statistics, _) = psi_statistics(&x, &z, &kernel, Purpose::Value);
    let k = kernel.cross_covariance(&x.mean, &z);
    assert_relative_eq!(statistics.psi1, k, epsilon = 1e-13);
    assert_relative_eq!(statistics.psi2, k.tr_mul(&k), epsilon = 1e-11);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    #[test]
    fn adjoints_agree_with_differences(
        rows in 1usize..140, ips in 1usize..6, dims in 1usize..8, seed in 0.0f64..10.0, cached in any::<bool>(),
    ) {
        let (x, z, kernel) = example(rows, ips, dims, seed);
        let g1 = DMatrix::from_fn(rows, ips, |t, a| ((t * 5 + a * 3) as f64).sin());
        let g2 = symmetric(DMatrix::from_fn(ips, ips, |a, b| ((a * 7 + b) as f64 + seed).cos()));
        let f = |x: &Gaussians, z: &DMatrix<f64>, kernel: &Kernel| {
            let (s, _) = psi_statistics(x, z, kernel, Purpose::Value);
            0.7 * s.psi0 + s.psi1.dot(&g1) + s.psi2.dot(&g2)
        };
        // Cached terms and terms that are computed again give the same adjoint.
        let purpose = if cached { Purpose::Gradient } else { Purpose::Value };
        let (mut statistics, mut workspace) = psi_statistics(&x, &z, &kernel, purpose);
        let mut dx = Gaussians::zeros(rows, dims);
        let mut dk = KernelAdjoint::zeros(ips, dims);
        let adjoint = PsiAdjoint { psi0: 0.7, psi1: &g1, psi2: &g2 };
        statistics.pull_back((&x, &z, &kernel), &adjoint, &mut workspace, &mut dx, &mut dk);
        let h = 1e-5;
        let close = |analytic: f64, up: f64, down: f64| {
            let difference = (up - down) / (2.0 * h);
            (analytic - difference).abs() < 2e-6 * (1.0 + difference.abs())
        };
        for q in 0..dims {
            for t in [0, rows / 2, rows - 1] {
                let (mut up, mut down) = (x.clone(), x.clone());
                up.mean[(t, q)] += h;
                down.mean[(t, q)] -= h;
                prop_assert!(close(dx.mean[(t, q)], f(&up, &z, &kernel), f(&down, &z, &kernel)));
                let (mut up, mut down) = (x.clone(), x.clone());
                up.variance[(t, q)] += h;
                down.variance[(t, q)] -= h;
                prop_assert!(close(dx.variance[(t, q)], f(&up, &z, &kernel), f(&down, &z, &kernel)));
            }
            for a in 0..ips {
                let (mut up, mut down) = (z.clone(), z.clone());
                up[(a, q)] += h;
                down[(a, q)] -= h;
                prop_assert!(close(dk.z[(a, q)], f(&x, &up, &kernel), f(&x, &down, &kernel)));
            }
            let (mut up, mut down) = (kernel.clone(), kernel.clone());
            up.lambda[q] += h;
            down.lambda[q] -= h;
            prop_assert!(close(dk.lambda[q], f(&x, &z, &up), f(&x, &z, &down)));
        }
        let (mut up, mut down) = (kernel.clone(), kernel.clone());
        up.variance += h;
        down.variance -= h;
        prop_assert!(close(dk.variance, f(&x, &z, &up), f(&x, &z, &down)));
    }

    #[test]
    fn a_row_far_away_adds_nothing(shift in 50.0f64..500.0) {
        let (mut x, z, kernel) = example(3, 4, 2, 0.1);
        let (mean, variance) = (x.mean.rows(0, 2).into_owned(), x.variance.rows(0, 2).into_owned());
        let (near, _) = psi_statistics(&Gaussians { mean, variance }, &z, &kernel, Purpose::Value);
        x.mean[(2, 0)] += shift;
        let (all, _) = psi_statistics(&x, &z, &kernel, Purpose::Value);
        prop_assert!((all.psi2 - near.psi2).amax() < 1e-12);
    }
}

#[test]
fn one_row_in_one_dimension_agrees_with_the_formula() {
    let x = Gaussians { mean: DMatrix::from_element(1, 1, 0.2), variance: DMatrix::from_element(1, 1, 0.5) };
    let kernel = Kernel { lambda: dvector![2.0], variance: 1.0 };
    let (s, _) = psi_statistics(&x, &DMatrix::from_element(1, 1, 1.2), &kernel, Purpose::Value);
    assert_relative_eq!(s.psi1[(0, 0)], (2.0f64 / 2.5).sqrt() * (-0.5f64 / 2.5).exp(), epsilon = 1e-14);
    assert_relative_eq!(s.psi2[(0, 0)], (2.0f64 / 3.0).sqrt() * (-1.0f64 / 3.0).exp(), epsilon = 1e-14);
}

/// A model does not depend on the processor that trained it.
#[test]
fn every_level_of_instructions_computes_the_same_bits() {
    for (rows, ips, dims) in [(150, 5, 3), (67, 4, 6), (9, 3, 1)] {
        let (x, z, kernel) = example(rows, ips, dims, 0.7);
        let bits = |level: Level| -> Vec<u64> {
            let mut psi = PsiStatistics::with_level(level, rows, ips, dims);
            let mut workspace = PairWorkspace::default();
            psi.compute(&x, &z, &kernel, Purpose::Gradient, &mut workspace);
            let (psi1, psi2) = (psi.psi1.clone(), psi.psi2.clone());
            let adjoint = PsiAdjoint { psi0: 0.3, psi1: &psi1, psi2: &psi2 };
            let mut into_x = Gaussians::zeros(rows, dims);
            let mut into = KernelAdjoint::zeros(ips, dims);
            psi.pull_back((&x, &z, &kernel), &adjoint, &mut workspace, &mut into_x, &mut into);
            let all = [&psi1, &psi2, &into_x.mean, &into_x.variance, &into.z];
            let values = all.iter().flat_map(|m| m.iter()).chain(into.lambda.iter()).chain([&into.variance]);
            values.map(|value| value.to_bits()).collect()
        };
        let expected = bits(Level::new());
        for level in levels() {
            assert_eq!(bits(level), expected, "{level:?}");
        }
    }
}
