use super::*;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::{Arc, Mutex};

/// Rosenbrock's function, chained.
fn rosenbrock(x: &[f64]) -> (f64, Vec<f64>) {
    let mut f = 0.0;
    let mut g = vec![0.0; x.len()];
    for k in 0..x.len() - 1 {
        let (a, b) = (1.0 - x[k], x[k + 1] - x[k] * x[k]);
        f += a * a + 100.0 * b * b;
        g[k] += -2.0 * a - 400.0 * x[k] * b;
        g[k + 1] += 200.0 * b;
    }
    (f, g)
}

/// Where it ends, its value, the iterations and the evaluations.
fn minimise(
    x: Vec<f64>,
    boxes: &[(f64, f64)],
    threads: usize,
    f: impl Fn(&[f64]) -> (f64, Vec<f64>) + Send + 'static,
) -> (Vec<f64>, f64, usize, usize) {
    let seen = Arc::new(Mutex::new((x.clone(), f64::INFINITY, 0)));
    let last = Arc::clone(&seen);
    let evaluate = move |x: &[f64]| {
        let (value, gradient) = f(x);
        let mut seen = last.lock().unwrap();
        if value < seen.1 {
            (seen.0, seen.1) = (x.to_vec(), value);
        }
        seen.2 += 1;
        (value, gradient)
    };
    let mut optimizer = Optimizer::new(x, boxes.iter().copied(), Box::new(evaluate));
    optimizer.use_threads(threads);
    let mut iterations = 0;
    while optimizer.step() && iterations < 2000 {
        iterations += 1;
    }
    let (x, value, evaluations) = seen.lock().unwrap().clone();
    assert_eq!(optimizer.value(), Some(value));
    (x, value, iterations, evaluations)
}

/// The free minimum is at 1 in every coordinate; the box ends at 0.9 for the first, and the others turn
/// towards it.
#[test]
fn chained_rosenbrock_in_a_box() {
    let (x, value, iterations, _) = minimise(vec![-1.2; 6], &[(-2.0, 0.9); 6], 1, rosenbrock);
    assert!(x.iter().all(|v| (-2.0..=0.9).contains(v)), "{x:?}");
    assert!((value - 0.963_812_8).abs() < 1e-6 && iterations < 200, "{iterations} {value}");
}

/// How far a step downhill, cut off by the box, would still go: 0 where nothing is better nearby.
fn left_to_go(x: &[f64], gradient: &[f64], boxes: &[(f64, f64)]) -> f64 {
    let entries = x.iter().zip(gradient).zip(boxes);
    entries.fold(0.0, |far, ((x, g), (low, high))| far.max((x - (x - g).clamp(*low, *high)).abs()))
}

/// 1/2 (x - c)' A (x - c).
fn bowl(a: &DMatrix<f64>, c: &DVector<f64>, x: &[f64]) -> (f64, Vec<f64>) {
    let away = DVector::from_row_slice(x) - c;
    let gradient = a * &away;
    (0.5 * away.dot(&gradient), gradient.as_slice().to_vec())
}

/// Where entries pull at each other the value has a kink at which one reaches its end. The search once
/// stopped at (1 - 1e-14, -0.55) of the first, far from the minimum.
#[test]
fn coupled_entries_do_not_jam_beside_an_end() {
    let a = DMatrix::from_row_slice(2, 2, &[2.3, 4.2, 4.2, 8.0]);
    let c = a.clone().lu().solve(&DVector::from_element(2, 1.2)).unwrap();
    let boxes = [(-1.0, 1.0); 2];
    let own = (a.clone(), c.clone());
    let (x, _, _, evaluations) = minimise(vec![-0.7, -0.5], &boxes, 1, move |x| bowl(&own.0, &own.1, x));
    assert!(left_to_go(&x, &bowl(&a, &c, &x).1, &boxes) < 1e-5 && evaluations < 40, "{x:?} {evaluations}");

    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut normal = move |_: usize, _: usize| -> f64 { StandardNormal.sample(&mut random) };
    for n in [2, 3, 5, 10, 20] {
        for _ in 0..40 {
            let b = DMatrix::from_fn(n, n, |i, j| normal(i, j) * 10f64.powf(j as f64 / n as f64 - 0.5));
            let a = b.tr_mul(&b) + DMatrix::identity(n, n) * 1e-3;
            let c = DVector::from_fn(n, |i, j| 2.0 * normal(i, j));
            let boxes = vec![(-1.0, 1.0); n];
            let start = (0..n).map(|k| normal(k, 0).tanh()).collect();
            let own = (a.clone(), c.clone());
            let (x, _, _, evaluations) = minimise(start, &boxes, 1, move |x| bowl(&own.0, &own.1, x));
            let left = left_to_go(&x, &bowl(&a, &c, &x).1, &boxes);
            assert!(left < 1e-4 && evaluations < 600, "{n}: {left} {evaluations} {x:?}");
        }
    }
}

/// Beyond a wall nothing can be computed, not even at the first step.
#[test]
fn what_cannot_be_computed_is_kept_away_from() {
    let f = |x: &[f64]| {
        let far = x[0] < 0.5;
        if far {
            (f64::NAN, vec![f64::NAN; 2])
        } else {
            (x[0] + 1.0 / x[0] + x[1] * x[1], vec![1.0 - 1.0 / (x[0] * x[0]), 2.0 * x[1]])
        }
    };
    let (x, value, ..) = minimise(vec![40.0, 3.0], &[(-99.0, 99.0); 2], 1, f);
    assert!((x[0] - 1.0).abs() < 1e-5 && x[1].abs() < 1e-5 && (value - 2.0).abs() < 1e-9, "{x:?} {value}");
}

/// Curvatures from 1 to 10^6, in a box that leaves every third entry out of reach: there the solution is
/// known.
#[test]
fn badly_scaled_and_held_by_the_box() {
    let n = 300;
    let curvature = move |k: usize| 10f64.powf(6.0 * ((k * 37) % n) as f64 / n as f64);
    let target = |k: usize| (k as f64).sin();
    let boxes: Vec<(f64, f64)> =
        (0..n).map(|k| if k % 3 == 0 { (target(k) + 0.5, 9.0) } else { (-9.0, 9.0) }).collect();
    let f = move |x: &[f64]| {
        let away: Vec<f64> = x.iter().enumerate().map(|(k, x)| x - target(k)).collect();
        let value = away.iter().enumerate().map(|(k, a)| 0.5 * curvature(k) * a * a).sum();
        (value, away.iter().enumerate().map(|(k, a)| curvature(k) * a).collect())
    };
    let (x, _, iterations, evaluations) = minimise(vec![2.0; n], &boxes, 1, f);
    for k in 0..n {
        let best = if k % 3 == 0 { target(k) + 0.5 } else { target(k) };
        assert!((x[k] - best).abs() < 1e-3, "{k}: {} {best}", x[k]);
    }
    assert!(iterations < 400 && evaluations < 2 * iterations, "{iterations} {evaluations}");
}

/// More rows than one block has, and enough blocks for three threads.
#[cfg(feature = "threads")]
#[test]
fn threads_take_the_same_steps() {
    let n = 50_000;
    let start: Vec<f64> = (0..n).map(|k| (k as f64).cos()).collect();
    let boxes = vec![(-1.5, 0.95); n];
    let few = |threads| {
        let mut optimizer = Optimizer::new(start.clone(), boxes.iter().copied(), Box::new(rosenbrock));
        optimizer.use_threads(threads);
        (0..30).for_each(|_| assert!(optimizer.step()));
        optimizer.point.unwrap().x.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    let one = few(1);
    assert!(one == few(2) && one == few(3));
}

#[test]
fn nothing_to_do_is_nothing_done() {
    // At the minimum; and with everything held.
    let square = |x: &[f64]| (x[0] * x[0], vec![2.0 * x[0]]);
    assert_eq!(minimise(vec![0.0], &[(-1.0, 1.0)], 1, square), (vec![0.0], 0.0, 0, 1));
    assert_eq!(minimise(vec![0.5], &[(0.5, 1.0)], 1, square), (vec![0.5], 0.25, 0, 1));
    assert_eq!(minimise(vec![], &[], 1, |_| (1.0, vec![])), (vec![], 1.0, 0, 1));
}
