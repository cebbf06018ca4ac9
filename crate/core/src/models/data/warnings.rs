//! Warnings about a data set from which a model learns less than its user expects.

use crate::models::data::sequences::SequenceInfo;
use crate::plural::counted;
use nalgebra::DMatrix;

/// A column changes when its largest and smallest value differ by more than this share of its size.
const TOLERANCE: f64 = 1e-9;
/// The least size of a column.
const LEAST_SIZE: f64 = 1e-3;
/// A sentence lists this many names; it counts the others.
const MOST_NAMES: usize = 3;

/// Whether each of the columns [rows x D] changes `[D]`.
pub fn changing_columns(rows: &DMatrix<f64>) -> Vec<bool> {
    let changes = |column: nalgebra::DVectorView<f64>| {
        let (lowest, highest) = (column.min(), column.max());
        highest - lowest > TOLERANCE * highest.abs().max(lowest.abs()).max(LEAST_SIZE)
    };
    rows.column_iter().map(changes).collect()
}

/// What a user calls a sequence.
pub struct Nouns {
    sequence: &'static str,
    row: &'static str,
    values: &'static str,
}

pub const CLIP: Nouns = Nouns { sequence: "clip", row: "frame", values: "pose" };
pub const TABLE: Nouns = Nouns { sequence: "table", row: "row", values: "values" };

/// A warning for each whole sequence in which no column changes, and for each sequence that has the same
/// content as an earlier one.
pub fn sequence_warnings(rows: &[DMatrix<f64>], sequences: &[SequenceInfo], nouns: &Nouns) -> Vec<String> {
    let Nouns { sequence, row, values } = nouns;
    let is_still =
        |(rows, info): &(&DMatrix<f64>, &SequenceInfo)| info.whole && !changing_columns(rows).contains(&true);
    let still = rows.iter().zip(sequences).filter(is_still).map(|(rows, info)| {
        let count = counted(rows.nrows(), row);
        format!("the {sequence} {} has the same {values} in all of its {count}", info.name)
    });
    let repeated = sequences.iter().enumerate().filter_map(|(place, info)| {
        let first = sequences[..place].iter().find(|earlier| has_same_content(earlier, info))?;
        let name = &info.name;
        Some(if first.name == *name {
            format!("the {sequence} {name} is given twice, so its {row}s count twice")
        } else {
            let first = &first.name;
            format!("the {sequence} {name} has the same content as {first}, so these {row}s count twice")
        })
    });
    still.chain(repeated).collect()
}

fn has_same_content(a: &SequenceInfo, b: &SequenceInfo) -> bool {
    !a.sha256.is_empty() && (&a.sha256, a.piece, a.whole) == (&b.sha256, b.piece, b.whole)
}

/// A warning about the columns or parts of these names, which never change; `None` where there are none.
pub fn constant_warning(kind: &str, names: &[&str]) -> Option<String> {
    let shown = names.iter().take(MOST_NAMES).copied().collect::<Vec<_>>().join(", ");
    match names.len() {
        0 => None,
        1 => Some(format!("the {kind} {shown} never changes, so a model learns nothing about it")),
        count => {
            let more =
                if count > MOST_NAMES { format!(" and {} more", count - MOST_NAMES) } else { String::new() };
            Some(format!("the {kind}s {shown}{more} never change, so a model learns nothing about them"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constant_columns_are_named_and_counted() {
        let said = |count: usize| constant_warning("column", &["a", "b", "c", "d", "e"][..count]);
        assert_eq!(said(0), None);
        assert!(said(1).unwrap().starts_with("the column a never changes, "));
        assert!(said(3).unwrap().starts_with("the columns a, b, c never change, "));
        assert!(said(5).unwrap().starts_with("the columns a, b, c and 2 more never change, "));
    }

    #[test]
    fn a_change_counts_beside_the_size_of_a_column() {
        // Of numbers near 0 and near 1000: the same, and changed by more than rounding.
        let rows = DMatrix::from_row_slice(2, 4, &[0.0, 0.0, -1000.0, -1000.0, 1e-13, 1e-3, -1000.0, -999.0]);
        assert_eq!(changing_columns(&rows), [false, true, false, true]);
        // The same change counts for small numbers, and is rounding for large ones.
        let rows = DMatrix::from_row_slice(2, 2, &[0.0, 1e6, 1e-8, 1e6 + 1e-8]);
        assert_eq!(changing_columns(&rows), [true, false]);
    }
}
