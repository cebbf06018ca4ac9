//! How far moment matching says what many sampled futures say, as Markdown tables. `npm run uncertainty` puts them into
//! docs/uncertainty.md.
//!
//! ```sh
//! cargo run --release --example uncertainty
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "../shared/models.rs"]
mod models;
mod spread;

use models::Trained;
use spread::{Cloud, rms};
use std::ops::Range;
use vcgpdm::models::RolloutRequest;

const FRAMES: [usize; 7] = [5, 10, 15, 20, 30, 45, 60];
const DRAWS: Range<u64> = 0..1000;
/// Frames of the mean rollout that a future is early or late in.
const PATH: usize = 90;

fn main() {
    println!("### The model that the page opens with\n");
    print(&models::start());
    if std::env::args().nth(1).is_some() {
        return;
    }
    for (title, model) in models::of_samples() {
        println!("### {title}\n");
        print(&model);
    }
}

/// One row for each part and frame.
fn print(model: &Trained) {
    let request = RolloutRequest { frames: PATH, ..RolloutRequest::default() };
    let dynamics = model.predictive_dynamics(&request).unwrap();
    let start = model.model.start(0).unwrap();
    let frames = FRAMES[FRAMES.len() - 1] + 1;
    let moments = dynamics.moments(start, frames).unwrap();
    let futures: Vec<_> = DRAWS.map(|seed| dynamics.sample(start, frames, seed).unwrap()).collect();
    let paths = model.rollout(&request).unwrap().latents;
    println!(
        "| part | frame | seconds | deviation of futures | of the Gaussian | ratio | means apart | outside | tails | timing |"
    );
    println!("{}|", "|---".repeat(10));
    for (part, spec) in model.body.layout.parts().iter().enumerate() {
        for t in FRAMES {
            let seen = Cloud::of(futures.iter().map(|future| future[part].row(t).transpose()).collect());
            let (mean, covariance) = (moments.means[part].row(t).transpose(), &moments.covariances[part][t]);
            let known = rms(covariance.diagonal().iter().copied());
            let shift = (&seen.mean - &mean).component_div(&covariance.diagonal().map(f64::sqrt));
            let apart = rms(shift.iter().map(|apart| apart * apart));
            let path = &paths[part];
            println!(
                "| {} | {t} | {:.2} | {:.2} | {known:.2} | {:.2} | {apart:.2} | {:.0} % | {:.2} | {:.1} |",
                spec.name,
                t as f64 * model.body.frame_time,
                seen.deviation,
                seen.deviation / known,
                100.0 * seen.share_outside(&mean, covariance),
                seen.tails(),
                seen.timing(path, t),
            );
        }
    }
    println!();
}
