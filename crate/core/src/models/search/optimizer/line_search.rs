//! The length of a step in a direction: one for which the strong Wolfe conditions hold (Nocedal and Wright,
//! "Numerical Optimization", 2006, algorithms 3.5 and 3.6).

/// The value must fall by at least this part of the step times the slope at the start.
const SUFFICIENT_DECREASE: f64 = 1e-3;
/// The slope must fall to this part of the slope at the start.
const FLATTER: f64 = 0.9;
/// Growth factor of the step until a minimum is bracketed.
const GROWTH: f64 = 4.0;
/// Least distance of the next step from an end of the bracket, in lengths of the bracket.
const MARGIN: f64 = 0.1;
/// A bracket shorter than this part of the step holds a kink, where a parameter reaches its bound: no point
/// in it is flat.
const SHORTEST: f64 = 1e-3;
const MOST_PROBES: usize = 20;

/// A function along a line.
pub trait Line {
    /// Computes the function after the step `t`.
    fn probe(&mut self, t: f64) -> Probe;

    /// Stores the point of the last probe as the best one.
    fn store(&mut self);
}

/// Value and slope of a function at a point of a line.
#[derive(Clone, Copy)]
pub struct Probe {
    pub value: f64,
    pub slope: f64,
}

/// One end of the bracket.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    value: f64,
    slope: f64,
}

/// Searches for a point of the `line` that is sufficiently better than its `start`, whose slope is negative.
/// Probes the step `first` first. Returns whether the line has stored such a point.
pub fn line_search(start: Probe, first: f64, line: &mut impl Line) -> bool {
    let Probe { value, slope } = start;
    let mut low = End { t: 0.0, value, slope };
    let mut high: Option<End> = None;
    let mut stored = false;
    let mut t = first;
    for _ in 0..MOST_PROBES {
        let Probe { value: here_value, slope: here_slope } = line.probe(t);
        let here = End { t, value: here_value, slope: here_slope };
        // NaN compares false and so counts as worse.
        if here.value <= value + SUFFICIENT_DECREASE * t * slope && here.value < low.value {
            line.store();
            stored = true;
            if here.slope.abs() <= FLATTER * slope.abs() {
                return true;
            }
            // The minimum is on the side where the value falls.
            let far = high.map_or(1.0, |high| high.t - low.t);
            if here.slope * far >= 0.0 {
                high = Some(low);
            }
            low = here;
        } else {
            high = Some(here);
        }
        t = match high {
            None => GROWTH * t,
            Some(high) => between(low, high),
        };
        let kink = high.is_some_and(|high| (high.t - low.t).abs() < SHORTEST * low.t);
        if kink || !(t > 0.0 && t.is_finite()) {
            break;
        }
    }
    stored
}

/// The minimum of the cubic polynomial with the values and slopes of both ends (equation 3.59), at least the
/// margin away from both.
fn between(low: End, high: End) -> f64 {
    let width = high.t - low.t;
    let theta = 3.0 * (low.value - high.value) / width + low.slope + high.slope;
    let root = width.signum() * (theta * theta - low.slope * high.slope).sqrt();
    let share = 1.0 - (high.slope + root - theta) / (high.slope - low.slope + 2.0 * root);
    let share = if share.is_finite() { share.clamp(MARGIN, 1.0 - MARGIN) } else { 0.5 };
    low.t + share * width
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Function<F> {
        f: F,
        probes: Vec<f64>,
        stored: Option<f64>,
    }

    impl<F: Fn(f64) -> (f64, f64)> Line for Function<F> {
        fn probe(&mut self, t: f64) -> Probe {
            self.probes.push(t);
            let (value, slope) = (self.f)(t);
            Probe { value, slope }
        }

        fn store(&mut self) {
            self.stored = self.probes.last().copied();
        }
    }

    /// The step accepted for the value and slope `f`, and the number of probes.
    fn accepted(first: f64, f: impl Fn(f64) -> (f64, f64)) -> (Option<f64>, usize) {
        let (value, slope) = f(0.0);
        let mut line = Function { f, probes: Vec::new(), stored: None };
        let found = line_search(Probe { value, slope }, first, &mut line);
        assert_eq!(found, line.stored.is_some());
        (line.stored, line.probes.len())
    }

    #[test]
    fn accepts_a_good_first_step() {
        assert_eq!(accepted(1.0, |t| ((t - 1.0).powi(2), 2.0 * (t - 1.0))), (Some(1.0), 1));
    }

    #[test]
    fn shortens_a_step_to_the_minimum_of_a_cubic() {
        let cubic = |t: f64| (t * t * t - 3.0 * t, 3.0 * t * t - 3.0);
        let (step, probes) = accepted(3.0, cubic);
        assert!((step.unwrap() - 1.0).abs() < 1e-12, "{step:?}");
        assert_eq!(probes, 2);
    }

    #[test]
    fn lengthens_a_short_step() {
        let (step, probes) = accepted(0.01, |t| ((t - 5.0).powi(2), 2.0 * (t - 5.0)));
        assert!((0.5..9.5).contains(&step.unwrap()) && probes < 8, "{step:?} {probes}");
    }

    /// Beyond a point the value is very large or not finite.
    #[test]
    fn avoids_values_that_are_not_finite() {
        for beyond in [(1e6, 0.0), (f64::NAN, f64::NAN), (f64::INFINITY, 0.0)] {
            let f = |t: f64| if t > 0.1 { beyond } else { ((t - 1.0).powi(2), 2.0 * (t - 1.0)) };
            let (step, _) = accepted(1.0, f);
            assert!(step.is_some_and(|t| t > 0.0 && t <= 0.1), "{step:?}");
        }
    }

    /// The value falls to a kink and rises behind it: no point is flat.
    #[test]
    fn ends_soon_at_a_kink() {
        let kink = |t: f64| if t < 0.3 { (-t, -1.0) } else { (2.0 * t - 0.9, 2.0) };
        let (step, probes) = accepted(1.0, kink);
        assert!((step.unwrap() - 0.3).abs() < 1e-3 && probes < 12, "{step:?} {probes}");
    }

    /// The value rises everywhere, though the slope at the start is negative.
    #[test]
    fn finds_no_step_where_the_value_only_rises() {
        assert_eq!(
            accepted(1.0, |t| if t > 0.0 { (1.0 + t, 1.0) } else { (0.0, -1.0) }),
            (None, MOST_PROBES)
        );
    }

    /// The value falls to a minimum at 1/3, rises, and is flat and a little lower than at the start from 1 on.
    #[test]
    fn a_flat_step_that_gains_next_to_nothing_is_not_accepted() {
        let f = |t: f64| (-t * (1.0 - t).powi(2) - 1e-4 * t, (1.0 - t) * (3.0 * t - 1.0) - 1e-4);
        let (step, _) = accepted(1.0, f);
        assert!(step.is_some_and(|t| t < 0.8), "{step:?}");
    }

    /// The first steps are better than the start, but behind the minimum.
    #[test]
    fn turns_back_to_a_minimum_before_good_steps() {
        let f = |t: f64| {
            if t < 0.3 {
                (-t - 20.0 / 3.0 * t * t, -1.0 - 40.0 / 3.0 * t)
            } else {
                (1.1 * (t - 0.3) - 0.9, 1.1)
            }
        };
        let (step, _) = accepted(1.0, f);
        assert!((step.unwrap() - 0.3).abs() < 1e-2, "{step:?}");
    }

    #[test]
    fn the_next_step_is_not_near_an_end_of_the_bracket() {
        // The minimum of the parabola is at 0.99, near one end.
        let end = |t: f64| End { t, value: (t - 0.99).powi(2), slope: 2.0 * (t - 0.99) };
        for (low, high) in [(0.0, 1.0), (1.0, 0.0)] {
            let next = between(end(low), end(high));
            assert!((next - (1.0 - MARGIN)).abs() < 1e-12, "{next}");
        }
    }
}
