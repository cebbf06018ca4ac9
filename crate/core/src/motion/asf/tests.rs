use super::*;
use nalgebra::{Rotation3, Vector3};

const ASF: &str = "\
# a body of three bones
:version 1.10
:name TEST
:units
  mass 1.0
  length 0.45
  angle deg
:root
   order TX TY TZ RX RY RZ
   axis XYZ
   position 0 0 0
   orientation 0 0 0
:bonedata
  begin
     id 1
     name lhipjoint
     direction 1 0 0
     length 2
     axis 0 0 0 XYZ
  end
  begin
     id 2
     name lfemur
     direction 0.34202 -0.939693 0
     length 7
     axis 10 20 30 XYZ
    dof rx ry rz
    limits (-160.0 20.0)
           (-70.0 70.0)
           (-60.0 70.0)
  end
  begin
     id 3
     name ltibia
     direction 0 -1 0
     length 6
     axis 0 0 20 XYZ
    dof rx
  end
:hierarchy
  begin
    root lhipjoint
    lhipjoint lfemur
    lfemur ltibia
  end
";
const AMC: &str = "\
#!OML:ASF
:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 10 -20 30
lfemur 15 25 -35
ltibia 40
2
root 1 2 4 11 -20 30
lfemur 16 25 -35
ltibia 41
";

fn file<'a>(name: &'a str, text: &'a str) -> File<'a> {
    File { name, bytes: text.as_bytes() }
}

fn recording(asf: &str, amc: &str) -> Result<Recording, AsfError> {
    read(file("body.asf", asf), file("walk.amc", amc), CMU_RATE)
}

/// The format's definition: rotations about the fixed axes x, y, z in this order.
fn xyz(x: f64, y: f64, z: f64) -> Rotation3<f64> {
    let about = |axis: Vector3<f64>, angle: f64| Rotation3::new(axis * angle.to_radians());
    about(Vector3::z(), z) * about(Vector3::y(), y) * about(Vector3::x(), x)
}

#[test]
fn joint_positions_follow_the_definition_of_the_format() {
    let clip = recording(ASF, AMC).unwrap().into_clip();
    let names: Vec<&str> = clip.skeleton.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["Hips", "LHipJoint", "LeftUpLeg", "LeftLeg"]);
    assert_eq!((clip.frames(), clip.frame_time), (2, 1.0 / 120.0));
    // By hand: every bone's world rotation is its parent's times C M C^-1, and it reaches along its direction
    // at rest.
    let (root, femur, tibia) = (xyz(10.0, -20.0, 30.0), xyz(10.0, 20.0, 30.0), xyz(0.0, 0.0, 20.0));
    let femur = root * (femur * xyz(15.0, 25.0, -35.0) * femur.inverse());
    let tibia = femur * (tibia * xyz(40.0, 0.0, 0.0) * tibia.inverse());
    let hip = Vector3::new(1.0, 2.0, 3.0) + root * Vector3::new(2.0, 0.0, 0.0);
    let knee = hip + femur * (Vector3::new(0.34202, -0.939693, 0.0).normalize() * 7.0);
    let ankle = knee + tibia * Vector3::new(0.0, -6.0, 0.0);
    let pose = clip.world_pose(0);
    assert!((pose.positions[0] - Vector3::new(1.0, 2.0, 3.0)).norm() < 1e-9);
    assert!((pose.positions[2] - hip).norm() < 1e-9 && (pose.positions[3] - knee).norm() < 1e-9);
    let end = pose.positions[3] + pose.rotations[3] * Vector3::from(clip.skeleton.joints[3].end_sites[0]);
    assert!((end - ankle).norm() < 1e-9, "{end} {ankle}");
}

#[test]
fn a_recording_written_as_bvh_is_read_as_the_same_motion() {
    let clip = recording(ASF, AMC).unwrap().into_clip();
    let written = crate::motion::bvh::write(&clip);
    let again = crate::motion::bvh::read("walk.bvh", written.as_bytes()).unwrap().into_clip();
    assert_eq!(again.skeleton, clip.skeleton);
    assert_eq!(again.values, clip.values);
}

#[test]
fn errors_name_file_and_line() {
    let refusal = |asf: &str, amc: &str| recording(asf, amc).unwrap_err().to_string();
    for (from, to, expected) in [
        (
            "length 7\n",
            "length seven\n",
            "body.asf, line 25: expected \"length\" and 1 numbers, found \"length seven\"",
        ),
        ("dof rx\n", "dof rw\n", "body.asf, line 38: expected some of TX, TY"),
        ("axis 0 0 20 XYZ", "axis 0 0 20 XXZ", "body.asf, line 37: expected the three axes"),
        (":hierarchy", ":hier", "line 46: expected a section :hierarchy, found the end of the file"),
        (
            "lfemur ltibia",
            "lfemur tail",
            "body.asf, line 44: expected bones of :bonedata, each once, not \"tail\"",
        ),
        (
            "name ltibia",
            "name lfemur",
            "line 39: expected fewer than 2000 bones, each once, not lfemur again",
        ),
    ] {
        let asf = ASF.replacen(from, to, 1);
        assert!(refusal(&asf, AMC).contains(expected), "{}", refusal(&asf, AMC));
    }
    for (from, to, expected) in [
        ("ltibia 40\n", "ltibia 40 1\n", "walk.amc, line 7: expected 1 numbers of ltibia"),
        ("ltibia 40\n", "tail 40\n", "walk.amc, line 7: expected a bone of the skeleton, found \"tail 40\""),
        ("1\nroot", "root", "walk.amc, line 4: expected the number of a frame"),
        ("15 25", "15 x", "walk.amc, line 6: expected \"lfemur\" and 3 numbers"),
    ] {
        let amc = AMC.replacen(from, to, 1);
        assert!(refusal(ASF, &amc).contains(expected), "{}", refusal(ASF, &amc));
    }
    assert!(refusal(ASF, ":DEGREES\n").contains("expected at least one frame, found the end of the file"));
}

#[test]
fn bones_without_lines_in_some_frames_keep_their_pose() {
    let third = "3\nroot 1 2 5 12 -20 30\nlfemur 17 25 -35\nltibia 42\n";
    let whole = AMC.to_owned() + third;
    let lost = whole.replace("root 1 2 4 11 -20 30\n", "").replace("ltibia 41\n", "");
    let clip = recording(ASF, &lost).unwrap();
    let expected = recording(ASF, &whole).unwrap();
    assert_eq!(clip.values.row(2), expected.values.row(2));
    assert_eq!(clip.values.view((1, 0), (1, 6)), expected.values.view((0, 0), (1, 6)));
    let warning = "1 of 3 frames have no lines of root, ltibia, first frame 2 (line 8): these bones keep";
    assert!(clip.warnings[0].starts_with(warning), "{:?}", clip.warnings);
    assert_eq!(clip.warnings.len(), 1, "the root has lines in the other frames");
    // A bone of no frame is at rest, and a first frame without a line begins as the second.
    let never = recording(ASF, &AMC.replace("ltibia 40\n", "").replace("ltibia 41\n", "")).unwrap();
    assert!(never.warnings.is_empty());
    let rootless: Vec<&str> = AMC.lines().filter(|line| !line.starts_with("root")).collect();
    let rootless = recording(ASF, &rootless.join("\n")).unwrap();
    assert!(rootless.warnings[0].starts_with("no frame has a line of root"), "{:?}", rootless.warnings);
    let later = recording(ASF, &AMC.replace("ltibia 40\n", "")).unwrap();
    assert_eq!(later.values.view((0, 12), (1, 3)), later.values.view((1, 12), (1, 3)));
}

#[test]
fn frames_that_are_lost_and_bones_that_move_give_a_warning() {
    let lost = recording(
        ASF,
        &(AMC.to_owned()
            + &AMC[AMC.find("1\nroot").unwrap()..].replace("\n2\n", "\n232\n").replacen("1\n", "231\n", 1)),
    )
    .unwrap();
    assert!(
        lost.warnings[0].starts_with("line 12: frame 231 follows frame 2: frames are missing"),
        "{:?}",
        lost.warnings
    );
    let twice = AMC.to_owned() + &AMC[AMC.find("2\nroot").unwrap()..];
    let [warning] = &recording(ASF, &twice).unwrap().warnings[..] else { panic!() };
    assert!(warning.contains("frame 2 follows frame 2: the number is wrong"), "{warning}");
    let asf = ASF.replace("dof rx\n", "dof rx tz\n");
    let amc =
        |z: &str| AMC.replace("ltibia 40", "ltibia 40 0").replace("ltibia 41", &format!("ltibia 41 {z}"));
    assert!(recording(&asf, &amc("0")).unwrap().warnings.is_empty());
    let moving = recording(&asf, &amc("0.5")).unwrap();
    assert!(moving.warnings[0].starts_with("line 11: ltibia changes its place or length"));
}

#[test]
fn files_with_returns_alone_are_read() {
    let read = recording(&ASF.replace('\n', "\r"), &AMC.replace('\n', "\r")).unwrap();
    assert_eq!(read.values, recording(ASF, AMC).unwrap().values);
    assert!(recording(ASF, &AMC.replace("15 25", "15 x").replace('\n', "\r")).unwrap_err().line == 6);
}

#[test]
fn angles_can_be_radians() {
    let radians = |word: &str| word.parse::<f64>().map_or(word.to_owned(), |a| a.to_radians().to_string());
    // The root's three positions are no angles.
    let line = |line: &str| -> String {
        let kept = if line.starts_with("root") { 4 } else { 1 };
        let words = line.split(' ').enumerate();
        words.map(|(k, word)| if k < kept { word.to_owned() } else { radians(word) } + " ").collect()
    };
    let amc: Vec<String> = AMC.replace(":DEGREES", ":RADIANS").lines().map(line).collect();
    let mut asf = ASF.replace("angle deg", "angle radians");
    for angles in ["10 20 30", "0 0 20"] {
        let words: Vec<String> = angles.split(' ').map(radians).collect();
        asf = asf.replace(&format!("axis {angles}"), &format!("axis {}", words.join(" ")));
    }
    let read = recording(&asf, &amc.join("\n")).unwrap();
    assert!((read.values - recording(ASF, AMC).unwrap().values).amax() < 1e-9);
}

#[test]
fn the_root_turns_from_its_orientation_at_rest() {
    let turned =
        recording(&ASF.replace("orientation 0 0 0", "orientation 10 20 30"), AMC).unwrap().into_clip();
    let rotation = xyz(10.0, -20.0, 30.0) * xyz(10.0, 20.0, 30.0);
    let pose = turned.world_pose(0);
    assert!((pose.rotations[0].to_rotation_matrix().matrix() - rotation.matrix()).amax() < 1e-9);
}
