//! Tables of time series.

use crate::values::arguments::{Bytes, Text};
use crate::values::convert::{flat, from_js, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::series::{Table as Series, read};
use wasm_bindgen::prelude::*;

/// The name, size and columns of a table.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct TableInfo<'a> {
    name: &'a str,
    sha256: &'a str,
    columns: &'a [String],
    rows: usize,
    /// Seconds from one row to the next; null if the file has no column of times.
    frame_time: Option<f64>,
    /// What was odd about the file but could be read.
    warnings: &'a [String],
}

/// A part of a table: the names of the columns that share a latent space.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct TablePart {
    name: String,
    columns: Vec<String>,
}

impl TablePart {
    /// One part with all columns of the table.
    pub(crate) fn all(table: &Series) -> Self {
        Self { name: "all".to_owned(), columns: table.columns.clone() }
    }
}

/// A trial of a time series: named columns, with one row for each moment.
#[wasm_bindgen]
pub struct Table {
    pub(crate) table: Series,
}

#[wasm_bindgen]
impl Table {
    /// Reads a CSV file. The first row has the names of the columns, and each other row has the numbers of
    /// one moment. A column such as `time`, `t`, `seconds` or `time_ms` holds the times. The error names the file, the line, the
    /// column, what was expected and what was found.
    pub fn read(name: &Text, bytes: &Bytes) -> Result<Table, VcgpdmError> {
        let name = name.get(ErrorCode::Table, "the name")?;
        Ok(Table { table: read(&name, &bytes.get(ErrorCode::Table, "the file")?)? })
    }

    /// Makes a table from numbers, row after row [rows x columns], with `frameTime` seconds from one row to
    /// the next. Without `frameTime`, the settings of a training state the rate.
    pub fn of(
        name: &Text,
        #[wasm_bindgen(unchecked_param_type = "string[]")] columns: JsValue,
        values: &[f64],
        #[wasm_bindgen(js_name = frameTime)] frame_time: Option<f64>,
    ) -> Result<Table, VcgpdmError> {
        let name = name.get(ErrorCode::Table, "the name")?;
        let columns: Vec<String> = from_js(ErrorCode::Table, "the columns", &columns)?;
        let d = columns.len();
        if d == 0 || values.is_empty() || !values.len().is_multiple_of(d) {
            let found = format_args!("expected rows of {d} numbers, found {} numbers", values.len());
            return Err(VcgpdmError::new(ErrorCode::Table, &found));
        }
        let values = DMatrix::from_row_slice(values.len() / d, d, values);
        let table = Series::checked(&name, columns, values, frame_time.unwrap_or(1.0))?;
        // Without times, the settings of the training state the rate.
        Ok(Table { table: Series { frame_time: frame_time.and(table.frame_time), ..table } })
    }

    /// The same table without the named columns. `x*` stands for all columns whose names begin with `x`, and
    /// `*x` for all whose names end with it.
    pub fn without(&self, names: Vec<String>) -> Result<Table, VcgpdmError> {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        Ok(Table { table: self.table.without(&names)? })
    }

    /// The name, size and columns of the table.
    #[wasm_bindgen(unchecked_return_type = "TableInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let Series { name, sha256, columns, values, frame_time, warnings } = &self.table;
        let (rows, frame_time) = (values.nrows(), *frame_time);
        to_js(&TableInfo { name, sha256, columns, rows, frame_time, warnings })
    }

    /// The numbers of the table [rows x columns].
    pub fn values(&self) -> Vec<f64> {
        flat(&self.table.values)
    }
}

/// The parts of a training, with the indices of their columns in the first table.
pub(crate) fn parts_of_columns(tables: &[Series], parts: &[TablePart]) -> Result<Vec<PartSpec>, VcgpdmError> {
    let columns = tables.first().map_or(&[][..], |table| &table.columns);
    let place = |part: &TablePart, name: &String| {
        columns.iter().position(|column| column == name).ok_or_else(|| {
            let words = format!("part {:?}: expected one of the columns, found {name:?}", part.name);
            VcgpdmError::new(ErrorCode::Parts, &words)
        })
    };
    let spec = |part: &TablePart| {
        let joints = part.columns.iter().map(|name| place(part, name)).collect::<Result<_, _>>()?;
        Ok(PartSpec { name: part.name.clone(), joints })
    };
    parts.iter().map(spec).collect()
}
