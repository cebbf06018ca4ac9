//! Tests of what holds for every command that reads clips: warnings.

use crate::call::{folder, json_and_stderr, run, text, under_a_still_root};
use serde_json::Value;
use std::path::PathBuf;

/// Two walks under a still root, a model and two libraries that were trained on them.
struct Files {
    folder: PathBuf,
    walk: String,
    other: String,
    model: String,
    library: String,
    stroll: String,
}

impl Files {
    fn new(name: &str) -> Self {
        let folder = folder(name);
        let file = |name: &str| text(&folder.join(name)).to_owned();
        let files = Files {
            walk: file("walk.bvh"),
            other: file("other.bvh"),
            model: file("model.json"),
            library: file("library.json"),
            stroll: file("stroll.json"),
            folder,
        };
        under_a_still_root("sample:walk-1", 0.0, files.walk.as_ref());
        under_a_still_root("sample:walk-2", 0.0, files.other.as_ref());
        files
    }

    /// The summary of a command line with the names of files in braces, and its lines on stderr.
    fn run(&self, line: &str) -> (Value, String) {
        let line = self.line(line);
        json_and_stderr(&line.iter().map(String::as_str).collect::<Vec<_>>())
    }

    fn line(&self, line: &str) -> Vec<String> {
        let word = |word: &str| {
            let named = [
                ("{walk}", &self.walk),
                ("{other}", &self.other),
                ("{model}", &self.model),
                ("{library}", &self.library),
                ("{stroll}", &self.stroll),
            ];
            let named =
                named.into_iter().fold(word.to_owned(), |word, (name, file)| word.replace(name, file));
            named.replace("{folder}", text(&self.folder))
        };
        line.split_whitespace().map(word).collect()
    }

    fn train(&self) {
        let small =
            "--parts lower,upper --fps 10 --latent 2 --dynamics-ips 4 --pose-ips 4 --max-iterations 3";
        self.run(&format!("train {{walk}} {small} --out {{model}}"));
        self.run(&format!("train --movement a={{walk}} --movement b={{other}} {small} --out {{library}}"));
        self.run(&format!("train --movement stroll={{other}} {small} --out {{stroll}}"));
    }
}

#[test]
fn every_command_says_once_what_is_unusual_in_a_clip() {
    let files = Files::new("warnings");
    files.train();
    let split = "--parts lower,upper --fps 10";
    for line in [
        &format!("train {{walk}} {split} --max-iterations 1 --out {{folder}}/again.json"),
        &format!("train --movement a={{walk}} {split} --max-iterations 1 --out {{folder}}/again.json"),
        "complete {model} {walk} --given lower",
        "rollout {model} --frames 12 --from {walk}:5 --out {folder}/out.bvh",
        "score {model} {walk}",
        "reproduce {model} {walk}",
        "recognise {library} {walk}",
        "couple {library} --use lower=a,upper=b --clip {walk} --max-iterations 1 --out {folder}/fitted.json",
        "primitives {library} --add {stroll} --relearn --max-iterations 1 --clip {walk} --out {folder}/two.json",
        &format!("evaluate {{walk}} {{other}} {split} --models dmp-rhythmic --out {{folder}}/results.json"),
        "study {folder}/results.json {walk} {other} --out {folder}/study.json",
    ] {
        let (_, err) = files.run(line);
        let said = err.matches("vcgpdm: walk.bvh: the root \"rig:Reference\" only carries").count();
        assert_eq!(said, 1, "{line}: {err}");
    }
    // The summary of a clip has the warnings.
    let clip = run(&["clip", &files.walk]);
    assert!(clip.stderr.is_empty() && String::from_utf8(clip.stdout).unwrap().contains("only carries"));
}
