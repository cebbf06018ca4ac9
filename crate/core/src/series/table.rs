//! One trial of a time series.

use crate::series::error::SeriesError;
use crate::series::parts::{places_of, shortened};
use nalgebra::DMatrix;

/// A trial: named columns, with rows at equal time steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The name of its file.
    pub name: String,
    /// SHA-256 of the file, in hexadecimal.
    pub sha256: String,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The values [rows x columns].
    pub values: DMatrix<f64>,
    /// Seconds from one row to the next; `None` if the file has no column of times.
    pub frame_time: Option<f64>,
    /// What was unusual about the file, as sentences.
    pub warnings: Vec<String>,
}

/// Frame times that differ by a smaller fraction count as equal.
const SAME_RATE: f64 = 0.02;

impl Table {
    /// The same trial without the named columns. `x*` stands for all columns whose names begin with `x`, and
    /// `*x` for all whose names end with it.
    ///
    /// # Errors
    ///
    /// [`SeriesError::Table`] when a name stands for no column, or no column would be left.
    pub fn without(&self, names: &[&str]) -> Result<Table, SeriesError> {
        let refuse = |problem: String| Err(SeriesError::Table { table: self.name.clone(), problem });
        let mut gone = vec![false; self.columns.len()];
        for name in names {
            let places = places_of(name, &self.columns);
            if places.is_empty() {
                let columns = shortened(&self.columns);
                return refuse(format!(
                    "expected some of the columns {columns} to leave out, found {name:?}"
                ));
            }
            places.into_iter().for_each(|place| gone[place] = true);
        }
        let kept: Vec<usize> = (0..gone.len()).filter(|&place| !gone[place]).collect();
        if kept.is_empty() {
            return refuse("expected at least one column that is not left out, found none".to_owned());
        }
        let columns = kept.iter().map(|&place| self.columns[place].clone()).collect();
        Ok(Table { columns, values: self.values.select_columns(&kept), ..self.clone() })
    }

    /// The same trial with its columns in the order of `first`. All tables of a data set have that order.
    ///
    /// # Errors
    ///
    /// [`SeriesError::Differs`] when the columns or the frame times differ.
    pub fn like(&self, first: &Table) -> Result<Table, SeriesError> {
        let differs = |problem: String| {
            Err(SeriesError::Differs { file: self.name.clone(), first: first.name.clone(), problem })
        };
        let mut places = Vec::with_capacity(first.columns.len());
        for name in &first.columns {
            match self.columns.iter().position(|column| column == name) {
                Some(place) => places.push(place),
                None => return differs(format!("expected a column {name:?}, found none")),
            }
        }
        if let Some(extra) = self.columns.iter().find(|name| !first.columns.contains(name)) {
            return differs(format!("expected no column {extra:?}"));
        }
        let times = (self.frame_time, first.frame_time);
        let same = match times {
            (Some(own), Some(other)) => (own / other - 1.0).abs() < SAME_RATE,
            (own, other) => own == other,
        };
        if !same {
            let phrase = |time: Option<f64>| {
                time.map_or("no column of times".to_owned(), |time| format!("rows {time} s apart"))
            };
            return differs(format!("expected {}, found {}", phrase(times.1), phrase(times.0)));
        }
        let values = self.values.select_columns(&places);
        Ok(Table { columns: first.columns.clone(), values, ..self.clone() })
    }
}
