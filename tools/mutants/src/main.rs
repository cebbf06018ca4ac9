//! `mutants SHARE SKIPPED FOLDER ...`: changes operators in the Rust files of the folders, such as `+` into `-`.
//! All changes are in the same program: change k acts when `crate::mutant(k)` is true. SHARE is K/N: of all
//! possible changes only every Nth from number K on is made, without the numbers in the list SKIPPED. Prints a
//! line for each change: its number, file, line and operators.

use std::{collections::BTreeSet, error::Error, fs, path::Path};
use syn::visit_mut::{self, VisitMut};
use syn::{BinOp, Expr, UnOp, parse_quote, spanned::Spanned};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [share, skipped, folders @ ..] = arguments.as_slice() else {
        return Err("expected SHARE SKIPPED FOLDER ...".into());
    };
    let (part, parts) = share.split_once('/').ok_or("expected a share such as 0/100")?;
    let numbers = skipped.split(',').filter(|number| !number.is_empty());
    let skipped = numbers.map(|number| number.parse()).collect::<Result<_, _>>()?;
    let mut changer =
        Changer { next: 0, part: part.parse()?, parts: parts.parse()?, skipped, file: String::new() };
    folders.iter().try_for_each(|folder| change_folder(Path::new(folder), &mut changer))
}

fn change_folder(folder: &Path, changer: &mut Changer) -> Result<(), Box<dyn Error>> {
    let mut paths =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>, std::io::Error>>()?;
    paths.sort();
    for path in paths {
        if path.is_dir() {
            change_folder(&path, changer)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") && !path.ends_with("tests.rs") {
            let mut code = syn::parse_file(&fs::read_to_string(&path)?)?;
            changer.file = path.display().to_string();
            changer.visit_file_mut(&mut code);
            fs::write(&path, prettyplease::unparse(&code))?;
        }
    }
    Ok(())
}

struct Changer {
    next: usize,
    part: usize,
    parts: usize,
    skipped: BTreeSet<usize>,
    file: String,
}

impl Changer {
    /// The number of the next change, when it is in the share.
    fn number(&mut self, expression: &Expr, operator: &str) -> Option<usize> {
        let number = self.next;
        self.next += 1;
        if number % self.parts != self.part || self.skipped.contains(&number) {
            return None;
        }
        println!("{number}\t{}\t{}\t{operator}", self.file, expression.span().start().line);
        Some(number)
    }
}

/// The operator in place of another, and its name.
fn replacement(operator: &BinOp) -> Option<(BinOp, &'static str)> {
    Some(match operator {
        BinOp::Add(_) => (parse_quote!(-), "+ to -"),
        BinOp::Sub(_) => (parse_quote!(+), "- to +"),
        BinOp::Mul(_) => (parse_quote!(/), "* to /"),
        BinOp::Div(_) => (parse_quote!(*), "/ to *"),
        BinOp::AddAssign(_) => (parse_quote!(-=), "+= to -="),
        BinOp::SubAssign(_) => (parse_quote!(+=), "-= to +="),
        BinOp::MulAssign(_) => (parse_quote!(/=), "*= to /="),
        BinOp::DivAssign(_) => (parse_quote!(*=), "/= to *="),
        BinOp::Lt(_) => (parse_quote!(>=), "< to >="),
        BinOp::Le(_) => (parse_quote!(>), "<= to >"),
        BinOp::Gt(_) => (parse_quote!(<=), "> to <="),
        BinOp::Ge(_) => (parse_quote!(<), ">= to <"),
        BinOp::Eq(_) => (parse_quote!(!=), "== to !="),
        BinOp::Ne(_) => (parse_quote!(==), "!= to =="),
        BinOp::And(_) => (parse_quote!(||), "&& to ||"),
        BinOp::Or(_) => (parse_quote!(&&), "|| to &&"),
        _ => return None,
    })
}

fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("cfg") || attribute.path().is_ident("test"))
}

impl VisitMut for Changer {
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        if let Expr::Repeat(repeat) = expression {
            return self.visit_expr_mut(&mut repeat.expr);
        }
        visit_mut::visit_expr_mut(self, expression);
        let changed: Expr = match &*expression {
            Expr::Binary(binary) => {
                let has_let = |side: &Expr| matches!(side, Expr::Let(_));
                let Some((other, name)) = replacement(&binary.op) else { return };
                if has_let(&binary.left) || has_let(&binary.right) {
                    return;
                }
                let Some(number) = self.number(expression, name) else { return };
                let (left, op, right) = (&binary.left, &binary.op, &binary.right);
                let comparison = matches!(
                    op,
                    BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) | BinOp::Eq(_) | BinOp::Ne(_)
                );
                let arithmetic = matches!(op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_));
                // A match keeps the temporary values of both sides alive.
                if comparison {
                    parse_quote!((match (&(#left), &(#right)) {
                        (l, r) => if crate::mutant(#number) { *l #other *r } else { *l #op *r }
                    }))
                } else if arithmetic {
                    parse_quote!((match (#left, #right) {
                        (l, r) => if crate::mutant(#number) { l #other r } else { l #op r }
                    }))
                } else {
                    parse_quote!((if crate::mutant(#number) { #left #other #right } else { #left #op #right }))
                }
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_) | UnOp::Not(_)) => {
                let Some(number) = self.number(expression, "without - or !") else { return };
                let (op, inner) = (&unary.op, &unary.expr);
                parse_quote!((match #inner { x => if crate::mutant(#number) { x } else { #op x } }))
            }
            _ => return,
        };
        *expression = changed;
    }

    fn visit_item_mod_mut(&mut self, item: &mut syn::ItemMod) {
        if !is_for_tests(&item.attrs) {
            visit_mut::visit_item_mod_mut(self, item);
        }
    }

    fn visit_item_fn_mut(&mut self, item: &mut syn::ItemFn) {
        if item.sig.constness.is_none() && !is_for_tests(&item.attrs) {
            visit_mut::visit_item_fn_mut(self, item);
        }
    }

    fn visit_impl_item_fn_mut(&mut self, item: &mut syn::ImplItemFn) {
        if item.sig.constness.is_none() && !is_for_tests(&item.attrs) {
            visit_mut::visit_impl_item_fn_mut(self, item);
        }
    }

    // The compiler computes these itself.
    fn visit_item_const_mut(&mut self, _: &mut syn::ItemConst) {}
    fn visit_item_static_mut(&mut self, _: &mut syn::ItemStatic) {}
    fn visit_impl_item_const_mut(&mut self, _: &mut syn::ImplItemConst) {}
    fn visit_trait_item_const_mut(&mut self, _: &mut syn::TraitItemConst) {}
    fn visit_type_mut(&mut self, _: &mut syn::Type) {}
    fn visit_pat_mut(&mut self, _: &mut syn::Pat) {}
    fn visit_generic_argument_mut(&mut self, _: &mut syn::GenericArgument) {}
    fn visit_attribute_mut(&mut self, _: &mut syn::Attribute) {}
}
