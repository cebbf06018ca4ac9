//! Checked arguments from JavaScript. Unchecked, wasm-bindgen would read a number in the place of a text from
//! foreign memory, and take a text in the place of a number or of bytes for zeros.

use crate::values::error::{ErrorCode, VcgpdmError};
use crate::values::wording::found_value;
#[cfg(feature = "training")]
use js_sys::{ArrayBuffer, Uint8Array};
use vcgpdm_core::models::variational::InducingError;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Declared as a text.
    #[wasm_bindgen(typescript_type = "string")]
    pub type Text;
    /// Declared as a whole number from 0 on.
    #[wasm_bindgen(typescript_type = "number")]
    pub type Whole;
}

#[cfg(feature = "training")]
#[wasm_bindgen]
extern "C" {
    /// Declared as the content of a file.
    #[wasm_bindgen(typescript_type = "string | ArrayBuffer | Uint8Array")]
    pub type Bytes;
}

impl Text {
    /// The text; an error names it by `what`.
    pub fn get(&self, code: ErrorCode, what: &str) -> Result<String, VcgpdmError> {
        self.as_string().ok_or_else(|| refused(code, what, "a text", self))
    }
}

#[cfg(feature = "training")]
impl Bytes {
    /// A copy of the bytes, of a text in UTF-8; an error names them by `what`.
    pub fn get(&self, code: ErrorCode, what: &str) -> Result<Vec<u8>, VcgpdmError> {
        if let Some(text) = self.as_string() {
            return Ok(text.into_bytes());
        }
        let bytes = match (self.dyn_ref(), self.dyn_ref::<ArrayBuffer>()) {
            (None, Some(buffer)) => Some(Uint8Array::new(buffer)),
            (bytes, _) => bytes.cloned(),
        };
        bytes
            .map(|bytes| bytes.to_vec())
            .ok_or_else(|| refused(code, what, "a string, an ArrayBuffer, a Uint8Array or a Blob", self))
    }
}

impl Whole {
    /// The number, of 32 bits at most; an error names it by `what`.
    pub fn get(&self, code: ErrorCode, what: &str) -> Result<u32, VcgpdmError> {
        let number = self.as_f64().filter(|number| (0.0..=f64::from(u32::MAX)).contains(number));
        match number.filter(|number| number.fract() == 0.0) {
            Some(number) => Ok(number as u32),
            None => Err(refused(code, what, "a whole number from 0 to 4294967295", self)),
        }
    }

    /// The number as a count or an index.
    pub fn count(&self, code: ErrorCode, what: &str) -> Result<usize, VcgpdmError> {
        Ok(self.get(code, what)? as usize)
    }

    /// The item of `all` at this index, one item for each part.
    pub fn part_of<'a, T>(&self, code: ErrorCode, all: &'a [T]) -> Result<&'a T, VcgpdmError> {
        let found = self.count(code, "the part")?;
        Ok(all.get(found).ok_or(InducingError::Part { count: all.len(), found })?)
    }
}

fn refused(code: ErrorCode, what: &str, expected: &str, found: &JsValue) -> VcgpdmError {
    VcgpdmError::new(code, &format_args!("{what}: expected {expected}, found {}", found_value(found)))
}
