//! The size of a candidate: its inducing points, primitives or bases.

use vcgpdm::models::Settings;

/// Inducing points of dynamics and poses, primitives, or bases; 0 if the data determine the size or the bound
/// chooses it.
pub(super) fn size(candidate: &Settings) -> (usize, usize) {
    match candidate {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => (s.dynamics_ips, s.pose_ips),
        Settings::MapGpdm(_) | Settings::MapCgpdm(_) => (0, 0),
        Settings::Tmp(s) => (s.primitives.unwrap_or(0), 0),
        Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s) => (s.bases, 0),
    }
}

/// The settings without the size: equal for candidates that differ only in size.
pub(super) fn without_size(candidate: &Settings) -> Settings {
    let mut settings = candidate.clone();
    match &mut settings {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => (s.dynamics_ips, s.pose_ips) = (0, 0),
        Settings::MapGpdm(_) | Settings::MapCgpdm(_) => {}
        Settings::Tmp(s) => s.primitives = None,
        Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s) => s.bases = 0,
    }
    settings
}
