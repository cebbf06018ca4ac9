//! The paths that a Rust file names, read by the parser syn.

use proc_macro2::{TokenStream, TokenTree};
use std::{error::Error, fs, path::Path, path::PathBuf};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Macro, UseTree, VisRestricted, Visibility};

/// Segments of a path; in a [`Source`] they begin at the root of the crate.
pub type Segments = Vec<String>;

/// A name that `use` brings into a module; `*` for all names.
pub struct Import {
    pub name: String,
    pub path: Segments,
    pub public: bool,
    pub test: bool,
}

/// A path in the code itself.
pub struct Mention {
    pub path: Segments,
    pub test: bool,
}

/// One file.
pub struct Source {
    /// Below `src`, such as `gp/psi/mod.rs`.
    pub file: String,
    /// `gp::psi` for gp/psi.rs and for gp/psi/mod.rs; empty for lib.rs and main.rs.
    pub module: Segments,
    pub imports: Vec<Import>,
    pub mentions: Vec<Mention>,
    /// First segments of all paths in product code, and all words in its macros.
    pub words: Vec<String>,
    /// Modules in other files that only tests see.
    pub test_modules: Vec<Segments>,
}

/// All Rust files below a folder, sorted.
pub fn rust_files(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// The files below a crate's folder `src`.
pub fn read(sources: &Path) -> Result<Vec<Source>, Box<dyn Error>> {
    let mut all = Vec::new();
    for path in rust_files(sources)? {
        let file = path.strip_prefix(sources)?.to_string_lossy().replace('\\', "/");
        let text = fs::read_to_string(&path)?;
        all.push(parse(&file, &text).map_err(|error| format!("{}: {error}", path.display()))?);
    }
    Ok(all)
}

/// Reads the text of one file.
pub fn parse(file: &str, text: &str) -> syn::Result<Source> {
    let mut module: Segments = file.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if matches!(module.last().map(String::as_str), Some("mod" | "lib" | "main")) {
        module.pop();
    }
    let code = syn::parse_file(text)?;
    let mut reader =
        Reader { place: module.clone(), children: vec![child_modules(&code.items)], ..Reader::default() };
    reader.visit_file(&code);
    let Reader { imports, mentions, words, test_modules, .. } = reader;
    Ok(Source { file: file.to_owned(), module, imports, mentions, words, test_modules })
}

fn child_modules(items: &[Item]) -> Vec<String> {
    let names = items
        .iter()
        .map(|item| if let Item::Mod(child) = item { Some(child.ident.to_string()) } else { None });
    names.flatten().collect()
}

#[derive(Default)]
struct Reader {
    /// The module that the reader is in, with modules inside the file.
    place: Segments,
    /// The child modules of each module from the file down to `place`.
    children: Vec<Vec<String>>,
    test: bool,
    imports: Vec<Import>,
    mentions: Vec<Mention>,
    words: Vec<String>,
    test_modules: Vec<Segments>,
}

impl Reader {
    /// The path from the root of the crate; none when it leads to another crate.
    fn absolute(&self, path: &[String]) -> Option<Segments> {
        let first = path.first()?;
        match first.as_str() {
            "crate" => Some(path[1..].to_vec()),
            "self" => Some([&self.place, &path[1..]].concat()),
            "super" => {
                let ups = path.iter().take_while(|segment| *segment == "super").count();
                let kept = self.place.len().checked_sub(ups)?;
                Some([&self.place[..kept], &path[ups..]].concat())
            }
            _ if self.children.last()?.contains(first) => Some([&self.place[..], path].concat()),
            _ => None,
        }
    }

    fn mention(&mut self, path: &[String]) {
        if !self.test {
            self.words.extend(path.first().cloned());
        }
        if let Some(path) = self.absolute(path) {
            self.mentions.push(Mention { path, test: self.test });
        }
    }

    fn import(&mut self, tree: &UseTree, before: &[String], public: bool) {
        let (last, name) = match tree {
            UseTree::Path(path) => {
                return self.import(&path.tree, &[before, &[path.ident.to_string()]].concat(), public);
            }
            UseTree::Group(group) => {
                return group.items.iter().for_each(|item| self.import(item, before, public));
            }
            UseTree::Name(name) => (name.ident.to_string(), name.ident.to_string()),
            UseTree::Rename(rename) => (rename.ident.to_string(), rename.rename.to_string()),
            UseTree::Glob(_) => ("*".to_owned(), "*".to_owned()),
        };
        let itself = last == "self" && !before.is_empty();
        let path = if itself { before.to_vec() } else { [before, &[last]].concat() };
        let name = if name == "self" { path.last().cloned().unwrap_or_default() } else { name };
        if let Some(path) = self.absolute(&path) {
            self.imports.push(Import { name, path, public, test: self.test });
        }
    }

    /// Macros hold tokens, not paths: `a::b` is put together again.
    fn mention_tokens(&mut self, tokens: TokenStream) {
        let mut path: Segments = Vec::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Ident(ident) => {
                    if colons != 2 {
                        self.mention(&std::mem::take(&mut path));
                    }
                    path.push(ident.to_string());
                    colons = 0;
                    continue;
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' => {
                    colons += 1;
                    continue;
                }
                TokenTree::Group(group) => self.mention_tokens(group.stream()),
                _ => {}
            }
            self.mention(&std::mem::take(&mut path));
            colons = 0;
        }
        self.mention(&path);
    }
}

fn is_for_tests(item: &Item) -> bool {
    let attributes: &[Attribute] = match item {
        Item::Mod(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Const(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        _ => &[],
    };
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        _ => false,
    })
}

impl<'a> Visit<'a> for Reader {
    fn visit_item(&mut self, item: &'a Item) {
        let before = self.test;
        self.test |= is_for_tests(item);
        visit::visit_item(self, item);
        self.test = before;
    }

    fn visit_item_mod(&mut self, module: &'a ItemMod) {
        self.place.push(module.ident.to_string());
        if let Some((_, items)) = &module.content {
            self.children.push(child_modules(items));
            visit::visit_item_mod(self, module);
            self.children.pop();
        } else if self.test {
            self.test_modules.push(self.place.clone());
        }
        self.place.pop();
    }

    fn visit_item_use(&mut self, item: &'a ItemUse) {
        self.import(&item.tree, &[], !matches!(item.vis, Visibility::Inherited));
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        let segments: Segments = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.mention(&segments);
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, item: &'a Macro) {
        visit::visit_macro(self, item);
        self.mention_tokens(item.tokens.clone());
    }

    // `pub(super)` and attributes use nothing.
    fn visit_vis_restricted(&mut self, _: &'a VisRestricted) {}
    fn visit_attribute(&mut self, _: &'a Attribute) {}
}
