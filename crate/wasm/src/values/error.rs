//! The library's errors in JavaScript: an `Error` with a name of its own and a code that a program can tell
//! apart.

use js_sys::Reflect;
use std::fmt::Display;
pub use vcgpdm_core::coded::Code as ErrorCode;
use vcgpdm_core::coded::Coded;
use wasm_bindgen::prelude::*;

/// What a function throws.
pub enum VcgpdmError {
    /// An error of the package.
    Own(ErrorCode, String),
    /// What the caller's own code threw, such as a getter of the options.
    Thrown(JsValue),
}

impl VcgpdmError {
    /// An error with this message.
    pub fn new(code: ErrorCode, message: &dyn Display) -> Self {
        let message = message.to_string();
        // The wasm of a first visit reads no numbers of other people.
        #[cfg(feature = "training")]
        let message = crate::values::wording::with_short_numbers(&message);
        Self::Own(code, message)
    }
}

impl From<VcgpdmError> for JsValue {
    fn from(error: VcgpdmError) -> JsValue {
        let (code, message) = match error {
            VcgpdmError::Own(code, message) => (code, message),
            VcgpdmError::Thrown(value) => return value,
        };
        let error = js_sys::Error::new(&message);
        error.set_name("VcgpdmError");
        // A new error refuses no field.
        let _ = Reflect::set(&error, &"code".into(), &code.word().into());
        error.into()
    }
}

/// An error of the library has a code of its own.
impl<E: Coded + Display> From<E> for VcgpdmError {
    fn from(error: E) -> Self {
        Self::new(error.code(), &error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm_core::gp::NumericsError;
    use vcgpdm_core::models::{DatasetError, RolloutError, TrainingError};
    use wasm_bindgen_test::wasm_bindgen_test;

    #[wasm_bindgen_test]
    fn the_code_is_that_of_the_reason() {
        let thrown = |error: VcgpdmError| -> (String, String, String) {
            let error: js_sys::Error = JsValue::from(error).unchecked_into();
            let code = Reflect::get(&error, &"code".into()).unwrap().as_string().unwrap();
            (error.name().into(), code, error.message().into())
        };
        let setting = || TrainingError::Setting { name: "the order", lowest: 1, highest: 9, found: 0 };
        let expected = ("VcgpdmError".to_owned(), "settings".to_owned(), setting().to_string());
        assert_eq!(thrown(setting().into()), expected);
        let in_clip = DatasetError::Sequence { clip: "walk".to_owned(), reason: Box::new(setting()) };
        assert_eq!(thrown(in_clip.into()).1, "settings");
        assert_eq!(thrown(NumericsError::NotFinite { what: "bound" }.into()).1, "numerics");
        assert_eq!(thrown(RolloutError::Sequence { count: 1, found: 1 }.into()).1, "rollout");
    }
}
