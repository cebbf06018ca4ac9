use super::*;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

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

/// The best point and its value, the number of iterations and the number of evaluations.
fn minimise(
    x: Vec<f64>,
    boxes: &[(f64, f64)],
    f: impl Fn(&[f64]) -> (f64, Vec<f64>),
) -> (Vec<f64>, f64, usize, usize) {
    let (mut best, mut least, mut evaluations) = (x.clone(), f64::INFINITY, 0);
    let mut evaluate = |x: &[f64], out: &mut [f64]| {
        let (value, gradient) = f(x);
        out.copy_from_slice(&gradient);
        if value < least {
            (best, least) = (x.to_vec(), value);
        }
        evaluations += 1;
        value
    };
    let mut optimizer = Optimizer::new(x, boxes.iter().copied());
    assert_eq!(optimizer.value(), None);
    let mut iterations = 0;
    while optimizer.step(&mut evaluate) && iterations < 2000 {
        iterations += 1;
    }
    assert_eq!(optimizer.value(), Some(least));
    (best, least, iterations, evaluations)
}

/// The unbounded minimum is 1 for every parameter; the box ends at 0.9.
#[test]
fn minimises_rosenbrock_in_a_box() {
    let (x, value, iterations, _) = minimise(vec![-1.2; 6], &[(-2.0, 0.9); 6], rosenbrock);
    assert!(x.iter().all(|v| (-2.0..=0.9).contains(v)), "{x:?}");
    assert!((value - 0.963_812_8).abs() < 1e-6 && iterations < 200, "{iterations} {value}");
}

/// Length of the longest step downhill inside the box: 0 at a minimum.
fn projected_gradient(x: &[f64], gradient: &[f64], boxes: &[(f64, f64)]) -> f64 {
    let parameters = x.iter().zip(gradient).zip(boxes);
    parameters.fold(0.0, |longest, ((x, g), (low, high))| longest.max((x - (x - g).clamp(*low, *high)).abs()))
}

/// 1/2 (x - c)' A (x - c).
fn bowl(a: &DMatrix<f64>, c: &DVector<f64>, x: &[f64]) -> (f64, Vec<f64>) {
    let away = DVector::from_row_slice(x) - c;
    let gradient = a * &away;
    (0.5 * away.dot(&gradient), gradient.as_slice().to_vec())
}

/// Where parameters are coupled, the value along a line has a kink at which one reaches its bound. The search
/// once stopped at (1 - 1e-14, -0.55) for the first function, far from the minimum.
#[test]
fn coupled_parameters_do_not_stop_near_a_bound() {
    let a = DMatrix::from_row_slice(2, 2, &[2.3, 4.2, 4.2, 8.0]);
    let c = a.clone().lu().solve(&DVector::from_element(2, 1.2)).unwrap();
    let boxes = [(-1.0, 1.0); 2];
    let (x, _, _, evaluations) = minimise(vec![-0.7, -0.5], &boxes, |x| bowl(&a, &c, x));
    assert!(
        projected_gradient(&x, &bowl(&a, &c, &x).1, &boxes) < 1e-5 && evaluations < 40,
        "{x:?} {evaluations}"
    );

    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut normal = move |_: usize, _: usize| -> f64 { StandardNormal.sample(&mut random) };
    for n in [2, 3, 5, 10, 20] {
        for _ in 0..40 {
            let b = DMatrix::from_fn(n, n, |i, j| normal(i, j) * 10f64.powf(j as f64 / n as f64 - 0.5));
            let a = b.tr_mul(&b) + DMatrix::identity(n, n) * 1e-3;
            let c = DVector::from_fn(n, |i, j| 2.0 * normal(i, j));
            let boxes = vec![(-1.0, 1.0); n];
            let start = (0..n).map(|k| normal(k, 0).tanh()).collect();
            let (x, _, _, evaluations) = minimise(start, &boxes, |x| bowl(&a, &c, x));
            let left = projected_gradient(&x, &bowl(&a, &c, &x).1, &boxes);
            assert!(left < 1e-4 && evaluations < 600, "{n}: {left} {evaluations} {x:?}");
        }
    }
}

/// Below 0.5 the value is NaN; the first step goes there.
#[test]
fn turns_back_from_points_without_a_value() {
    let f = |x: &[f64]| {
        let far = x[0] < 0.5;
        if far {
            (f64::NAN, vec![f64::NAN; 2])
        } else {
            (x[0] + 1.0 / x[0] + x[1] * x[1], vec![1.0 - 1.0 / (x[0] * x[0]), 2.0 * x[1]])
        }
    };
    let (x, value, ..) = minimise(vec![40.0, 3.0], &[(-99.0, 99.0); 2], f);
    assert!((x[0] - 1.0).abs() < 1e-5 && x[1].abs() < 1e-5 && (value - 2.0).abs() < 1e-9, "{x:?} {value}");
}

/// Curvatures from 1 to 10^6. Every third parameter has its minimum outside its box.
#[test]
fn minimises_a_badly_scaled_function() {
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
    let (x, _, iterations, evaluations) = minimise(vec![2.0; n], &boxes, f);
    for k in 0..n {
        let expected = if k % 3 == 0 { target(k) + 0.5 } else { target(k) };
        assert!((x[k] - expected).abs() < 1e-3, "{k}: {} {expected}", x[k]);
    }
    assert!(iterations < 400 && evaluations < 2 * iterations, "{iterations} {evaluations}");
}

/// Enough parameters for three threads.
#[cfg(feature = "threads")]
#[test]
#[ignore = "seldom: npm test -- --all"]
fn threads_take_the_same_steps() {
    let n = 50_000;
    let start: Vec<f64> = (0..n).map(|k| (k as f64).cos()).collect();
    let boxes = vec![(-1.5, 0.95); n];
    let few = |threads| {
        let mut optimizer = Optimizer::new(start.clone(), boxes.iter().copied());
        optimizer.use_threads(threads);
        let mut f = |x: &[f64], out: &mut [f64]| {
            let (value, gradient) = rosenbrock(x);
            out.copy_from_slice(&gradient);
            value
        };
        (0..30).for_each(|_| assert!(optimizer.step(&mut f)));
        optimizer.point.x.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    let single = few(1);
    assert!(single == few(2) && single == few(3));
}

#[test]
fn stays_at_a_minimum() {
    // Inside the box, at a bound, and without parameters.
    let square = |x: &[f64]| (x[0] * x[0], vec![2.0 * x[0]]);
    assert_eq!(minimise(vec![0.0], &[(-1.0, 1.0)], square), (vec![0.0], 0.0, 0, 1));
    assert_eq!(minimise(vec![0.5], &[(0.5, 1.0)], square), (vec![0.5], 0.25, 0, 1));
    assert_eq!(minimise(vec![], &[], |_| (1.0, vec![])), (vec![], 1.0, 0, 1));
}

#[test]
fn ends_after_two_successive_iterations_without_gain() {
    let mut optimizer = Optimizer::new(vec![0.0], [(-1.0, 1.0)].into_iter());
    optimizer.point.value = 5.0;
    let goes_on = [0.0, 1.0, 0.0, 1e-14].map(|gain| {
        optimizer.better = Point { value: optimizer.point.value - gain, ..optimizer.point.clone() };
        optimizer.accept()
    });
    assert_eq!(goes_on, [true, true, true, false]);
}
