//! How far to go in a direction: until the strong Wolfe conditions hold (Nocedal and Wright, "Numerical
//! Optimization", 2006, algorithms 3.5 and 3.6).

/// The value must fall by at least this part of what the slope at the beginning promises.
const SUFFICIENT_DECREASE: f64 = 1e-3;
/// The slope must become this much flatter.
const FLATTER: f64 = 0.9;
/// While nothing ends the way, it becomes so many times longer.
const LONGER: f64 = 4.0;
/// How near to an end of the bracket the next step may be, in lengths of the bracket.
const MARGIN: f64 = 0.1;
/// A bracket that is shorter than this part of the step holds a kink, where an entry reaches the end of its
/// box: no point in it is flat.
const SHORTEST: f64 = 1e-3;
const MOST_TRIALS: usize = 20;

/// What was found after a step.
pub struct Found<At> {
    pub value: f64,
    /// Of the value along the way.
    pub slope: f64,
    /// The point.
    pub at: At,
}

/// One end of the bracket.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    value: f64,
    slope: f64,
}

/// A point that is enough better than the beginning, of this value and (negative) slope; `first` is the step
/// that is tried first. `None` when none was found.
pub fn line_search<At>(
    (value, slope): (f64, f64),
    first: f64,
    mut probe: impl FnMut(f64) -> Found<At>,
) -> Option<Found<At>> {
    let mut low = End { t: 0.0, value, slope };
    let mut high: Option<End> = None;
    let mut best = None;
    let mut t = first;
    for _ in 0..MOST_TRIALS {
        let found = probe(t);
        let here = End { t, value: found.value, slope: found.slope };
        // What cannot be computed is no better.
        if here.value <= value + SUFFICIENT_DECREASE * t * slope && here.value < low.value {
            if here.slope.abs() <= FLATTER * slope.abs() {
                return Some(found);
            }
            best = Some(found);
            // The minimum is on the side to which it goes down.
            let far = high.map_or(1.0, |high| high.t - low.t);
            if here.slope * far >= 0.0 {
                high = Some(low);
            }
            low = here;
        } else {
            high = Some(here);
        }
        t = match high {
            None => LONGER * t,
            Some(high) => between(low, high),
        };
        let kink = high.is_some_and(|high| (high.t - low.t).abs() < SHORTEST * low.t);
        if kink || !(t > 0.0 && t.is_finite()) {
            break;
        }
    }
    best
}

/// The minimum of the cubic polynomial with the values and slopes of both ends (equation 3.59), not too near
/// to either.
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

    /// The step that is taken for f, f' along the way, and how many were tried.
    fn taken(first: f64, f: impl Fn(f64) -> (f64, f64)) -> (Option<f64>, usize) {
        let mut tried = 0;
        let found = line_search(f(0.0), first, |t| {
            tried += 1;
            let (value, slope) = f(t);
            Found { value, slope, at: t }
        });
        (found.map(|found| found.at), tried)
    }

    #[test]
    fn a_good_first_step_is_taken() {
        assert_eq!(taken(1.0, |t| ((t - 1.0).powi(2), 2.0 * (t - 1.0))), (Some(1.0), 1));
    }

    #[test]
    fn a_step_too_long_is_shortened_to_the_minimum_of_a_cubic() {
        let cubic = |t: f64| (t * t * t - 3.0 * t, 3.0 * t * t - 3.0);
        let (step, tried) = taken(3.0, cubic);
        assert!((step.unwrap() - 1.0).abs() < 1e-12, "{step:?}");
        assert_eq!(tried, 2);
    }

    #[test]
    fn a_step_too_short_grows() {
        let (step, tried) = taken(0.01, |t| ((t - 5.0).powi(2), 2.0 * (t - 5.0)));
        assert!((0.5..9.5).contains(&step.unwrap()) && tried < 8, "{step:?} {tried}");
    }

    /// Far away the value cannot be computed: a wall, or none at all.
    #[test]
    fn what_cannot_be_computed_is_avoided() {
        for beyond in [(1e6, 0.0), (f64::NAN, f64::NAN), (f64::INFINITY, 0.0)] {
            let f = |t: f64| if t > 0.1 { beyond } else { ((t - 1.0).powi(2), 2.0 * (t - 1.0)) };
            let (step, _) = taken(1.0, f);
            assert!(step.is_some_and(|t| t > 0.0 && t <= 0.1), "{step:?}");
        }
    }

    /// The value falls to a kink and rises behind it: no slope is ever flat.
    #[test]
    fn at_a_kink_the_search_is_short() {
        let kink = |t: f64| if t < 0.3 { (-t, -1.0) } else { (2.0 * t - 0.9, 2.0) };
        let (step, tried) = taken(1.0, kink);
        assert!((step.unwrap() - 0.3).abs() < 1e-3 && tried < 12, "{step:?} {tried}");
    }

    /// A way that only rises, though its slope says otherwise.
    #[test]
    fn no_step_is_found_where_there_is_none() {
        assert_eq!(taken(1.0, |t| if t > 0.0 { (1.0 + t, 1.0) } else { (0.0, -1.0) }), (None, MOST_TRIALS));
    }
}
