//! Reading and writing for all commands; every error names the file.

use serde::Serialize;
use std::error::Error;
use std::fs;
use std::io::{ErrorKind, Write};
use std::path::Path;
use vcgpdm::motion::{Clip, bvh, samples};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Reads a BVH file, or makes the sample clip that `sample:ID` names.
pub fn read_clip(place: &str) -> Result<Clip> {
    if let Some(id) = place.strip_prefix("sample:") {
        return samples::clip(id).ok_or_else(|| {
            let known: Vec<&str> = samples::list().iter().map(|info| info.id).collect();
            format!("expected one of the samples {}, found {id:?}", known.join(", ")).into()
        });
    }
    let path = Path::new(place);
    let bytes = fs::read(path).map_err(|error| about(path, &error))?;
    let name = path.file_name().map_or_else(|| place.into(), |name| name.to_string_lossy());
    Ok(bvh::read(&name, &bytes)?.into_clip())
}

/// Reads a text file.
pub fn read_text(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|error| about(path, &error))
}

/// Writes a text file.
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    fs::write(path, text).map_err(|error| about(path, &error))
}

/// Finds out early that a file could not be written, before minutes are spent on what should stand in it.
pub fn check_writable(path: &Path) -> Result<()> {
    let new = !path.exists();
    fs::OpenOptions::new().append(true).create(true).open(path).map_err(|error| about(path, &error))?;
    if new {
        fs::remove_file(path).map_err(|error| about(path, &error))?;
    }
    Ok(())
}

/// An error with the file it is about.
pub fn about(path: &Path, error: &dyn Error) -> Box<dyn Error> {
    format!("{}: {error}", path.display()).into()
}

/// Prints one JSON object and a line end.
pub fn print_json(value: &impl Serialize) -> Result<()> {
    print(&(serde_json::to_string(value)? + "\n"))
}

/// Prints to stdout. A reader that has seen enough, such as `head`, is no error.
pub fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("stdout: {error}").into()),
        _ => Ok(()),
    }
}
