//! The size of a candidate: its inducing points, primitives or bases.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::rivals::Rival;
use vcgpdm::models::Settings;

/// Inducing points of dynamics and poses, primitives, bases, or components and order of an autoregression; 0 if
/// the data determine the size or the bound chooses it.
pub(super) fn size(candidate: &Candidate) -> (usize, usize) {
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
