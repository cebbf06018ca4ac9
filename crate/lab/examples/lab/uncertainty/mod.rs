//! The spread of many sampled futures, compared with the Gaussian approximation by moment matching
//! (docs/uncertainty.md).

mod spread;

use crate::models;
use spread::{Cloud, Group, rms};
use std::ops::Range;
use vcgpdm::Coupled;
use vcgpdm::models::RolloutRequest;

const FRAMES: [usize; 7] = [5, 10, 15, 20, 30, 45, 60];
const DRAWS: Range<u64> = 0..1000;
/// Frames of the mean rollout, with which early and late futures are compared.
const PATH: usize = 90;

pub fn run() {
    println!("### The model that the page opens with\n");
    print(models::start().coupled().unwrap());
    for (title, model) in models::sample_models() {
        println!("### {title}\n");
        print(model.coupled().unwrap());
    }
}

/// One row for each part and frame.
fn print(model: Coupled) {
    let request = RolloutRequest { frames: PATH, ..RolloutRequest::default() };
    let dynamics = model.predictive_dynamics(&request).unwrap();
    let start = &model.model.start(0, 0).unwrap();
    let frames = FRAMES[FRAMES.len() - 1] + 1;
    let moments = dynamics.moments(start, frames).unwrap();
    let futures: Vec<_> = DRAWS.map(|seed| dynamics.sample(start, frames, seed).unwrap()).collect();
    let paths = model.rollout(&request).unwrap().latents;
    println!(
        "| part | frame | deviation of futures | of the Gaussian | ratio | means apart | outside | out of time: inside | outside | off the path: inside | outside |"
    );
    println!("{}|", "|---".repeat(11));
    for (part, spec) in model.body.layout.parts().iter().enumerate() {
        for t in FRAMES {
            let seen = Cloud::new(futures.iter().map(|future| future[part].row(t).transpose()).collect());
            let (mean, covariance) = (moments.means[part].row(t).transpose(), &moments.covariances[part][t]);
            let expected = rms(covariance.diagonal().iter().copied());
            let shift = (&seen.mean - &mean).component_div(&covariance.diagonal().map(f64::sqrt));
            let apart = rms(shift.iter().map(|apart| apart * apart));
            let [inside, outside] = seen.groups(&mean, covariance, &paths[part], t);
            let off_path = |group: &Group| group.off_path().map_or("-".to_owned(), |off| format!("{off:.2}"));
            println!(
                "| {} | {t} | {:.2} | {expected:.2} | {:.2} | {apart:.2} | {} | {} | {} | {} | {} |",
                spec.name,
                seen.deviation,
                seen.deviation / expected,
                percent(outside.count, inside.count + outside.count),
                percent(inside.out_of_time, inside.count),
                percent(outside.out_of_time, outside.count),
                off_path(&inside),
                off_path(&outside),
            );
        }
    }
    println!();
}

fn percent(count: usize, all: usize) -> String {
    if all == 0 { "-".to_owned() } else { format!("{:.0} %", 100.0 * count as f64 / all as f64) }
}
