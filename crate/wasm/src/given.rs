//! What JavaScript gives as an argument, checked before it is used. Passed on as they are, a number in the
//! place of a text would be read from memory that is not its own, and a word in the place of a number would
//! be taken for 0.

use crate::error::{ErrorCode, VcgpdmError};
use vcgpdm::models::variational::InducingError;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A text, as far as JavaScript has kept to it.
    #[wasm_bindgen(typescript_type = "string")]
    pub type Text;
    /// A whole number from 0 on, as far as JavaScript has kept to it.
    #[wasm_bindgen(typescript_type = "number")]
    pub type Whole;
}

impl Text {
    /// The text; an error says `what` was to be one.
    pub fn get(&self, code: ErrorCode, what: &str) -> Result<String, VcgpdmError> {
        self.as_string().ok_or_else(|| refused(code, what, "a text", self))
    }
}

impl Whole {
    /// The number, at most that of 32 bits; an error says `what` was to be one.
    pub fn get(&self, code: ErrorCode, what: &str) -> Result<u32, VcgpdmError> {
        let number = self.as_f64().filter(|number| (0.0..=f64::from(u32::MAX)).contains(number));
        match number.filter(|number| number.fract() == 0.0) {
            Some(number) => Ok(number as u32),
            None => Err(refused(code, what, "a whole number from 0 to 4294967295", self)),
        }
    }

    /// The same, as a number of things or the place of one.
    pub fn count(&self, code: ErrorCode, what: &str) -> Result<usize, VcgpdmError> {
        Ok(self.get(code, what)? as usize)
    }

    /// What belongs to the part of this number, one of `all`.
    pub fn part_of<'a, T>(&self, code: ErrorCode, all: &'a [T]) -> Result<&'a T, VcgpdmError> {
        let found = self.count(code, "the part")?;
        Ok(all.get(found).ok_or(InducingError::Part { count: all.len(), found })?)
    }
}

fn refused(code: ErrorCode, what: &str, expected: &str, found: &JsValue) -> VcgpdmError {
    let found = match found.as_f64() {
        Some(number) => number.to_string(),
        None => found.js_typeof().as_string().unwrap_or_default(),
    };
    VcgpdmError::new(code, &format_args!("{what}: expected {expected}, found {found}"))
}
