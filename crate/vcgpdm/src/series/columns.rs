//! What the columns of a model of tables are.

/// The columns of tables: their names, and the unit in which a model counts each.
///
/// A model counts a column in its standard deviations, because one noise variance belongs to all columns of a
/// part: otherwise metres and volts would count by their size.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    pub(crate) names: Vec<String>,
    pub(crate) units: Vec<f64>,
}

impl Columns {
    /// Columns of these names, counted in these units: as many, all positive.
    pub(crate) fn new(names: Vec<String>, units: Vec<f64>) -> Self {
        Self { names, units }
    }

    /// The names, in the order of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The unit of each column: its standard deviation over all training frames, or 1 where it does not
    /// change.
    pub fn units(&self) -> &[f64] {
        &self.units
    }
}
