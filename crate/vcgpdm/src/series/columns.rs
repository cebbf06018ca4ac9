//! The columns of a model of tables.

/// The columns of tables: their names and units.
///
/// A model divides each column by its unit, the standard deviation, because all columns of a part have one
/// noise variance. Otherwise the weight of a column would depend on its physical unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    pub(crate) names: Vec<String>,
    pub(crate) units: Vec<f64>,
}

impl Columns {
    /// Columns with these names and as many positive units.
    pub(crate) fn new(names: Vec<String>, units: Vec<f64>) -> Self {
        Self { names, units }
    }

    /// The names, in the order of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The unit of each column: its standard deviation over all training frames, or 1 for a constant column.
    pub fn units(&self) -> &[f64] {
        &self.units
    }
}
