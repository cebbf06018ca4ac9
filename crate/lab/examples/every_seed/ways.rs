//! Ways to train: where they start and what they do.

use nalgebra::{DMatrix, SymmetricEigen};
use vcgpdm::models::variational::{Params, schedule, starting_point};
use vcgpdm::models::{Group, Phase, Sequences, VariationalSettings};

/// A way to train: where it starts and what it does.
#[derive(Clone, Copy)]
pub struct Way {
    pub start: &'static str,
    pub schedule: &'static str,
    pub begin: fn(&[DMatrix<f64>], &Sequences, &VariationalSettings, u32) -> Params,
    pub phases: fn() -> Vec<Phase>,
}

/// Iterations after the blocks: with our one block of 25, those of the default.
pub const ITERATIONS: usize = 225;
const X: &[Group] = &[Group::Latents];
const K: &[Group] = &[Group::Couplings, Group::Kernels];
const IP: &[Group] = &[Group::InducingInputs];
const K_IP: &[Group] = &[Group::Couplings, Group::Kernels, Group::InducingInputs];
const ALL: &[Group] = &[Group::Latents, Group::Couplings, Group::Kernels, Group::InducingInputs];

fn phase(groups: &'static [Group], iterations: usize) -> Phase {
    Phase { groups, iterations }
}

pub const OURS: Way = Way {
    start: "ours",
    schedule: "ours: one block of 25, then jointly",
    begin: starting_point,
    phases: || schedule(ITERATIONS),
};

pub const OTHERS: [Way; 11] = [
    Way { start: "latents from columns as they are", begin: fast, ..OURS },
    Way { start: "latents twice as slow", begin: slower, ..OURS },
    Way { start: "pose maps straighter, lambda = 10", begin: straight, ..OURS },
    Way { start: "pose maps that bend, lambda = 1", begin: bent, ..OURS },
    Way { schedule: "jointly", phases: || vec![phase(ALL, ITERATIONS)], ..OURS },
    Way {
        schedule: "one block of 25, the latents alone for 20, then jointly",
        phases: || vec![phase(K_IP, 25), phase(X, 20), phase(ALL, ITERATIONS)],
        ..OURS
    },
    Way {
        schedule: "five blocks of 50, then jointly",
        phases: || [K_IP, X, K, IP, K, ALL].map(|groups| phase(groups, 50)).to_vec(),
        ..OURS
    },
    Way {
        start: "inducing inputs by k-means",
        begin: |y, s, t, seed| clustered(starting_point(y, s, t, seed), s, true),
        ..OURS
    },
    Way {
        start: "inducing inputs far apart",
        begin: |y, s, t, seed| clustered(starting_point(y, s, t, seed), s, false),
        ..OURS
    },
    Way {
        start: "the authors'",
        schedule: "jointly",
        begin: authors,
        phases: || vec![phase(ALL, ITERATIONS)],
    },
    Way {
        start: "the authors'",
        schedule: "the authors' blocks of 300",
        begin: authors,
        phases: || {
            let round = [X, K, IP, K].repeat(4);
            std::iter::once(K_IP).chain(round).map(|groups| phase(groups, 300)).collect()
        },
    },
];

/// Our start with the first principal components of the columns as they are, all of unit variance.
fn fast(y: &[DMatrix<f64>], sequences: &Sequences, settings: &VariationalSettings, seed: u32) -> Params {
    let unit = |x: &DMatrix<f64>, _: &DMatrix<f64>| vec![1.0; x.ncols()];
    with_latents(y, starting_point(y, sequences, settings, seed), sequences, |y| y.clone(), unit)
}

/// Our start with the principal components of columns that are smoothed twice as far, each of the variance
/// that its share in them asks for.
fn slower(y: &[DMatrix<f64>], sequences: &Sequences, settings: &VariationalSettings, seed: u32) -> Params {
    let shares = |x: &DMatrix<f64>, y: &DMatrix<f64>| {
        let spread: Vec<f64> = x.column_iter().map(|x| y.tr_mul(&x).norm()).collect();
        spread.iter().map(|own| (own / spread[0]).min(1.0)).collect()
    };
    with_latents(
        y,
        starting_point(y, sequences, settings, seed),
        sequences,
        |y| smoothed(y, sequences),
        shares,
    )
}

/// The start with the principal components of other columns: of unit variance and then as large as these
/// numbers say, which are told them and the columns. The inducing inputs are at the same frames.
fn with_latents(
    y: &[DMatrix<f64>],
    mut params: Params,
    sequences: &Sequences,
    columns: impl Fn(&DMatrix<f64>) -> DMatrix<f64>,
    sizes: impl Fn(&DMatrix<f64>, &DMatrix<f64>) -> Vec<f64>,
) -> Params {
    let before: Vec<DMatrix<f64>> = params.parts.iter().map(|part| part.latents.mean.clone()).collect();
    for ((part, y), before) in params.parts.iter_mut().zip(y).zip(&before) {
        let columns = columns(y);
        let eigen = SymmetricEigen::new(columns.tr_mul(&columns));
        let mut order: Vec<usize> = (0..y.ncols()).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        let mean = &mut part.latents.mean;
        for (mut x, k) in mean.column_iter_mut().zip(order) {
            let score = &columns * eigen.eigenvectors.column(k);
            x.copy_from(&score.normalize().scale((y.nrows() as f64).sqrt()));
        }
        let sizes = sizes(mean, y);
        mean.column_iter_mut().zip(sizes).for_each(|(mut x, size)| x *= size);
        move_rows(&mut part.r, before, mean);
    }
    for ((row, part), before) in params.experts.iter_mut().zip(&params.parts).zip(&before) {
        let (from, to) = (sequences.windows(before), sequences.windows(&part.latents.mean));
        row.iter_mut().for_each(|expert| move_rows(&mut expert.z, &from, &to));
    }
    params
}

/// The columns averaged along time with the weights of a Gaussian as wide as two of the movement's radians
/// (what training starts with: one).
fn smoothed(y: &DMatrix<f64>, sequences: &Sequences) -> DMatrix<f64> {
    let ranges: Vec<_> = sequences.ranges().collect();
    let steps: usize = ranges.iter().map(|frames| frames.len() - 1).sum();
    let change: f64 = ranges
        .iter()
        .flat_map(|frames| frames.clone().skip(1))
        .map(|t| (y.row(t) - y.row(t - 1)).norm_squared())
        .sum();
    let pace = (y.norm_squared() / y.nrows() as f64 / (change / steps as f64)).sqrt();
    let mut averages = y.clone();
    for frames in ranges {
        for t in frames.clone() {
            let weight = |near: usize| (-0.5 * (near.abs_diff(t) as f64 / (2.0 * pace)).powi(2)).exp();
            let total: f64 = frames.clone().map(weight).sum();
            let sum = frames.clone().fold(y.row(t) * 0.0, |sum, near| sum + y.row(near) * weight(near));
            averages.set_row(t, &(sum / total));
        }
    }
    averages
}

/// Replaces each row of `z`, which is one of `from`, by the same row of `to`.
fn move_rows(z: &mut DMatrix<f64>, from: &DMatrix<f64>, to: &DMatrix<f64>) {
    for mut z in z.row_iter_mut() {
        let row = (0..from.nrows()).find(|row| from.row(*row) == z).unwrap();
        z.copy_from(&to.row(row));
    }
}

/// Our start with pose maps that are still more nearly linear: squared lengthscales of 10.
fn straight(y: &[DMatrix<f64>], sequences: &Sequences, settings: &VariationalSettings, seed: u32) -> Params {
    let mut params = starting_point(y, sequences, settings, seed);
    for kernel in params.parts.iter_mut().map(|part| &mut part.kernel) {
        kernel.variance *= 10.0 / kernel.lambda[0];
        kernel.lambda.fill(10.0);
    }
    params
}

/// Our start with pose maps of the data's variance and squared lengthscales of 1, in which latents of unit
/// variance bend.
fn bent(y: &[DMatrix<f64>], sequences: &Sequences, settings: &VariationalSettings, seed: u32) -> Params {
    let mut params = starting_point(y, sequences, settings, seed);
    for (part, y) in params.parts.iter_mut().zip(y) {
        part.kernel.lambda.fill(1.0);
        part.kernel.variance = y.norm_squared() / y.len() as f64;
    }
    params
}

/// The authors' start: lengthscales, signal variance and noise 1, whatever the data's units.
fn authors(y: &[DMatrix<f64>], sequences: &Sequences, settings: &VariationalSettings, seed: u32) -> Params {
    let mut params = fast(y, sequences, settings, seed);
    for part in &mut params.parts {
        part.kernel.lambda.fill(1.0);
        (part.kernel.variance, part.beta) = (1.0, 1.0);
    }
    params
}

/// Our start with the inducing inputs spread over the latents: each far from the others, or moved on to
/// cluster centres.
fn clustered(mut params: Params, sequences: &Sequences, centres: bool) -> Params {
    let histories: Vec<DMatrix<f64>> =
        params.parts.iter().map(|part| sequences.histories(&part.latents).mean).collect();
    for part in &mut params.parts {
        spread(&part.latents.mean, &mut part.r, centres);
    }
    for (row, histories) in params.experts.iter_mut().zip(&histories) {
        row.iter_mut().for_each(|expert| spread(histories, &mut expert.z, centres));
    }
    params
}

/// From the first row of `z` on, takes the row of `x` that is farthest from those taken; then Lloyd's
/// iterations.
fn spread(x: &DMatrix<f64>, z: &mut DMatrix<f64>, centres: bool) {
    let distance = |t: usize, z: &DMatrix<f64>, k: usize| (x.row(t) - z.row(k)).norm_squared();
    for k in 1..z.nrows() {
        let nearest = |t: usize| (0..k).map(|l| distance(t, z, l)).fold(f64::INFINITY, f64::min);
        let far = (0..x.nrows()).max_by(|a, b| nearest(*a).total_cmp(&nearest(*b))).unwrap();
        z.set_row(k, &x.row(far));
    }
    for _ in 0..if centres { 30 } else { 0 } {
        let mut sums = DMatrix::zeros(z.nrows(), z.ncols());
        let mut counts = vec![0.0; z.nrows()];
        for t in 0..x.nrows() {
            let near = (0..z.nrows()).min_by(|a, b| distance(t, z, *a).total_cmp(&distance(t, z, *b)));
            let mut sum = sums.row_mut(near.unwrap());
            sum += x.row(t);
            counts[near.unwrap()] += 1.0;
        }
        for (k, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0.0) {
            z.set_row(k, &(sums.row(k) / *count));
        }
    }
}
