//! `rust-imports ROOT`: checks the crates that `order.txt` names, below the folder ROOT. It prints each
//! offence and ends with status 1 when it found one.

mod graph;
mod order;
mod source;

use graph::Graph;
use order::Order;
use std::{error::Error, fs, path::Path, process::ExitCode};

/// Lines of code of a file, without comments and empty lines.
const MAX_LINES: usize = 400;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let root = std::env::args().nth(1).ok_or("expected the root of the project")?;
    let orders = order::parse(include_str!("../order.txt"))?;
    let mut offences = Vec::new();
    for order in &orders {
        let folder = Path::new(&root).join(&order.folder);
        offences.extend(check(&folder.join("src"), order)?);
        for file in source::rust_files(&folder)? {
            let lines = lines_of_code(&fs::read_to_string(&file)?);
            if lines > MAX_LINES {
                offences.push(format!("{}: {lines} lines, at most {MAX_LINES}", file.display()));
            }
        }
    }
    for offence in &offences {
        println!("{offence}");
    }
    Ok(if offences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn check(sources: &Path, order: &Order) -> Result<Vec<String>, Box<dyn Error>> {
    let graph = Graph::new(source::read(sources)?);
    let mut offences = order.unlisted(graph.files());
    offences.extend(order.offences(&graph.uses(true)));
    offences.extend(graph::circles(&graph.uses(false)).into_iter().map(|files| files.join(" -> ")));
    Ok(offences.into_iter().map(|offence| format!("{}: {offence}", order.folder)).collect())
}

fn lines_of_code(text: &str) -> usize {
    text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_code_is_neither_empty_nor_a_comment() {
        assert_eq!(lines_of_code("//! Why.\n\nfn f() {\n    // and how\n} // end\n"), 2);
    }
}
