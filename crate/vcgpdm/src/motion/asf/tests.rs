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
        (":hierarchy", ":hier", "expected a section :hierarchy, found the end of the file"),
        (
            "lfemur ltibia",
            "lfemur tail",
            "body.asf, line 44: expected bones of :bonedata, each once, not \"tail\"",
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
