//! Reading and writing for all commands; every error names the file. A file called `-` is stdin or stdout.

use crate::usage::usage;
use nalgebra::DMatrix;
use serde::Serialize;
use std::collections::HashMap;
use std::error::Error;
use std::fs::{self, File};
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
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
    let bytes = read_bytes(path)?;
    Ok(bvh::read(&read_name(path), &bytes)?.into_clip())
}

/// What a file that is read is called in what is made of it.
pub fn read_name(path: &Path) -> String {
    if is_standard(path) { "stdin".to_owned() } else { name_of(path) }
}

/// A file's name without its folder, as the clip in it is called.
pub fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// Whether the path is `-`: stdin or stdout.
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Reads a file, or stdin.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>> {
    if !is_standard(path) {
        return fs::read(path).map_err(|error| about(path, &error));
    }
    static READ: AtomicBool = AtomicBool::new(false);
    if READ.swap(true, Ordering::Relaxed) {
        return Err(usage("-: expected stdin once, found it twice"));
    }
    let mut bytes = Vec::new();
    std::io::stdin().lock().read_to_end(&mut bytes).map_err(|error| format!("stdin: {error}"))?;
    Ok(bytes)
}

/// Reads a text file, or stdin.
pub fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read_bytes(path)?)
        .map_err(|_| format!("{}: expected UTF-8 text", path.display()).into())
}

/// Writes a text file, or to stdout. Where a file is there already it stays as it was until the new one is
/// whole: a full disk, or an end in the middle, leaves the old one. A link goes on pointing where it pointed.
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    if is_standard(path) {
        return print(text);
    }
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let known = fs::metadata(path).ok();
    // A pipe or a device has no place beside it for a new file.
    if known.as_ref().is_some_and(|known| !known.is_file()) {
        return fs::write(path, text).map_err(|error| about(path, &error));
    }
    let new = beside(path);
    let written = File::create(&new).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        if let Some(known) = &known {
            file.set_permissions(known.permissions())?;
        }
        file.sync_all()?;
        fs::rename(&new, path)
    });
    written.map_err(|error| {
        // What is there of it helps nobody, and fills a disk that may be full.
        let _ = fs::remove_file(&new);
        about(path, &error)
    })
}

/// Finds out early that one of several files, each with its option, could not be written, or that two of them
/// would be stdout or one file.
pub fn check_outs<'a, P: AsRef<Path> + 'a>(
    outs: impl IntoIterator<Item = (&'static str, P)>,
    read: impl IntoIterator<Item = &'a Path> + Clone,
) -> Result<()> {
    let mut places = HashMap::new();
    for (option, out) in outs {
        let out = out.as_ref();
        check_writable(out, read.clone())?;
        let place = place_of(out);
        // A pipe or a device can take several.
        let takes_several = place.exists() && !place.is_file() && !is_standard(out);
        let Some(other) = places.insert(place, option).filter(|_| !takes_several) else { continue };
        if is_standard(out) {
            return Err(usage("-: expected one file on stdout, found two"));
        }
        let words = "the second would be written over the first";
        return Err(usage(format!(
            "{option} {}: expected a file of its own, found that of {other}: {words}",
            out.display()
        )));
    }
    Ok(())
}

/// A path by which a file is known however it is spelt, whether it is there yet or not.
fn place_of(path: &Path) -> PathBuf {
    if is_standard(path) {
        return path.to_owned();
    }
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let new = || Some(fs::canonicalize(folder).ok()?.join(path.file_name()?));
    fs::canonicalize(path).ok().or_else(new).unwrap_or_else(|| path.to_owned())
}

/// Finds out early that a file could not be written, before minutes are spent on what should stand in it; and
/// that it is none of the files that are read.
pub fn check_writable<'a>(path: &Path, read: impl IntoIterator<Item = &'a Path>) -> Result<()> {
    if is_standard(path) {
        return Ok(());
    }
    let place = fs::canonicalize(path);
    if let Ok(place) = &place
        && read.into_iter().any(|read| fs::canonicalize(read).is_ok_and(|read| read == *place))
    {
        return Err(format!(
            "{}: expected another file to write to than one that is read, which would be lost",
            path.display()
        )
        .into());
    }
    let place = place.unwrap_or_else(|_| path.to_owned());
    if place.exists() {
        fs::OpenOptions::new().append(true).open(&place).map_err(|error| about(path, &error))?;
        if !place.is_file() {
            return Ok(());
        }
    }
    let new = beside(&place);
    File::create(&new).and_then(|_| fs::remove_file(&new)).map_err(|error| about(path, &error))
}

/// Where a file's new text stands until it is whole: beside it, under a name of this process's own.
fn beside(path: &Path) -> PathBuf {
    let mut name = path.to_owned().into_os_string();
    name.push(format!(".{}.new", std::process::id()));
    name.into()
}

/// An error with the file it is about.
pub fn about(path: &Path, error: &dyn Error) -> Box<dyn Error> {
    format!("{}: {error}", path.display()).into()
}

/// A text for a terminal: what would move the cursor, colour or clear the screen stands as its code. Names
/// and words come from strangers' files.
pub fn shown(text: &str) -> String {
    let harmless = |c: char| c == '\n' || !c.is_control();
    text.chars().map(|c| if harmless(c) { c.to_string() } else { c.escape_default().to_string() }).collect()
}

/// Prints one JSON object and a line end.
pub fn print_json(value: &impl Serialize) -> Result<()> {
    print(&(serde_json::to_string(value)? + "\n"))
}

/// The rows of a matrix, as a summary shows it.
pub fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// Prints what was done as one JSON object: to stderr where one of the files written went to stdout.
pub fn print_summary(value: &impl Serialize, outs: &[&Path]) -> Result<()> {
    if !outs.iter().any(|out| is_standard(out)) {
        return print_json(value);
    }
    // Nobody is left to tell when stderr is closed.
    let _ = writeln!(std::io::stderr(), "{}", serde_json::to_string(value)?);
    Ok(())
}

/// Prints to stdout. A reader that has seen enough, such as `head`, is no error.
pub fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("stdout: {error}").into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_terminal_is_not_told_what_to_do_by_a_file() {
        assert_eq!(shown("a\u{1b}[2J\u{7}\u{9b}é\nb"), "a\\u{1b}[2J\\u{7}\\u{9b}é\nb");
    }
}
