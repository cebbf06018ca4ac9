//! The size of a candidate: its inducing points, primitives or bases.

use vcgpdm::models::ModelSettings;

/// Inducing points of dynamics and poses, primitives, or bases; 0 where the data are the size and where it is
/// chosen by the bound.
pub(super) fn size(candidate: &ModelSettings) -> (usize, usize) {
    match candidate {
        ModelSettings::Vcgpdm(s) | ModelSettings::Vgpdm(s) => (s.dynamics_ips, s.pose_ips),
        ModelSettings::MapGpdm(_) | ModelSettings::MapCgpdm(_) => (0, 0),
        ModelSettings::Tmp(s) => (s.primitives.unwrap_or(0), 0),
        ModelSettings::DmpDiscrete(s) | ModelSettings::DmpRhythmic(s) => (s.bases, 0),
    }
}

/// The settings without the size: equal for candidates that differ in size alone.
pub(super) fn without_size(candidate: &ModelSettings) -> ModelSettings {
    let mut settings = candidate.clone();
    match &mut settings {
        ModelSettings::Vcgpdm(s) | ModelSettings::Vgpdm(s) => (s.dynamics_ips, s.pose_ips) = (0, 0),
        ModelSettings::MapGpdm(_) | ModelSettings::MapCgpdm(_) => {}
        ModelSettings::Tmp(s) => s.primitives = None,
        ModelSettings::DmpDiscrete(s) | ModelSettings::DmpRhythmic(s) => s.bases = 0,
    }
    settings
}
