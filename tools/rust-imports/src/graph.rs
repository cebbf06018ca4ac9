//! Which files of a crate use each other.

use crate::source::{Segments, Source};
use std::collections::{BTreeMap, BTreeSet};

/// A file and a file that it uses, both below `src`.
pub type Use = (String, String);

/// Re-exports of re-exports are followed this far.
const MAX_DEPTH: usize = 8;

pub struct Graph {
    sources: Vec<Source>,
    by_module: BTreeMap<Segments, usize>,
    test_modules: Vec<Segments>,
}

impl Graph {
    pub fn new(sources: Vec<Source>) -> Self {
        let by_module = sources.iter().enumerate().map(|(i, source)| (source.module.clone(), i)).collect();
        let test_modules = sources.iter().flat_map(|source| source.test_modules.clone()).collect();
        Self { sources, by_module, test_modules }
    }

    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|source| source.file.as_str())
    }

    /// The file that defines what a path names: a re-export leads on to its origin.
    fn file_of(&self, path: &[String], depth: usize) -> Option<&Source> {
        let length = (0..=path.len()).rev().find(|&length| self.by_module.contains_key(&path[..length]))?;
        let source = &self.sources[self.by_module[&path[..length]]];
        let Some(name) = path.get(length) else { return Some(source) };
        match source.imports.iter().find(|import| import.name == *name && !import.test) {
            Some(import) if depth < MAX_DEPTH => {
                self.file_of(&[&import.path, &path[length + 1..]].concat(), depth + 1)
            }
            _ => Some(source),
        }
    }

    /// All uses; without `tests` those of product code. A re-export of a name from below is a use only where
    /// the file needs the name itself.
    pub fn uses(&self, tests: bool) -> Vec<Use> {
        let mut uses = BTreeSet::new();
        for source in &self.sources {
            let whole_file = self.test_modules.iter().any(|module| source.module.starts_with(module));
            let counts = |test: bool| tests || !(test || whole_file);
            let mut add = |path: &[String]| {
                if let Some(to) = self.file_of(path, 0).filter(|to| to.file != source.file) {
                    uses.insert((source.file.clone(), to.file.clone()));
                }
            };
            for import in source.imports.iter().filter(|import| counts(import.test)) {
                let from_below = import.public && import.path.starts_with(&source.module);
                if !from_below || source.words.contains(&import.name) {
                    add(import.path.strip_suffix(&["*".to_owned()]).unwrap_or(&import.path));
                }
            }
            for mention in source.mentions.iter().filter(|mention| counts(mention.test)) {
                add(&mention.path);
            }
        }
        uses.into_iter().collect()
    }
}

/// Circles of files that use each other; each begins and ends with the same file.
pub fn circles(uses: &[Use]) -> Vec<Vec<&str>> {
    let mut next: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (from, to) in uses {
        next.entry(from).or_default().push(to);
    }
    let (mut done, mut found) = (BTreeSet::new(), Vec::new());
    for file in next.keys() {
        visit(file, &next, &mut Vec::new(), &mut done, &mut found);
    }
    found
}

fn visit<'a>(
    file: &'a str,
    next: &BTreeMap<&'a str, Vec<&'a str>>,
    path: &mut Vec<&'a str>,
    done: &mut BTreeSet<&'a str>,
    found: &mut Vec<Vec<&'a str>>,
) {
    if let Some(start) = path.iter().position(|earlier| *earlier == file) {
        found.push([&path[start..], &[file]].concat());
        return;
    }
    if done.contains(file) {
        return;
    }
    path.push(file);
    for used in next.get(file).into_iter().flatten() {
        visit(used, next, path, done, found);
    }
    path.pop();
    done.insert(file);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::parse;

    const GP: [(&str, &str); 2] =
        [("gp/mod.rs", "mod kernel;\npub use kernel::Kernel;"), ("gp/kernel.rs", "pub struct Kernel;")];

    /// The uses of a small crate, as `from > to`.
    fn uses(files: &[(&str, &str)], tests: bool) -> Vec<String> {
        let sources = files.iter().map(|(file, text)| parse(file, text).unwrap()).collect();
        Graph::new(sources).uses(tests).into_iter().map(|(from, to)| format!("{from} > {to}")).collect()
    }

    fn uses_with_gp(file: &str, text: &str) -> Vec<String> {
        uses(&[GP[0], GP[1], (file, text)], false)
    }

    #[test]
    fn a_use_leads_to_the_file_that_defines_the_name() {
        for text in [
            "use crate::gp::Kernel;",
            "use crate::{gp::{Kernel as K}};",
            "fn f() { crate::gp::Kernel::new() }",
            "fn f() { assert!(crate::gp::Kernel::new()) }",
            "fn f(x: Vec<crate::gp::Kernel>) {}",
        ] {
            assert_eq!(uses_with_gp("a.rs", text), ["a.rs > gp/kernel.rs"], "{text}");
        }
        assert_eq!(uses_with_gp("gp/a.rs", "use super::Kernel;"), ["gp/a.rs > gp/kernel.rs"]);
        assert_eq!(uses_with_gp("gp/a.rs", "use super::*;"), ["gp/a.rs > gp/mod.rs"]);
    }

    #[test]
    fn a_re_export_counts_only_when_the_file_uses_the_name() {
        assert_eq!(uses(&GP, false), [""; 0]);
        let used = format!("{} fn f(k: Kernel) {{}}", GP[0].1);
        assert_eq!(uses(&[(GP[0].0, &used), GP[1]], false), ["gp/mod.rs > gp/kernel.rs"]);
        assert_eq!(uses_with_gp("a/mod.rs", "pub use crate::gp::Kernel;"), ["a/mod.rs > gp/kernel.rs"]);
    }

    #[test]
    fn comments_texts_visibility_and_other_crates_do_not_count() {
        let text = r#"/* crate::gp */ use std::gp; const A: &str = "crate::gp"; pub(super) fn f() {}"#;
        assert_eq!(uses_with_gp("gp/a.rs", text), [""; 0]);
    }

    #[test]
    fn uses_of_tests_count_on_request() {
        let inline = "#[cfg(test)]\nmod tests { use super::*; use crate::gp::Kernel; }";
        let files = [
            GP[0],
            GP[1],
            ("a.rs", inline),
            ("b/mod.rs", "#[cfg(test)]\nmod tests;"),
            ("b/tests.rs", "use crate::gp;"),
        ];
        assert_eq!(uses(&files, false), [""; 0]);
        assert_eq!(uses(&files, true), ["a.rs > gp/kernel.rs", "b/tests.rs > gp/mod.rs"]);
    }

    #[test]
    fn finds_a_circle_of_any_length() {
        let uses = |pairs: &[(&str, &str)]| -> Vec<Use> {
            pairs.iter().map(|(from, to)| ((*from).to_owned(), (*to).to_owned())).collect()
        };
        assert!(circles(&uses(&[("a", "b"), ("b", "c"), ("a", "c")])).is_empty());
        let circle = uses(&[("a", "b"), ("b", "c"), ("c", "d"), ("d", "b")]);
        assert_eq!(circles(&circle), [["b", "c", "d", "b"]]);
    }
}
