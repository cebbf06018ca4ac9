//! The effects of every coupling over its range, in both readings.

use nalgebra::DMatrix;
use vcgpdm::Coupled;
use vcgpdm::models::{Ending, Health, Reading, RolloutRequest};
use vcgpdm::motion::measures::{LimbMeasures, Measures, measures};

const SECONDS: f64 = 20.0;
/// Measurements begin at this second: before, a motion changes to its new rhythm.
const SETTLED: f64 = 5.0;
const FACTORS: [f64; 6] = [1e-3, 1e-2, 1e-1, 1e1, 1e2, 1e3];
/// With many couplings, smaller differences are not printed.
const SMALLEST: f64 = 0.1;

pub const READINGS: [(Reading, &str); 2] =
    [(Reading::AsLearned, "As learned"), (Reading::ReInferred, "Re-inferred")];

/// The effect of couplings on a rollout.
pub struct Effect {
    /// Swing of the hands, and of the feet, as a multiple of the learned one.
    pub hands: f64,
    pub feet: f64,
    /// Locking of hands and feet; absent if one of them does not swing.
    pub locking: Option<f64>,
    pub health: Health,
    pub measures: Measures,
}

impl Effect {
    /// Mean periods of the hands and of the feet, in seconds.
    pub fn periods(&self) -> [Option<f64>; 2] {
        [true, false].map(|hands| mean(&self.measures, hands, |limb| limb.period))
    }

    fn cell(&self) -> String {
        let Self { hands, feet, locking, .. } = self;
        let from = self.health.from.unwrap_or(0.0);
        let cell = format!("{hands:.2} {feet:.2} {}", number(*locking));
        match self.health.state {
            Ending::StandsStill | Ending::RestsAsRecorded => format!("still from {from:.1} s"),
            Ending::KeepsOnePose => format!("one pose from {from:.1} s"),
            Ending::Shakes => "shakes".to_owned(),
            Ending::NotFinite => "not finite".to_owned(),
            Ending::LeavesTrainingRange => format!("{cell}, away from {from:.1} s"),
            Ending::VisitsFewPoses | Ending::MovesOn => cell,
        }
    }

    /// Whether the motion differs visibly from the learned one.
    fn is_visible(&self) -> bool {
        (self.hands - 1.0).abs().max((self.feet - 1.0).abs()) > SMALLEST
            || self.locking.is_none_or(|locking| locking < 1.0 - SMALLEST)
            || !self.health.is_good()
    }
}

/// The motion of a model as it was learned.
pub struct Learned {
    pub measures: Measures,
    pub health: Health,
}

impl Learned {
    pub fn new(model: Coupled) -> Self {
        let (measures, health) = roll(model, model.model.alpha.clone(), Reading::AsLearned);
        Self { measures, health }
    }

    /// The effect of other couplings.
    pub fn effect(&self, model: Coupled, alpha: DMatrix<f64>, reading: Reading) -> Effect {
        let (measures, health) = roll(model, alpha, reading);
        let swing = |hands: bool| {
            let swing = |measures| mean(measures, hands, |limb| Some(limb.swing)).unwrap_or(0.0);
            swing(&measures) / swing(&self.measures)
        };
        let (hands, feet) = (swing(true), swing(false));
        Effect { hands, feet, locking: mean(&measures, true, |limb| limb.locking), health, measures }
    }
}

fn roll(model: Coupled, alpha: DMatrix<f64>, reading: Reading) -> (Measures, Health) {
    let frame_time = model.body.frame_time;
    let frames = |seconds: f64| (seconds / frame_time).round() as usize;
    let request = RolloutRequest {
        frames: frames(SECONDS),
        sequence: 0,
        alpha: Some(alpha),
        reading,
        ..RolloutRequest::default()
    };
    let rollout = model.rollout(&request).unwrap();
    let positions = model.positions(&rollout).unwrap();
    let health = model.health(&rollout, &request, &positions).unwrap();
    let skeleton = model.body.mapping.skeleton();
    let settled = positions.len() / request.frames * frames(SETTLED);
    (measures(skeleton, &positions[settled..], frame_time), health)
}

/// The mean of a measure over hands or feet, as far as they have it.
fn mean(measures: &Measures, hands: bool, value: impl Fn(&LimbMeasures) -> Option<f64>) -> Option<f64> {
    let limbs = measures.limbs.iter().filter(|limb| limb.limb.is_hand() == hands);
    let values: Vec<f64> = limbs.filter_map(value).collect();
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The learned couplings with some of them, (source, target), multiplied by a factor.
pub fn scale(learned: &DMatrix<f64>, changes: &[(usize, usize, f64)]) -> DMatrix<f64> {
    let mut alpha = learned.clone();
    for (source, target, factor) in changes {
        alpha[(*source, *target)] *= factor;
    }
    alpha
}

pub fn number(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |value| format!("{value:.2}"))
}

/// The tables of one model.
pub fn print(model: Coupled) {
    let learned = Learned::new(model);
    let names: Vec<&str> = model.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
    let swing = |hands| mean(&learned.measures, hands, |limb| Some(limb.swing)).unwrap_or(0.0);
    println!(
        "As learned: hands swing {:.3} m, feet {:.3} m, in step {}; {:.2} m/s, the feet slide at {} of that;\n{}. Bound {:.0} nats.\n",
        swing(true),
        swing(false),
        number(mean(&learned.measures, true, |limb| limb.locking)),
        learned.measures.walking_speed,
        number(learned.measures.foot_slide),
        health_text(&learned.health),
        model.model.bound(),
    );
    for (reading, title) in READINGS {
        let factors: Vec<String> = FACTORS.iter().map(|factor| format!("x {factor}")).collect();
        println!("| {title} | alpha learned | {} |", factors.join(" | "));
        println!("{}|", "|---".repeat(2 + FACTORS.len()));
        let mut hidden = 0;
        for target in 0..names.len() {
            for source in 0..names.len() {
                let effects = FACTORS.map(|factor| {
                    let alpha = scale(&model.model.alpha, &[(source, target, factor)]);
                    learned.effect(model, alpha, reading)
                });
                if names.len() > 2 && !effects.iter().any(Effect::is_visible) {
                    hidden += 1;
                    continue;
                }
                let cells: Vec<String> = effects.iter().map(Effect::cell).collect();
                let alpha = model.model.alpha[(source, target)];
                println!("| {} to {} | {alpha:.3} | {} |", names[source], names[target], cells.join(" | "));
            }
        }
        println!();
        if hidden > 0 {
            println!(
                "Of {} couplings, {hidden} change none of these by more than {SMALLEST}.\n",
                names.len().pow(2)
            );
        }
    }
}

/// The ending of a rollout as text.
pub fn health_text(health: &Health) -> String {
    let from = health.from.unwrap_or(0.0);
    match health.state {
        Ending::MovesOn => "moves on".to_owned(),
        Ending::VisitsFewPoses => {
            let share = health.part.and_then(|part| health.parts[part].visited).unwrap_or(0.0);
            format!("visits {:.0} % of the poses", 100.0 * share)
        }
        Ending::StandsStill | Ending::RestsAsRecorded => format!("stands still from {from:.1} s"),
        Ending::KeepsOnePose => format!("keeps one pose from {from:.1} s"),
        Ending::LeavesTrainingRange => format!("leaves the training range from {from:.1} s"),
        Ending::Shakes => "shakes".to_owned(),
        Ending::NotFinite => "not finite".to_owned(),
    }
}
