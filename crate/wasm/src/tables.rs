//! Time series that are no body: tables, and a training on them.

use crate::any_model::{Any, AnyModel};
use crate::convert::{flat, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::{Text, Whole};
use crate::progress::progress_to_js;
use crate::settings::settings_from_js;
use crate::trainer::latents_of;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use vcgpdm::Trainer as Training;
use vcgpdm::models::Dataset;
use vcgpdm::motion::parts::PartSpec;
use vcgpdm::series::{Columns, SeriesError, Table as Series, read};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What there is to know of a table. */
export interface TableInfo {
    name: string;
    sha256: string;
    columns: string[];
    rows: number;
    /** Seconds from one row to the next, where the file has a column of times. */
    frameTime: number | null;
}

/** A part of a table: columns that share a latent space, by their names. */
export interface TablePart {
    name: string;
    columns: string[];
}

/** What a training on tables is asked to do. */
export interface TableTrainingSettings extends Omit<TrainingSettings, "parts"> {
    parts: TablePart[];
    /** Rows a second, where the tables have no column of times. */
    framesPerSecond: number;
}
"#;

#[derive(Serialize)]
struct TableInfo<'a> {
    name: &'a str,
    sha256: &'a str,
    columns: &'a [String],
    rows: usize,
    frame_time: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TablePart {
    name: String,
    columns: Vec<String>,
}

/// A trial of a time series that is no body: named columns, a row a moment.
#[wasm_bindgen]
pub struct Table {
    table: Series,
}

#[wasm_bindgen]
impl Table {
    /// Reads a CSV file: the names of the columns in its first row, then a row of numbers a moment. A column
    /// `time` (or `t`, `seconds`) holds seconds. The error names the file, the line, the column, what was
    /// expected and what was found.
    pub fn read(name: &Text, bytes: &[u8]) -> Result<Table, VcgpdmError> {
        let name = name.get(ErrorCode::Table, "the name")?;
        Ok(Table { table: read(&name, bytes)? })
    }

    /// A table of numbers at hand, row after row [rows x columns], `frameTime` seconds from one row to the
    /// next.
    pub fn of(
        name: &Text,
        columns: Vec<String>,
        values: &[f64],
        #[wasm_bindgen(js_name = frameTime)] frame_time: f64,
    ) -> Result<Table, VcgpdmError> {
        let name = name.get(ErrorCode::Table, "the name")?;
        let d = columns.len();
        if d == 0 || values.is_empty() || !values.len().is_multiple_of(d) {
            let found = format_args!("expected rows of {d} numbers, found {} numbers", values.len());
            return Err(VcgpdmError::new(ErrorCode::Table, &found));
        }
        let values = DMatrix::from_row_slice(values.len() / d, d, values);
        // Written and read: the same rules as for a file.
        let text = vcgpdm::series::write(&columns, &values, frame_time);
        Ok(Table { table: read(&name, text.as_bytes())? })
    }

    /// What there is to know of it.
    #[wasm_bindgen(unchecked_return_type = "TableInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let Series { name, sha256, columns, values, frame_time } = &self.table;
        to_js(&TableInfo { name, sha256, columns, rows: values.nrows(), frame_time: *frame_time })
    }

    /// Its numbers [rows x columns].
    pub fn values(&self) -> Vec<f64> {
        flat(&self.table.values)
    }
}

/// A training on tables under way: a vCGPDM, or a vGPDM where there is one part.
#[wasm_bindgen]
pub struct TableTrainer {
    tables: Vec<Series>,
    settings: JsValue,
    begun: Option<Training<Columns>>,
}

#[wasm_bindgen]
impl TableTrainer {
    /// A training without tables; the first step begins it.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "TableTrainingSettings")] settings: JsValue,
    ) -> TableTrainer {
        TableTrainer { tables: Vec::new(), settings, begun: None }
    }

    /// Adds a trial, which becomes a sequence. Its columns may stand in another order than those of the
    /// first.
    pub fn add(&mut self, table: &Table) -> Result<(), VcgpdmError> {
        if self.begun.is_some() {
            let words = "expected all tables before the first step";
            return Err(VcgpdmError::new(ErrorCode::Training, &words));
        }
        let table = match self.tables.first() {
            Some(first) => table.table.like(first)?,
            None => table.table.clone(),
        };
        self.tables.push(table);
        Ok(())
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.begin()?.step())
    }

    /// Allows so many more iterations.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        let iterations = iterations.count(ErrorCode::Training, "the number of iterations")?;
        self.begin()?.extend(iterations);
        Ok(())
    }

    /// What the user should know, in sentences without a full stop: that nothing changes in a table or a
    /// column, that a table was given twice, and which settings are more than the data allow and were reduced.
    pub fn notices(&mut self) -> Result<Vec<String>, VcgpdmError> {
        Ok(self.begin()?.warnings())
    }

    /// The best model so far, at any time.
    pub fn model(&mut self) -> Result<AnyModel, VcgpdmError> {
        Ok(AnyModel { model: Any::Series(Rc::new(self.begin()?.finish()?)) })
    }

    /// Latent means of the training rows at the best so far [rows x Q] of one part, tables one after the
    /// other.
    pub fn latents(&mut self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        latents_of(self.begin()?, part)
    }
}

impl TableTrainer {
    fn begin(&mut self) -> Result<&mut Training<Columns>, VcgpdmError> {
        if self.begun.is_none() {
            let (task, settings) = settings_from_js::<TablePart>(&self.settings)?;
            let first = self.tables.first().ok_or(SeriesError::Empty)?;
            let mut parts = Vec::with_capacity(task.parts.len());
            for part in task.parts {
                let place = |name: &String| {
                    first.columns.iter().position(|column| column == name).ok_or_else(|| {
                        let words =
                            format!("part {:?}: expected one of the columns, found {name:?}", part.name);
                        VcgpdmError::new(ErrorCode::Parts, &words)
                    })
                };
                let joints = part.columns.iter().map(place).collect::<Result<_, _>>()?;
                parts.push(PartSpec { name: part.name.clone(), joints });
            }
            let dataset = Dataset::of_tables(&self.tables, &parts, task.frames_per_second)?;
            self.begun = Some(Training::new(&dataset, &settings.into(), task.seed)?);
        }
        self.begun.as_mut().ok_or_else(|| VcgpdmError::new(ErrorCode::Training, &"expected tables"))
    }
}
