//! Structs of which every line is a field in the library, in files, in JavaScript and in TypeScript at once.

use std::ops::RangeInclusive;
use vcgpdm_core::json::checks::count;
use vcgpdm_core::json::{Field, FieldError, Value};

/// Declares a struct with a line for each field: its name, its type, and how a file's field is read and checked. A
/// field that old files lack states after `=>` what its absence means.
macro_rules! record {
    ($(#[$attribute:meta])* pub struct $name:ident {
        $($(#[$of_field:meta])* $field:ident: $type:ty = $read:expr $(=> $absent:expr)?,)+
    }) => {
        #[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        #[cfg_attr(feature = "types", derive(ts_rs::TS))]
        $(#[$attribute])*
        pub struct $name {
            $($(#[$of_field])* pub $field: $type,)+
        }

        impl $name {
            /// The record in a file.
            pub(super) fn value(&self) -> Value {
                Value::object([
                    $((stringify!($field), Written::value(&self.$field)),)+
                ])
            }

            /// Reads the record of a file, and checks every field.
            pub(super) fn read(field: Field) -> Result<Self, FieldError> {
                let mut object = field.object()?;
                let record = Self {
                    $($field: {
                        $(if !object.has(stringify!($field)) { $absent } else)?
                        { $read(object.get(stringify!($field))?)? }
                    },)+
                };
                object.end()?;
                Ok(record)
            }
        }
    };
}
pub(super) use record;

/// A field's value in a file.
pub(super) trait Written {
    fn value(&self) -> Value;
}

impl Written for bool {
    fn value(&self) -> Value {
        Value::Bool(*self)
    }
}

impl Written for u32 {
    fn value(&self) -> Value {
        Value::Number((*self).into())
    }
}

impl Written for usize {
    fn value(&self) -> Value {
        Value::whole(*self)
    }
}

impl Written for String {
    fn value(&self) -> Value {
        Value::text(self)
    }
}

/// Reads a whole number in a range.
pub(super) fn whole(field: Field, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    count(&field, field.whole()?, range)
}

/// Reads a text of at most `most` letters.
pub(super) fn short(field: &Field, most: usize) -> Result<String, FieldError> {
    let text = field.text()?;
    match text.chars().count() {
        found if found > most => Err(field.error(format!("expected at most {most} letters, found {found}"))),
        _ => Ok(text.to_owned()),
    }
}
