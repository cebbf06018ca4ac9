//! Names of joints that every program can read.

use crate::motion::clip::Clip;

impl Clip {
    /// The clip with names of ASCII letters, digits, "_" and "-": a prefix that ends with a colon is removed
    /// (`mixamorig:Hips` becomes `Hips`), any other character becomes "_", and a name that is taken gets a
    /// number.
    ///
    /// ```
    /// use vcgpdm_core::motion::samples;
    ///
    /// let mut clip = samples::clip("walk-1").ok_or("no such sample")?;
    /// clip.skeleton.joints[0].name = "mixamorig:Left Hip".to_owned();
    /// assert_eq!(clip.with_plain_names().skeleton.joints[0].name, "Left_Hip");
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn with_plain_names(mut self) -> Clip {
        let mut taken: Vec<String> = Vec::new();
        for joint in &mut self.skeleton.joints {
            let plain = plain_name(&joint.name);
            let numbered = (2..).map(|number| format!("{plain}_{number}"));
            let free = std::iter::once(plain.clone()).chain(numbered).find(|name| !taken.contains(name));
            joint.name = free.unwrap_or(plain);
            taken.push(joint.name.clone());
        }
        self
    }
}

fn plain_name(name: &str) -> String {
    let last = name.rsplit(':').find(|word| !word.is_empty()).unwrap_or_default();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    let plain: String = last.chars().map(|c| if is_plain(c) { c } else { '_' }).collect();
    if plain.is_empty() { "joint".to_owned() } else { plain }
}

#[cfg(test)]
mod tests {
    use crate::motion::testing::any_clip;
    use proptest::prelude::*;

    #[test]
    fn letters_digits_and_two_signs_stay() {
        let names = ["rig:Left-Arm_2", "Brüst 1", ":", ""].map(super::plain_name);
        assert_eq!(names, ["Left-Arm_2", "Br_st_1", "joint", "joint"]);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn names_are_plain_and_different(
            mut clip in any_clip(), names in proptest::collection::vec("[a-b:. \u{e9}_]{0,4}", 9)
        ) {
            for (joint, name) in clip.skeleton.joints.iter_mut().zip(names) {
                joint.name = name;
            }
            let plain = clip.clone().with_plain_names();
            for (place, joint) in plain.skeleton.joints.iter().enumerate() {
                prop_assert!(!joint.name.is_empty());
                prop_assert!(joint.name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-'));
                let earlier = &plain.skeleton.joints[..place];
                prop_assert!(earlier.iter().all(|other| other.name != joint.name));
            }
            prop_assert_eq!(&plain.values, &clip.values);
            prop_assert_eq!(plain.clone().with_plain_names(), plain);
        }
    }
}
