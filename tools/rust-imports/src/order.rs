//! The order of the modules of a crate, as `order.txt` states it.

use crate::graph::Use;

/// The modules of one crate.
pub struct Order {
    /// The folder of the crate.
    pub folder: String,
    /// Modules by line; a module uses only modules of earlier lines. Empty: every order is allowed.
    lines: Vec<Vec<String>>,
}

/// Reads `order.txt`: a crate begins at the margin, its modules are indented. `#` begins a comment.
pub fn parse(text: &str) -> Result<Vec<Order>, String> {
    let mut orders: Vec<Order> = Vec::new();
    for line in text.lines() {
        let code = line.split('#').next().unwrap_or_default();
        if code.trim().is_empty() {
            continue;
        }
        if !code.starts_with(' ') {
            orders.push(Order { folder: code.trim().to_owned(), lines: Vec::new() });
            continue;
        }
        let order = orders.last_mut().ok_or_else(|| format!("expected a crate before \"{line}\""))?;
        order.lines.push(code.split(',').map(|name| name.trim().to_owned()).collect());
    }
    Ok(orders)
}

/// `motion/bvh/parse.rs` is in the module `motion`, `words.rs` in `words`.
fn module(file: &str) -> &str {
    file.split('/').next().unwrap_or(file).trim_end_matches(".rs")
}

impl Order {
    fn line(&self, module: &str) -> Option<usize> {
        self.lines.iter().position(|modules| modules.iter().any(|name| name == module))
    }

    /// Modules without a line in the order.
    pub fn unlisted<'a>(&self, files: impl Iterator<Item = &'a str>) -> Vec<String> {
        let mut modules: Vec<&str> = files.filter(|file| *file != "lib.rs").map(module).collect();
        modules.dedup();
        let strange = modules.into_iter().filter(|name| !self.lines.is_empty() && self.line(name).is_none());
        strange.map(|name| format!("{name} is missing in order.txt")).collect()
    }

    /// Uses of a module on the same line or on a later one.
    pub fn offences(&self, uses: &[Use]) -> Vec<String> {
        let allowed = |(from, to): &&Use| {
            let (user, used) = (module(from), module(to));
            let free = self.lines.is_empty() || from == "lib.rs" || user == used;
            free || matches!((self.line(used), self.line(user)), (Some(a), Some(b)) if a < b)
        };
        let offences = uses.iter().filter(|use_| !allowed(use_));
        offences.map(|(from, to)| format!("{from} uses {to}, against order.txt")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order() -> Order {
        parse("# Order\na/b\n  base # first\n  left, right\n  top\n").unwrap().remove(0)
    }

    #[test]
    fn a_module_uses_itself_and_earlier_lines_only() {
        let uses = [
            ("top/a.rs", "base.rs"),
            ("top/a.rs", "top/b.rs"),
            ("left.rs", "right.rs"),
            ("base.rs", "top/a.rs"),
        ];
        let uses = uses.map(|(from, to)| (from.to_owned(), to.to_owned()));
        let offences =
            ["left.rs uses right.rs, against order.txt", "base.rs uses top/a.rs, against order.txt"];
        assert_eq!(order().offences(&uses), offences);
    }

    #[test]
    fn each_module_has_a_line() {
        let files = ["base.rs", "lib.rs", "new/a.rs", "new/b.rs"];
        assert_eq!(order().unlisted(files.into_iter()), ["new is missing in order.txt"]);
    }
}
