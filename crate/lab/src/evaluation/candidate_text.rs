//! The settings of a candidate as text, and its size.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::rivals::Rival;
use vcgpdm_core::models::{PoseWeight, Settings};
use vcgpdm_core::plural::counted;

/// The settings of a GPDM besides its size.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Common {
    pub latent: usize,
    pub order: usize,
    pub max_iterations: usize,
    /// Absent for the variational models.
    pub balanced: Option<bool>,
    /// Only another weight than 1 is named, which only variational models have.
    pub pose_weight: PoseWeight,
    /// Whether the couplings between parts are off. Only then it is named.
    pub uncoupled: bool,
    /// Whether the dynamics have a linear term. Only a linear term is named.
    pub linear: bool,
}

/// The settings that all models with latents have; absent for the others.
pub(super) fn common(candidate: &Candidate) -> Option<Common> {
    match candidate.settings()? {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => Some(Common {
            latent: s.latent,
            order: s.order,
            max_iterations: s.max_iterations,
            balanced: None,
            pose_weight: s.pose_weight,
            uncoupled: s.uncoupled,
            linear: false,
        }),
        Settings::MapGpdm(s) | Settings::MapCgpdm(s) => Some(Common {
            latent: s.latent,
            order: s.order,
            max_iterations: s.max_iterations,
            balanced: Some(s.balanced),
            pose_weight: PoseWeight::default(),
            uncoupled: false,
            linear: s.linear,
        }),
        Settings::Tmp(_) | Settings::DmpDiscrete(_) | Settings::DmpRhythmic(_) => None,
    }
}

/// The size of the candidate; absent if the data determine it.
pub(super) fn size(candidate: &Candidate) -> Option<String> {
    let settings = match candidate {
        Candidate::Model(settings) => settings,
        Candidate::Rival(Rival::ProMp { bases }) => return Some(basis_functions(*bases)),
        Candidate::Rival(Rival::Ar { components, order }) => {
            return Some(format!("{}, order {order}", counted(*components, "component")));
        }
    };
    match settings {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => {
            Some(format!("{} + {} inducing points", s.dynamics_ips, s.pose_ips))
        }
        Settings::MapGpdm(_) | Settings::MapCgpdm(_) => None,
        Settings::Tmp(s) => {
            let count = match s.primitives {
                None => "primitives by the bound".to_owned(),
                Some(count) => counted(count, "primitive"),
            };
            Some(if s.normalised_time { format!("{count}, normalised time") } else { count })
        }
        Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s) => Some(basis_functions(s.bases)),
    }
}

fn basis_functions(count: usize) -> String {
    if count == 1 { "1 basis".to_owned() } else { format!("{count} bases") }
}

/// The kind with every setting. The texts of different candidates differ.
pub(super) fn every_setting(candidate: &Candidate) -> String {
    let mut words = vec![candidate.kind().id().to_owned()];
    words.extend(size(candidate));
    if let Some(Common { latent, order, max_iterations, balanced, pose_weight, uncoupled, linear }) =
        common(candidate)
    {
        words.push(format!("Q = {latent}, order {order}, {max_iterations} iterations"));
        words.extend(balanced.map(|balanced| balance(balanced).to_owned()));
        words.extend(weight(pose_weight));
        words.extend(uncoupled.then(|| UNCOUPLED.to_owned()));
        words.extend(linear.then(|| LINEAR.to_owned()));
    }
    words.join(", ")
}

/// The name of a model without couplings between its parts.
pub(super) const UNCOUPLED: &str = "uncoupled";

/// The name of a linear term of the dynamics.
pub(super) const LINEAR: &str = "linear term";

/// The name of a weight of the pose terms; absent for the weight 1.
pub(super) fn weight(pose_weight: PoseWeight) -> Option<String> {
    (!pose_weight.is_plain()).then(|| match pose_weight {
        PoseWeight::Balanced => balance(true).to_owned(),
        PoseWeight::Fixed(factor) => format!("pose weight {factor}"),
    })
}

/// The name of balanced dynamics, or of dynamics that are not balanced.
pub(super) fn balance(balanced: bool) -> &'static str {
    if balanced { "balanced" } else { "not balanced" }
}

/// Inducing points of dynamics and poses, primitives, bases, or components and order of an autoregression; 0 if
/// the data determine the size or the bound chooses it.
pub(super) fn size_numbers(candidate: &Candidate) -> (usize, usize) {
    match candidate {
        Candidate::Model(Settings::Vcgpdm(s) | Settings::Vgpdm(s)) => (s.dynamics_ips, s.pose_ips),
        Candidate::Model(Settings::MapGpdm(_) | Settings::MapCgpdm(_)) => (0, 0),
        Candidate::Model(Settings::Tmp(s)) => (s.primitives.unwrap_or(0), 0),
        Candidate::Model(Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s)) => (s.bases, 0),
        Candidate::Rival(Rival::ProMp { bases }) => (*bases, 0),
        Candidate::Rival(Rival::Ar { components, order }) => (*components, *order),
    }
}

/// The settings without the size: equal for candidates that differ only in size.
pub(super) fn without_size(candidate: &Candidate) -> Candidate {
    let mut candidate = candidate.clone();
    match &mut candidate {
        Candidate::Model(Settings::Vcgpdm(s) | Settings::Vgpdm(s)) => {
            (s.dynamics_ips, s.pose_ips) = (0, 0);
        }
        Candidate::Model(Settings::MapGpdm(_) | Settings::MapCgpdm(_)) => {}
        Candidate::Model(Settings::Tmp(s)) => s.primitives = None,
        Candidate::Model(Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s)) => s.bases = 0,
        Candidate::Rival(Rival::ProMp { bases }) => *bases = 0,
        Candidate::Rival(Rival::Ar { components, order }) => (*components, *order) = (0, 0),
    }
    candidate
}
