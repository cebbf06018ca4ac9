//! The frames from which an import learns.

use crate::models::library::import::request::ImportError;
use crate::models::library::{EncodedClip, FramesFrom, TrainedLibrary};
use crate::motion::Clip;
use nalgebra::DMatrix;

/// The most frames of a generated rollout.
const MOST_GENERATED: usize = 2000;

/// A movement of the donor, from which its primitives are learned again.
pub(super) struct DonorMovement {
    /// Its name in the donor.
    pub name: String,
    /// The primitive of the donor that each part uses; `None`: the donor has no primitive of the part.
    pub uses: Vec<Option<usize>>,
    /// Its sequences, as columns of the host.
    pub clips: Vec<EncodedClip>,
}

/// The movement of these clips, which uses all primitives of the donor.
///
/// # Errors
///
/// When there is no clip, or the donor has several primitives of a part.
pub(super) fn clip_movement(
    donor: &TrainedLibrary,
    clips: &[EncodedClip],
) -> Result<DonorMovement, ImportError> {
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
    Ok(DonorMovement { name: name.cloned().unwrap_or_default(), uses, clips: clips.to_vec() })
}

/// The movements of the donor without clips: from its latents, or from rollouts.
///
/// # Errors
///
/// When there are no frames, or they cannot be turned into columns of the host.
pub(super) fn stored_movements(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    from: FramesFrom,
) -> Result<Vec<DonorMovement>, ImportError> {
    let mut movements = Vec::new();
    for (m, movement) in donor.library.movements.iter().enumerate() {
        let mut clips = Vec::new();
        if from == FramesFrom::Generated {
            let model = donor.movement(m)?;
            for (s, info) in donor.sequences_of(m).iter().enumerate() {
                // As long as the training sequence.
                let frames = info.frames.clamp(donor.library.order + 1, MOST_GENERATED);
                let y = donor.body.columns(&model.fitted.rollout(s, frames)?);
                clips.push(host.encode(&donor.body.clip(&y, &info.name)?)?);
            }
        } else {
            let names: Vec<String> = donor.sequences_of(m).iter().map(|info| info.name.clone()).collect();
            clips = remembered_clips(host, donor, &movement.starts, &names)?;
        }
        let uses = movement.uses.iter().map(|a| Some(*a)).collect();
        movements.push(DonorMovement { name: movement.name.clone(), uses, clips });
    }
    if from == FramesFrom::Remembered {
        for (a, primitive) in donor.library.primitives.iter().enumerate() {
            for excerpt in &primitive.excerpts {
                let clips = remembered_clips(host, donor, &excerpt.starts, &[])?;
                let uses = (0..donor.library.part_count()).map(|part| (part == primitive.part).then_some(a));
                movements.push(DonorMovement { name: excerpt.movement.clone(), uses: uses.collect(), clips });
            }
        }
    }
    movements.retain(|movement| !movement.clips.is_empty());
    if movements.is_empty() { Err(ImportError::NoFrames) } else { Ok(movements) }
}

/// Clips of the poses of stored latents; sequences of which the donor stores only the first frames give none.
fn remembered_clips(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    starts: &[Vec<DMatrix<f64>>],
    names: &[String],
) -> Result<Vec<EncodedClip>, ImportError> {
    let mut clips = Vec::new();
    for (s, latents) in starts.iter().enumerate() {
        if latents.iter().any(|x| x.nrows() <= donor.library.order) {
            continue;
        }
        let y: Vec<_> = donor.library.parts.iter().zip(latents).map(|(map, x)| map.observations(x)).collect();
        let name = names.get(s).map_or("remembered", String::as_str);
        let clip: Clip = donor.body.clip(&donor.body.columns(&y), name)?;
        clips.push(host.encode(&clip)?);
    }
    Ok(clips)
}
