//! Random clips for the tests of this module.

use crate::motion::clip::Clip;
use crate::motion::skeleton::{Channel, Joint, Skeleton};
use nalgebra::DMatrix;
use proptest::prelude::*;

/// A body from the names and parents of its joints. Each bone is one unit long and points along y.
pub(crate) fn tree(joints: &[(&str, Option<usize>)]) -> Skeleton {
    let joint = |&(name, parent): &(&str, Option<usize>)| Joint {
        name: name.to_owned(),
        parent,
        offset: [0.0, 1.0, 0.0],
        channels: vec![Channel::Zrotation, Channel::Xrotation, Channel::Yrotation],
        end_sites: Vec::new(),
    };
    Skeleton { joints: joints.iter().map(joint).collect() }
}

/// Bodies of up to eight joints with any channels in any order, and their motion.
pub(crate) fn any_clip() -> impl Strategy<Value = Clip> {
    let channels = proptest::sample::subsequence(Channel::ALL.to_vec(), 0..=6).prop_shuffle();
    let offset = proptest::array::uniform3(-10.0..10.0_f64);
    let joint =
        (channels, offset.clone(), proptest::collection::vec(offset, 0..3), any::<proptest::sample::Index>());
    (proptest::collection::vec(joint, 1..9), 1..12_usize, any::<u64>()).prop_map(|(joints, frames, seed)| {
        let joints: Vec<Joint> = (joints.into_iter().enumerate())
            .map(|(place, (mut channels, offset, end_sites, parent))| {
                if place == 0 {
                    // The root has all six channels, in a random order.
                    let missing: Vec<Channel> =
                        Channel::ALL.into_iter().filter(|c| !channels.contains(c)).collect();
                    channels.extend(missing);
                }
                // The parent is the joint before or the root, so the order is that of a file.
                let parent = (place > 0).then(|| if parent.index(3) > 0 { place - 1 } else { 0 });
                Joint { name: format!("joint {place}"), parent, offset, channels, end_sites }
            })
            .collect();
        let skeleton = Skeleton { joints };
        let mut state = seed;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let values = DMatrix::from_fn(frames, skeleton.channel_count(), |_, _| 400.0 * random() - 200.0);
        Clip::new("random.bvh", skeleton, 0.04, values)
    })
}
