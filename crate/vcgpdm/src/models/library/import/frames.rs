//! The frames that primitives of another library are learned again from.

use crate::models::library::import::request::ImportError;
use crate::models::library::{FramesFrom, ObservedClip, TrainedLibrary};
use crate::motion::Clip;
use nalgebra::DMatrix;

/// More frames of a rollout than an import has use for.
const MOST_GENERATED: usize = 2000;

/// One movement of the other library that its primitives are learned again from.
pub(super) struct Shown {
    /// Its name there.
    pub name: String,
    /// The primitive there that each part used; `None`: one that is not among those to be learned.
    pub uses: Vec<Option<usize>>,
    /// Its sequences, as this library sees them.
    pub clips: Vec<ObservedClip>,
}

/// Clips show one movement, that of all primitives of the donor.
pub(super) fn of_clips(donor: &TrainedLibrary, clips: &[ObservedClip]) -> Result<Shown, ImportError> {
    if clips.is_empty() {
        return Err(ImportError::NoFrames);
    }
    let primitives = &donor.library.primitives;
    let mut uses = Vec::new();
    for (part, spec) in donor.body.layout.parts().iter().enumerate() {
        let own: Vec<usize> = (0..primitives.len()).filter(|a| primitives[*a].part == part).collect();
        if own.len() > 1 {
            return Err(ImportError::Several { part: spec.name.clone(), found: own.len() });
        }
        uses.push(own.first().copied());
    }
    let movement = donor.library.movements.first().map(|movement| &movement.name);
    let excerpt = || Some(&primitives.first()?.excerpts.first()?.movement);
    let name = movement.or_else(excerpt).or_else(|| Some(&primitives.first()?.name));
    Ok(Shown { name: name.cloned().unwrap_or_default(), uses, clips: clips.to_vec() })
}

/// What the other library can show of its movements without a clip.
///
/// # Errors
///
/// When it shows nothing, or what it shows cannot be turned into columns of this library.
pub(super) fn shown(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    from: FramesFrom,
) -> Result<Vec<Shown>, ImportError> {
    let mut shown = Vec::new();
    for (m, movement) in donor.library.movements.iter().enumerate() {
        let mut clips = Vec::new();
        if from == FramesFrom::Generated {
            let model = donor.movement(m)?;
            for (s, info) in donor.sequences_of(m).iter().enumerate() {
                // As long as what it was learned from.
                let frames = info.frames.clamp(donor.library.order + 1, MOST_GENERATED);
                let y = donor.body.columns(&model.fitted.rollout(s, frames)?);
                clips.push(host.observed(&donor.body.clip(&y, &info.name)?)?);
            }
        } else {
            let names: Vec<String> = donor.sequences_of(m).iter().map(|info| info.name.clone()).collect();
            clips = remembered(host, donor, &movement.starts, &names)?;
        }
        let uses = movement.uses.iter().map(|a| Some(*a)).collect();
        shown.push(Shown { name: movement.name.clone(), uses, clips });
    }
    if from == FramesFrom::Remembered {
        for (a, primitive) in donor.library.primitives.iter().enumerate() {
            for excerpt in &primitive.excerpts {
                let clips = remembered(host, donor, &excerpt.starts, &[])?;
                let uses = (0..donor.library.part_count()).map(|part| (part == primitive.part).then_some(a));
                shown.push(Shown { name: excerpt.movement.clone(), uses: uses.collect(), clips });
            }
        }
    }
    shown.retain(|movement| !movement.clips.is_empty());
    if shown.is_empty() { Err(ImportError::NoFrames) } else { Ok(shown) }
}

/// The poses of latents that the other library keeps, where it keeps more than the first frames.
fn remembered(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    starts: &[Vec<DMatrix<f64>>],
    names: &[String],
) -> Result<Vec<ObservedClip>, ImportError> {
    let mut clips = Vec::new();
    for (s, latents) in starts.iter().enumerate() {
        if latents.iter().any(|x| x.nrows() <= donor.library.order) {
            continue;
        }
        let observed: Vec<_> =
            donor.library.parts.iter().zip(latents).map(|(map, x)| map.observations(x)).collect();
        let name = names.get(s).map_or("remembered", String::as_str);
        let clip: Clip = donor.body.clip(&donor.body.columns(&observed), name)?;
        clips.push(host.observed(&clip)?);
    }
    Ok(clips)
}
