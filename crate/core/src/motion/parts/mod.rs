//! Parts: named groups of joints that share a latent space, and the columns of Y that belong to each.
//!
//! [`presets`] finds the usual splits of a body from the names of its joints; `from_json` reads the split of a
//! user; a [`PartsLayout`] names the columns of Y of each part.

mod from_json;
mod presets;
mod spec;
#[cfg(test)]
mod tests;

pub use from_json::{GivenJoint, GivenPart, from_given, from_json};
pub use presets::{PartsPreset, preset_names, preset_parts, presets};
pub use spec::PartsLayout;
pub use spec::{PartSpec, PartsError, check};
