use super::*;
use crate::models::search::Setbacks;
use crate::models::search::parameters::{BETA, Kind, MU};

/// Two unbounded parameters and a positive one.
#[derive(Clone)]
struct Three {
    free: Vec<f64>,
    positive: Vec<f64>,
}

impl Parameters for Three {
    fn visit<'a>(&'a self, f: &mut dyn FnMut(Kind, &'a [f64])) {
        f(MU, &self.free);
        f(BETA, &self.positive);
    }

    fn visit_mut(&mut self, f: &mut dyn FnMut(Kind, &mut [f64])) {
        f(MU, &mut self.free);
        f(BETA, &mut self.positive);
    }
}

/// Minus Rosenbrock's function of the free parameters, minus (p - 1/2)^2 for the positive parameter p. The
/// evaluations `fails`, counted from 0, fail; every second of them has a high value, but no gradient.
struct Valley {
    fails: std::ops::Range<usize>,
    computed: usize,
    gradient: Three,
}

impl Target for Valley {
    type Parameters = Three;
    type Terms = ();

    fn compute(&mut self, at: &Three) -> Result<f64, NumericsError> {
        self.computed += 1;
        if self.fails.contains(&(self.computed - 1)) {
            if self.computed.is_multiple_of(2) {
                self.gradient.free = vec![f64::NAN, 0.0];
                return Ok(1e3);
            }
            return Err(NumericsError::NotFinite { what: "valley" });
        }
        let (a, b) = (1.0 - at.free[0], at.free[1] - at.free[0] * at.free[0]);
        let c = at.positive[0] - 0.5;
        self.gradient.free = vec![2.0 * a + 400.0 * at.free[0] * b, -200.0 * b];
        self.gradient.positive = vec![-2.0 * c];
        Ok(-(a * a + 100.0 * b * b + c * c))
    }

    fn copy_terms(&self, _: &mut ()) {}

    fn gradient(&self) -> &Three {
        &self.gradient
    }
}

fn search(fails: std::ops::Range<usize>) -> Ascent<Valley> {
    let start = Three { free: vec![-1.2, 1.0], positive: vec![3.0] };
    let mut target = Valley { fails: 0..0, computed: 0, gradient: start.clone() };
    let value = target.compute(&start).unwrap();
    target.fails = fails;
    let phases =
        vec![Phase { groups: &[Group::Latents, Group::Couplings, Group::Kernels], iterations: 1000 }];
    Ascent::new(target, start, (value, ()), phases, 1000)
}

fn end(mut search: Ascent<Valley>) -> (Three, Option<SearchEnd>) {
    while search.reason().is_none() {
        search.step();
    }
    let best = search.search().best_parameters();
    (best, search.reason())
}

#[test]
fn finds_the_maximum() {
    let (best, reason) = end(search(0..0));
    assert!((best.free[0] - 1.0).abs() < 1e-4 && (best.free[1] - 1.0).abs() < 1e-4, "{:?}", best.free);
    assert!((best.positive[0] - 0.5).abs() < 1e-4, "{:?}", best.positive);
    assert_eq!(reason, Some(SearchEnd::Settled));
}

#[test]
fn turns_back_from_points_that_fail() {
    let mut ascent = search(12..21);
    while ascent.reason().is_none() {
        ascent.step();
    }
    let search = ascent.search();
    let best = search.best_parameters();
    assert!((best.free[0] - 1.0).abs() < 1e-4, "{:?}", best.free);
    assert_eq!(ascent.reason(), Some(SearchEnd::Settled));
    // The search itself makes no evaluation at its start.
    assert_eq!(search.setbacks, Setbacks { jittered: 0, turned_back: 9 });
    assert!(search.best <= 0.0, "{}", search.best);
}

#[test]
fn parameters_outside_the_groups_of_a_phase_and_fixed_ones_stay() {
    let mut ascent = search(0..0);
    ascent.phases[0].groups = &[Group::Latents];
    ascent.fix(vec![true, false, false]);
    let (best, _) = end(ascent);
    assert_eq!((best.free[0], best.positive[0]), (-1.2, 3.0));
    assert!((best.free[1] - 1.44).abs() < 1e-6, "{:?}", best.free);
}

/// 10^9 minus a long valley, with a gain of far less than a millionth.
struct Plateau(Three);

impl Target for Plateau {
    type Parameters = Three;
    type Terms = ();

    fn compute(&mut self, at: &Three) -> Result<f64, NumericsError> {
        let x = &at.free;
        self.0 = Three { free: vec![0.0; x.len()], positive: vec![] };
        let mut value = 1e9;
        for k in 1..x.len() {
            let (a, b) = (1.0 - x[k - 1], x[k] - x[k - 1] * x[k - 1]);
            value -= a * a + 100.0 * b * b;
            self.0.free[k - 1] += 2.0 * a + 400.0 * x[k - 1] * b;
            self.0.free[k] -= 200.0 * b;
        }
        Ok(value)
    }

    fn copy_terms(&self, _: &mut ()) {}

    fn gradient(&self) -> &Three {
        &self.0
    }
}

#[test]
fn ends_when_the_last_40_iterations_have_gained_little() {
    let start = Three { free: vec![0.0; 40], positive: vec![] };
    let mut target = Plateau(start.clone());
    let value = target.compute(&start).unwrap();
    let phases = vec![Phase { groups: &[Group::Latents], iterations: 1000 }];
    let mut ascent = Ascent::new(target, start, (value, ()), phases, 1000);
    while ascent.reason().is_none() {
        ascent.step();
    }
    assert_eq!((ascent.reason(), ascent.iteration()), (Some(SearchEnd::Settled), PATIENCE + 1));
    assert!(ascent.search().best > value, "{value}");
}
