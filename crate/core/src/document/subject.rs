//! The columns in a document: the pose mapping of a body, or the names and units of a table's columns.

use crate::document::error::{DocumentError, SECOND, THIRD};
use crate::json::checks::{count, positive};
use crate::json::{Field, FieldError, Object, Value};
use crate::models::ColumnMapping;
use crate::motion::parts::{PartSpec, PartsLayout};
use crate::motion::pose::PoseMapping;
use crate::series::{Columns, check_parts};

/// Largest number of columns of a table.
const MOST_COLUMNS: usize = 10_000;

/// The columns of a model, as documents contain them.
pub(super) trait Subject: ColumnMapping {
    /// The field of the document.
    const FIELD: &'static str;
    /// The field of a part that lists its joints or columns.
    const PLACES: &'static str;
    /// The earliest version for a variational model, and for another kind.
    const VERSIONS: [usize; 2];

    fn to_value(&self) -> Value;
    fn from_field(field: Field) -> Result<Self, FieldError>;
    fn layout(&self, parts: &[PartSpec]) -> Result<PartsLayout, DocumentError>;
}

impl Subject for PoseMapping {
    const FIELD: &'static str = "pose";
    const PLACES: &'static str = "joints";
    const VERSIONS: [usize; 2] = [1, SECOND];

    fn to_value(&self) -> Value {
        PoseMapping::to_value(self)
    }

    fn from_field(field: Field) -> Result<Self, FieldError> {
        PoseMapping::from_field(field)
    }

    fn layout(&self, parts: &[PartSpec]) -> Result<PartsLayout, DocumentError> {
        Ok(PartsLayout::new(parts, self)?)
    }
}

impl Subject for Columns {
    const FIELD: &'static str = "columns";
    const PLACES: &'static str = "columns";
    const VERSIONS: [usize; 2] = [THIRD, THIRD];

    fn to_value(&self) -> Value {
        Value::list(self.names().iter().zip(self.units()), |(name, unit)| {
            Value::object([("name", Value::text(name)), ("unit", Value::Number(*unit))])
        })
    }

    fn from_field(field: Field) -> Result<Self, FieldError> {
        let read = |item: Field| -> Result<(String, f64), FieldError> {
            let mut object: Object = item.object()?;
            let name = object.get("name")?.text()?.to_owned();
            let unit = object.get("unit")?;
            let number = unit.number()?;
            positive(&unit, &[number])?;
            object.end()?;
            Ok((name, number))
        };
        let (names, units): (Vec<String>, Vec<f64>) = field.list(read)?.into_iter().unzip();
        count(&field, names.len(), 1..=MOST_COLUMNS)?;
        Ok(Columns::new(names, units))
    }

    fn layout(&self, parts: &[PartSpec]) -> Result<PartsLayout, DocumentError> {
        check_parts(parts, self.names()).map_err(|problem| DocumentError::Field {
            path: "parts".to_owned(),
            message: problem.to_string(),
        })?;
        Ok(PartsLayout::for_table(parts))
    }
}
