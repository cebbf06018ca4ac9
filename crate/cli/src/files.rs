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

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Name of the input file as stored in outputs.
pub fn read_name(path: &Path) -> String {
    if is_standard(path) { "stdin".to_owned() } else { name_of(path) }
}

/// A file's name without its folder. Bytes that are not UTF-8 become the replacement character.
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
        return fs::read(path).map_err(|error| with_path(path, &error));
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

/// Writes a text file, or to stdout. An existing file stays unchanged until the new text is complete: a full
/// disk, or the end of the program in the middle, leaves the old text. A link stays a link, and its target is
/// written.
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    if is_standard(path) {
        return print(text);
    }
    let path = &link_target(path)?;
    let old = fs::metadata(path).ok();
    // A pipe or a device cannot be replaced by a new file.
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return fs::write(path, text).map_err(|error| with_path(path, &error));
    }
    let partial = partial_file(path);
    let written = File::create(&partial).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        if let Some(old) = &old {
            file.set_permissions(old.permissions())?;
        }
        file.sync_all()?;
        fs::rename(&partial, path)
    });
    written.map_err(|error| {
        // Remove the partial file: the disk may be full.
        let _ = fs::remove_file(&partial);
        with_path(path, &error)
    })
}

/// The path without links, also where the last link points to a file that does not exist yet.
fn link_target(path: &Path) -> Result<PathBuf> {
    const MOST_LINKS: usize = 40;
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(fs::canonicalize(&target).unwrap_or(target)),
        }
    }
    Err(format!("{}: expected at most {MOST_LINKS} links to follow, found more", path.display()).into())
}

/// Checks, before anything is computed, that several output files can be written, and that no two of them are
/// the same. Each comes with the option that names it.
pub fn check_outs<'a, P: AsRef<Path> + 'a>(
    outs: impl IntoIterator<Item = (&'static str, P)>,
    read: impl IntoIterator<Item = &'a Path> + Clone,
) -> Result<()> {
    let mut options = HashMap::new();
    for (option, out) in outs {
        let out = out.as_ref();
        check_writable(out, read.clone())?;
        let path = if is_standard(out) { out.to_owned() } else { absolute(&link_target(out)?) };
        // A pipe or a device can take several outputs.
        let takes_several = path.exists() && !path.is_file() && !is_standard(out);
        let Some(other) = options.insert(path, option).filter(|_| !takes_several) else { continue };
        if is_standard(out) {
            return Err(usage("-: expected one file on stdout, found two"));
        }
        return Err(usage(format!(
            "{option} {}: expected a file of its own, found that of {other}: the second would overwrite the first",
            out.display()
        )));
    }
    Ok(())
}

/// The absolute path of a file that may not exist yet: two spellings of one file become equal.
fn absolute(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let in_folder = || Some(fs::canonicalize(folder).ok()?.join(path.file_name()?));
    fs::canonicalize(path).ok().or_else(in_folder).unwrap_or_else(|| path.to_owned())
}

/// Checks, before anything is computed, that a file can be written and is not one of the files that are read.
pub fn check_writable<'a>(path: &Path, read: impl IntoIterator<Item = &'a Path>) -> Result<()> {
    if is_standard(path) {
        return Ok(());
    }
    let target = link_target(path)?;
    if read.into_iter().any(|read| fs::canonicalize(read).is_ok_and(|read| read == target)) {
        return Err(format!(
            "{}: expected another file to write to: this one is read, and would be lost",
            path.display()
        )
        .into());
    }
    if target.exists() {
        fs::OpenOptions::new().append(true).open(&target).map_err(|error| with_path(path, &error))?;
        if !target.is_file() {
            return Ok(());
        }
    }
    let partial = partial_file(&target);
    File::create(&partial).and_then(|_| fs::remove_file(&partial)).map_err(|error| with_path(path, &error))
}

/// The file in the same folder that takes the new text until it is complete. Its name has the process's id.
fn partial_file(path: &Path) -> PathBuf {
    let mut name = path.to_owned().into_os_string();
    name.push(format!(".{}.new", std::process::id()));
    name.into()
}

/// An error with the file that it is about.
pub fn with_path(path: &Path, error: &dyn Error) -> Box<dyn Error> {
    format!("{}: {error}", path.display()).into()
}

/// Whether a terminal would act on the character: controls move the cursor, colour or clear the screen, and
/// bidirectional controls show text in another order than it is written.
fn controls_terminal(c: char) -> bool {
    let bidirectional = ['\u{61c}', '\u{200e}', '\u{200f}'].contains(&c)
        || ('\u{202a}'..='\u{202e}').contains(&c)
        || ('\u{2066}'..='\u{2069}').contains(&c);
    bidirectional || (c.is_control() && c != '\n')
}

/// A text for a terminal, with codes for the characters on which a terminal would act. Names come from
/// strangers' files.
pub fn escape(text: &str) -> String {
    text.chars()
        .map(|c| if controls_terminal(c) { c.escape_default().to_string() } else { c.to_string() })
        .collect()
}

/// JSON in one line. It has JSON's own codes for the characters on which a terminal would act.
fn json_line(value: &impl Serialize) -> Result<String> {
    let text = serde_json::to_string(value)?.chars().fold(String::new(), |mut text, c| {
        if controls_terminal(c) {
            text += &format!("\\u{:04x}", u32::from(c));
        } else {
            text.push(c);
        }
        text
    });
    Ok(text + "\n")
}

/// Prints one JSON object and a line end.
pub fn print_json(value: &impl Serialize) -> Result<()> {
    print(&json_line(value)?)
}

/// The rows of a matrix, for a summary.
pub fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// Prints a summary as one JSON object: to stderr if one of the output files is stdout.
pub fn print_summary(value: &impl Serialize, outs: &[&Path]) -> Result<()> {
    if !outs.iter().any(|out| is_standard(out)) {
        return print_json(value);
    }
    // An error on stderr cannot be reported anywhere.
    let _ = write!(std::io::stderr(), "{}", json_line(value)?);
    Ok(())
}

/// Prints to stdout. A reader that stops early, such as `head`, is no error.
pub fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("stdout: {error}").into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn escapes_the_characters_on_which_a_terminal_would_act() {
        assert_eq!(escape("a\u{1b}[2J\u{7}\u{9b}é\nb"), "a\\u{1b}[2J\\u{7}\\u{9b}é\nb");
        assert_eq!(escape("\u{202e}gpj.\u{2066}\u{200f}"), "\\u{202e}gpj.\\u{2066}\\u{200f}");
    }

    #[test]
    fn prints_json_of_the_same_value_without_these_characters() {
        let name = "\u{1b}\u{9b}\u{202e}é\u{7f}\n";
        let line = json_line(&name).unwrap();
        assert_eq!(line, "\"\\u001b\\u009b\\u202eé\\u007f\\n\"\n");
        assert_eq!(serde_json::from_str::<String>(&line).unwrap(), name);
    }
}
