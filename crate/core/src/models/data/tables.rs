//! From tables to training data.

use crate::gp::linalg::stacked;
use crate::models::data::dataset::Dataset;
use crate::models::data::sequences::SequenceInfo;
use crate::models::data::warnings::{TABLE, changing_columns, constant_warning, sequence_warnings};
use crate::motion::parts::{PartSpec, PartsLayout};
use crate::series::{Columns, SeriesError, Table, check_parts};

impl Dataset<Columns> {
    /// The tables as sequences. Their columns are in the order of the first table; each is centred and
    /// divided by its standard deviation. `rate` is the number of rows a second for tables without times.
    ///
    /// # Errors
    ///
    /// When there is no table, the tables have other columns or rates, or the parts do not fit the columns.
    pub fn of_tables(tables: &[Table], parts: &[PartSpec], rate: f64) -> Result<Self, SeriesError> {
        let first = tables.first().ok_or(SeriesError::Empty)?;
        check_parts(parts, &first.columns)?;
        let tables = tables.iter().map(|table| table.like(first)).collect::<Result<Vec<_>, _>>()?;
        let rows: Vec<_> = tables.iter().map(|table| table.values.clone()).collect();
        let mut all = stacked(&rows);
        let changing = changing_columns(&all);
        let (count, d) = all.shape();
        let column_means: Vec<f64> = all.row_mean().iter().copied().collect();
        let mut units = Vec::with_capacity(d);
        for (mut column, mean) in all.column_iter_mut().zip(&column_means) {
            column.add_scalar_mut(-mean);
            let deviation = (column.norm_squared() / count as f64).sqrt();
            // A column that changes by rounding alone has no size of its own.
            let unit = if deviation > 1e-9 * mean.abs().max(1e-3) { deviation } else { 1.0 };
            column /= unit;
            units.push(unit);
        }
        let layout = PartsLayout::for_table(parts);
        let info = |table: &Table| SequenceInfo {
            name: table.name.clone(),
            sha256: table.sha256.clone(),
            frames: table.values.nrows(),
            rests_from: None,
            piece: None,
            bones_of: None,
            whole: true,
        };
        let sequences: Vec<SequenceInfo> = tables.iter().map(info).collect();
        let own = |table: &Table| -> Vec<String> {
            table.warnings.iter().map(|warning| format!("{}: {warning}", table.name)).collect()
        };
        let mut warnings: Vec<String> = tables.iter().flat_map(own).collect();
        warnings.extend(sequence_warnings(&rows, &sequences, &TABLE));
        let names = first.columns.iter().zip(changing).filter(|(_, changes)| !changes);
        let names: Vec<&str> = names.map(|(name, _)| name.as_str()).collect();
        // In a data set of still tables, each table has its warning.
        if names.len() < d {
            warnings.extend(constant_warning("column", &names));
        }
        let frame_time = first.frame_time.unwrap_or(1.0 / rate);
        Ok(Self {
            y: layout.split(&all),
            layout,
            mapping: Columns::new(first.columns.clone(), units),
            column_means,
            sequences,
            frame_time,
            frames_per_second: 1.0 / frame_time,
            warnings,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::series::{read, whole};

    fn table(name: &str, text: &str) -> Table {
        read(name, text.as_bytes()).unwrap()
    }

    fn warnings(tables: &[Table]) -> Vec<String> {
        Dataset::of_tables(tables, &whole(tables[0].columns.len()), 30.0).unwrap().warnings
    }

    #[test]
    fn warns_of_still_tables_constant_columns_and_a_table_given_twice() {
        let moving = table("a.csv", "x,y,z\n1,5,2\n2,5,3\n4,5,2\n");
        let still = table("b.csv", "x,y,z\n1,5,2\n1,5,2\n");
        let again = Table { name: "c.csv".to_owned(), ..moving.clone() };
        assert_eq!(
            warnings(&[moving.clone(), still.clone(), again]),
            [
                "the table b.csv has the same values in all of its 2 rows",
                "the table c.csv has the same content as a.csv, so these rows count twice",
                "the column y never changes, so a model learns nothing about it",
            ]
        );
        assert_eq!(warnings(&[still]), ["the table b.csv has the same values in all of its 2 rows"]);
        assert!(warnings(&[table("d.csv", "x,y\n1,2\n3,1\n")]).is_empty());
    }

    #[test]
    fn the_unit_of_a_column_that_changes_by_rounding_alone_is_1() {
        let table = table("a.csv", "near 0,near a million\n1e-7,1000000.00001\n-1e-7,999999.99999\n");
        let units = Dataset::of_tables(&[table], &whole(2), 30.0).unwrap().mapping.units().to_vec();
        assert!((units[0] - 1e-7).abs() < 1e-15 && units[1] == 1.0, "{units:?}");
    }

    #[test]
    fn a_table_without_times_has_the_rate_asked_for() {
        let dataset = Dataset::of_tables(&[table("a.csv", "x\n1\n2\n")], &whole(1), 25.0).unwrap();
        assert_eq!((dataset.frame_time, dataset.frames_per_second), (0.04, 25.0));
    }
}
