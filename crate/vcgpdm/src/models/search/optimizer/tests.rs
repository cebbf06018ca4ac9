use super::*;
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

#[test]
fn chained_rosenbrock_in_a_box() {
    let best = Arc::new(Mutex::new(vec![0.0; 6]));
    let seen = Arc::clone(&best);
    let mut optimizer = Optimizer::new(
        vec![-1.2; 6],
        std::iter::repeat_n((-2.0, 0.9), 6),
        Box::new(move |x| {
            *seen.lock().unwrap() = x.to_vec();
            rosenbrock(x)
        }),
    );
    let mut iterations = 0;
    while optimizer.step() && iterations < 500 {
        iterations += 1;
    }
    // The free minimum is at 1 in every coordinate; the box ends at 0.9 for the first, and the others follow its square.
    let x = best.lock().unwrap().clone();
    assert!(x.iter().all(|v| (-2.0..=0.9).contains(v)), "{x:?}");
    assert!(optimizer.value().unwrap() < 1.0 && iterations < 200, "{iterations} {:?}", optimizer.value());
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

/// Curvatures from 1 to 10^6, in a box that leaves every third entry out of reach: there the solution is known.
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

/// More rows than one block has, and more blocks than are left to one thread.
#[cfg(feature = "threads")]
#[test]
fn threads_take_the_same_steps() {
    let n = 20_000;
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
