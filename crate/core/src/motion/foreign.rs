//! Recognises other motion formats by their first bytes, so that an error can say how to convert them.

/// The format of a file that is not BVH, and what to do with the file; `None` for an unknown format.
///
/// ```
/// let format = vcgpdm_core::motion::foreign_format(b"Kaydara FBX Binary  \0");
/// assert!(format.is_some_and(|format| format.starts_with("an FBX file")));
/// ```
pub fn foreign_format(bytes: &[u8]) -> Option<&'static str> {
    let head = &bytes[..bytes.len().min(512)];
    let begins = |with: &[u8]| head.starts_with(with);
    let text = String::from_utf8_lossy(head);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    if begins(b"Kaydara FBX Binary") || text.starts_with("; FBX") {
        return Some(
            "an FBX file (Blender turns it into BVH: blender --background --python to_bvh.py -- IN.fbx \
             OUT.bvh, with docs/examples/to_bvh.py)",
        );
    }
    if begins(b"glTF") || text.starts_with('{') && text.contains("\"asset\"") {
        return Some(
            "a glTF file (Blender turns it into BVH: blender --background --python to_bvh.py -- IN.glb \
             OUT.bvh, with docs/examples/to_bvh.py)",
        );
    }
    if begins(b"BLENDER") {
        return Some(
            "a Blender file (export the armature from Blender: File, Export, Motion Capture (.bvh))",
        );
    }
    if begins(b"PXR-USD") {
        return Some("a USD file (import it into Blender and export the armature as BVH)");
    }
    // The second byte of a C3D file is always 0x50; the first says where its parameters begin.
    if head.len() >= 512 && head[1] == 0x50 && (1..=16).contains(&head[0]) {
        return Some(
            "a C3D file, which holds markers and no joints (fit a skeleton to them first, and save that as \
             BVH)",
        );
    }
    if begins(b"PK\x03\x04") || begins(b"\x93NUMPY") {
        return Some(
            "a zip file or arrays of numpy, such as AMASS's npz (bring the body into Blender with its \
             add-on and export the armature as BVH; columns of numbers can be trained on from CSV)",
        );
    }
    if text.starts_with(":FULLY-SPECIFIED") || text.starts_with("#!OML:ASF") || text.contains("\n:DEGREES") {
        return Some(
            "an AMC motion (it needs the .asf skeleton of the same person: vcgpdm clip BODY.asf MOTION.amc \
             --out MOTION.bvh)",
        );
    }
    if text.contains(":bonedata") || text.starts_with(":version") || text.contains("\n:units") {
        return Some(
            "an ASF skeleton (it needs an .amc motion: vcgpdm clip BODY.asf MOTION.amc --out MOTION.bvh)",
        );
    }
    if table_of_program(text).is_some() {
        return Some(
            "a table whose names of columns come after other rows (leave one row with a name for each column and \
             the rows of numbers: vcgpdm train TABLE.csv --columns trains on those)",
        );
    }
    is_table(bytes).then_some(
        "a table of numbers, as CSV (a table is trained on as it is: vcgpdm train TABLE.csv --columns, in \
         JavaScript Table.read)",
    )
}

/// A table of another program, which begins with rows of its own above the names of the columns.
pub(crate) fn table_of_program(text: &str) -> Option<&'static str> {
    match text.split(['\t', ',', ';', '\r', '\n']).next()?.trim().trim_matches('"') {
        "NO_OF_FRAMES" => Some("a table of Qualisys Track Manager"),
        "PathFileType" => Some("a TRC file, a table of markers"),
        "Format Version" => Some("a table of OptiTrack Motive"),
        "Trajectories" | "Model Outputs" | "Devices" => Some("a table of Vicon Nexus"),
        _ => {
            let mut head = text.split(['\r', '\n']).take(50);
            head.any(|line| line.trim() == "endheader").then_some("a .mot or .sto table of OpenSim")
        }
    }
}

/// Whether the first two lines have as many cells, with the same sign between them, and the second a number.
fn is_table(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(1 << 16)]);
    let mut lines = head.trim_start_matches('\u{feff}').lines();
    let (Some(names), Some(numbers)) = (lines.next(), lines.next()) else { return false };
    [',', ';', '\t'].iter().any(|sign| {
        let mut cells = numbers.split(*sign);
        let count = cells.clone().count();
        count > 1 && names.split(*sign).count() == count && cells.any(is_number)
    })
}

fn is_number(cell: &str) -> bool {
    cell.trim().trim_matches('"').replace(',', ".").parse::<f64>().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_format_is_known_by_its_first_bytes() {
        let mut c3d = vec![0; 512];
        (c3d[0], c3d[1]) = (16, 0x50);
        for (bytes, format) in [
            (&b"; FBX 7.3.0"[..], "an FBX file"),
            (b"glTF\x02", "a glTF file"),
            (b" {\"asset\": {}}", "a glTF file"),
            (b"BLENDER-v300", "a Blender file"),
            (b"PXR-USDC", "a USD file"),
            (&c3d, "a C3D file"),
            (b"PK\x03\x04", "a zip file"),
            (b"\x93NUMPY\x01", "a zip file"),
            (b"# made by hand\n:DEGREES\n1\n", "an AMC motion"),
            (b":version 1.10", "an ASF skeleton"),
            (b"# made\n:units\n", "an ASF skeleton"),
            (b"NO_OF_FRAMES\t5", "a table whose names"),
            (b"name\nendheader\ntime\tx\n", "a table whose names"),
            (b"a;b\n1,5;2\n", "a table of numbers"),
            (b"a\tb\nx\t\"2\"\n", "a table of numbers"),
        ] {
            let found = foreign_format(bytes).unwrap_or_default();
            assert!(found.starts_with(format), "{}: {found:?}", bytes.escape_ascii());
        }
        c3d[0] = 17;
        for bytes in
            [&c3d[..], &c3d[..500], b"word\n1.5\n", b"a,b\n1,2,3\n", b"a,b\nx,y\n", b"a,b", b"{}", b""]
        {
            assert_eq!(foreign_format(bytes), None, "{}", bytes.escape_ascii());
        }
    }
}
