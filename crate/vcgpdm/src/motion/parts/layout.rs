//! Which columns of Y belong to which part.

use crate::motion::parts::spec::{PartSpec, PartsError, check};
use crate::motion::pose::PoseMapping;
use nalgebra::DMatrix;

/// Which columns of Y belong to which part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartsLayout {
    parts: Vec<PartSpec>,
    columns: Vec<Vec<usize>>,
}

impl PartsLayout {
    /// The layout for these parts of the mapping's body.
    ///
    /// # Errors
    ///
    /// When a column has no part or two parts, or a part has no column.
    pub fn new(parts: &[PartSpec], mapping: &PoseMapping) -> Result<PartsLayout, PartsError> {
        check(parts, mapping.skeleton())?;
        let mapped = mapping.columns();
        let columns = (parts.iter())
            .map(|part| {
                (0..mapped.len()).filter(|&column| part.joints.contains(&mapped[column].joint)).collect()
            })
            .collect();
        Ok(PartsLayout { parts: parts.to_vec(), columns })
    }

    /// The layout of the parts of a table, whose `joints` are columns.
    pub fn for_table(parts: &[PartSpec]) -> PartsLayout {
        let sorted = |part: &PartSpec| {
            let mut columns = part.joints.clone();
            columns.sort_unstable();
            columns
        };
        PartsLayout { parts: parts.to_vec(), columns: parts.iter().map(sorted).collect() }
    }

    /// The parts, in their order.
    pub fn parts(&self) -> &[PartSpec] {
        &self.parts
    }

    /// The columns of a part in Y, ascending; empty for a part that does not exist.
    pub fn columns(&self, part: usize) -> &[usize] {
        self.columns.get(part).map_or(&[], Vec::as_slice)
    }

    /// Splits Y [frames x columns] into Y^i [frames x columns of part i], one for each part.
    pub fn split(&self, y: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        self.columns.iter().map(|columns| y.select_columns(columns)).collect()
    }
}
