//! From tables to what a model trains on.

use crate::gp::linalg::stacked;
use crate::models::data::dataset::{Dataset, SequenceInfo};
use crate::motion::parts::{PartSpec, PartsLayout};
use crate::series::{Columns, SeriesError, Table, check_parts};

impl Dataset<Columns> {
    /// The tables as sequences, their columns in the order of the first, each without its mean and counted in
    /// its standard deviation. `rate` is the rows a second where the tables have no column of times.
    ///
    /// # Errors
    ///
    /// When there is no table, they do not go together, or the parts do not fit the columns.
    pub fn of_tables(tables: &[Table], parts: &[PartSpec], rate: f64) -> Result<Self, SeriesError> {
        let first = tables.first().ok_or(SeriesError::Empty)?;
        check_parts(parts, &first.columns)?;
        let tables = tables.iter().map(|table| table.like(first)).collect::<Result<Vec<_>, _>>()?;
        let mut all = stacked(tables.iter().map(|table| &table.values));
        let (rows, d) = all.shape();
        let column_means: Vec<f64> = all.row_mean().iter().copied().collect();
        let mut units = Vec::with_capacity(d);
        for (mut column, mean) in all.column_iter_mut().zip(&column_means) {
            column.add_scalar_mut(-mean);
            let deviation = (column.norm_squared() / rows as f64).sqrt();
            // What does not change beyond rounding has no size of its own.
            let unit = if deviation > 1e-9 * mean.abs().max(1e-3) { deviation } else { 1.0 };
            column /= unit;
            units.push(unit);
        }
        let layout = PartsLayout::of_columns(parts);
        let info = |table: &Table| SequenceInfo {
            name: table.name.clone(),
            sha256: table.sha256.clone(),
            frames: table.values.nrows(),
            rests_from: None,
            piece: None,
            bones_of: None,
            whole: true,
        };
        let frame_time = first.frame_time.unwrap_or(1.0 / rate);
        Ok(Self {
            y: layout.split(&all),
            layout,
            mapping: Columns::new(first.columns.clone(), units),
            column_means,
            sequences: tables.iter().map(info).collect(),
            frame_time,
            frames_per_second: 1.0 / frame_time,
            warnings: Vec::new(),
        })
    }
}
