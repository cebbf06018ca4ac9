//! The library's errors in JavaScript: an `Error` with a name of its own and a code that a program can tell
//! apart.

use js_sys::Reflect;
use std::fmt::Display;
use vcgpdm::document::DocumentError;
use vcgpdm::gp::NumericsError;
#[cfg(feature = "training")]
use vcgpdm::models::ObservedClipError;
#[cfg(feature = "training")]
use vcgpdm::models::library::{
    CombinationError, ImportError, LibraryError as PrimitivesError, MergeError, RecognitionError, WalkError,
};
use vcgpdm::models::variational::InducingError;
#[cfg(feature = "training")]
use vcgpdm::models::variational::{KeptPointsError, ObservationError};
use vcgpdm::models::{DatasetError, RolloutError, TrainingError};
use vcgpdm::motion::bvh::BvhError;
use vcgpdm::motion::parts::PartsError;
use vcgpdm::motion::pose::PoseError;
use vcgpdm::motion::{ClipError, UnknownJoint};
#[cfg(feature = "training")]
use vcgpdm::series::SeriesError;
#[cfg(feature = "training")]
use vcgpdm_lab::evaluation::{ComparisonPlanError, EvaluationError, ResultsError, SettingError};
#[cfg(feature = "training")]
use vcgpdm_lab::perception::{AnalysisError, AnswersError, MakerError, StudyError};
#[cfg(feature = "training")]
use vcgpdm_lab::synthetic::SyntheticError;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The subject of a `VcgpdmError`. */
export type ErrorCode =
    | "clip"
    | "clips"
    | "bones"
    | "parts"
    | "settings"
    | "training"
    | "model"
    | "rollout"
    | "comparison"
    | "results"
    | "study"
    | "table"
    | "numerics"
    | "argument"
    | "freed";

/**
 * Every function throws this error when it fails; the message says what was expected and what was found.
 * The code is "argument" for an argument of another class, and "freed" for an object that is used after its
 * `free()`.
 */
export interface VcgpdmError extends Error {
    name: "VcgpdmError";
    code: ErrorCode;
}
"#;

/// The subject of an error.
#[derive(Clone, Copy)]
pub enum ErrorCode {
    /// One clip: its file, a cut, a frame rate.
    Clip,
    /// Clips that do not go together.
    Clips,
    /// Clips whose joints are the same but whose bones are not: `Clip.withBonesOf` makes them go together.
    Bones,
    /// How the body is split.
    Parts,
    /// A setting.
    Settings,
    /// A training that cannot start.
    Training,
    /// A model, or its document.
    Model,
    /// A rollout that cannot be made.
    Rollout,
    /// A comparison, or a job of it.
    #[cfg(feature = "training")]
    Comparison,
    /// Results, or their file.
    #[cfg(feature = "training")]
    Results,
    /// A table of numbers, or tables that do not go together.
    #[cfg(feature = "training")]
    Table,
    /// A study of perceived naturalness, or answers to one.
    #[cfg(feature = "training")]
    Study,
    /// A number out of bounds, or a matrix that cannot be factorised.
    Numerics,
}

impl ErrorCode {
    fn word(self) -> &'static str {
        match self {
            ErrorCode::Clip => "clip",
            ErrorCode::Clips => "clips",
            ErrorCode::Bones => "bones",
            ErrorCode::Parts => "parts",
            ErrorCode::Settings => "settings",
            ErrorCode::Training => "training",
            ErrorCode::Model => "model",
            ErrorCode::Rollout => "rollout",
            #[cfg(feature = "training")]
            ErrorCode::Comparison => "comparison",
            #[cfg(feature = "training")]
            ErrorCode::Results => "results",
            #[cfg(feature = "training")]
            ErrorCode::Table => "table",
            #[cfg(feature = "training")]
            ErrorCode::Study => "study",
            ErrorCode::Numerics => "numerics",
        }
    }
}

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
        let message = crate::wording::with_short_numbers(&message);
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

/// An error of the library, with its subject.
trait LibraryError: Display {
    fn code(&self) -> ErrorCode;
}

impl<E: LibraryError> From<E> for VcgpdmError {
    fn from(error: E) -> Self {
        VcgpdmError::new(error.code(), &error)
    }
}

/// Errors with one subject.
macro_rules! about {
    ($($error:ty => $code:ident),+ $(,)?) => {
        $(impl LibraryError for $error {
            fn code(&self) -> ErrorCode {
                ErrorCode::$code
            }
        })+
    };
}

about! {
    BvhError => Clip,
    ClipError => Clip,
    UnknownJoint => Clip,
    PoseError => Clip,
    DocumentError => Model,
    InducingError => Model,
    NumericsError => Numerics,
    PartsError => Parts,
}

#[cfg(feature = "training")]
about! {
    ComparisonPlanError => Comparison,
    ResultsError => Results,
    SettingError => Comparison,
    AnalysisError => Study,
    AnswersError => Study,
    MakerError => Study,
    StudyError => Study,
}

impl LibraryError for TrainingError {
    fn code(&self) -> ErrorCode {
        match self {
            TrainingError::Setting { .. } | TrainingError::PoseWeight { .. } => ErrorCode::Settings,
            TrainingError::Numerics(_) => ErrorCode::Numerics,
            _ => ErrorCode::Training,
        }
    }
}

impl LibraryError for DatasetError {
    fn code(&self) -> ErrorCode {
        match self {
            DatasetError::Body { reason, .. } if reason.only_bones_differ() => ErrorCode::Bones,
            DatasetError::OtherBody { reason, .. } if reason.only_bones_differ() => ErrorCode::Bones,
            DatasetError::Empty | DatasetError::Body { .. } | DatasetError::OtherBody { .. } => {
                ErrorCode::Clips
            }
            DatasetError::Short { .. } | DatasetError::Clip(_) | DatasetError::Pose { .. } => ErrorCode::Clip,
            DatasetError::Parts(_) => ErrorCode::Parts,
            DatasetError::Sequence { reason, .. } => reason.code(),
            DatasetError::Training(reason) => reason.code(),
            _ => ErrorCode::Clips,
        }
    }
}

impl LibraryError for RolloutError {
    fn code(&self) -> ErrorCode {
        match self {
            // Only a rollout that is not finite cannot be turned into poses.
            RolloutError::Numerics(_) | RolloutError::Pose(_) => ErrorCode::Numerics,
            _ => ErrorCode::Rollout,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for KeptPointsError {
    fn code(&self) -> ErrorCode {
        match self {
            KeptPointsError::Numerics(_) => ErrorCode::Numerics,
            _ => ErrorCode::Model,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for ObservationError {
    fn code(&self) -> ErrorCode {
        match self {
            ObservationError::Rollout(reason) => reason.code(),
            ObservationError::Numerics(_) => ErrorCode::Numerics,
            ObservationError::Short { .. } => ErrorCode::Clip,
            _ => ErrorCode::Rollout,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for ObservedClipError {
    fn code(&self) -> ErrorCode {
        match self {
            ObservedClipError::Dataset(reason) => reason.code(),
            ObservedClipError::Observation { reason, .. } => reason.code(),
            _ => ErrorCode::Clip,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for SeriesError {
    fn code(&self) -> ErrorCode {
        match self {
            SeriesError::Parts(_) => ErrorCode::Parts,
            _ => ErrorCode::Table,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for CombinationError {
    fn code(&self) -> ErrorCode {
        match self {
            CombinationError::Numerics(_) => ErrorCode::Numerics,
            _ => ErrorCode::Model,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for WalkError {
    fn code(&self) -> ErrorCode {
        match self {
            WalkError::Combination(reason) => reason.code(),
            WalkError::Rollout(reason) => reason.code(),
            WalkError::Pose(_) => ErrorCode::Numerics,
            _ => ErrorCode::Rollout,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for PrimitivesError {
    fn code(&self) -> ErrorCode {
        match self {
            PrimitivesError::Body { reason, .. } if reason.only_bones_differ() => ErrorCode::Bones,
            PrimitivesError::Body { .. } => ErrorCode::Clips,
            PrimitivesError::Clip(reason) => reason.code(),
            PrimitivesError::Pose { reason, .. } => reason.code(),
            PrimitivesError::Combination(reason) => reason.code(),
            PrimitivesError::Rollout(reason) => reason.code(),
            PrimitivesError::Training(reason) => reason.code(),
            _ => ErrorCode::Model,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for RecognitionError {
    fn code(&self) -> ErrorCode {
        match self {
            RecognitionError::Combination(reason) => reason.code(),
            RecognitionError::Clip(reason) => reason.code(),
            RecognitionError::Observation { reason, .. } => reason.code(),
            _ => ErrorCode::Clips,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for MergeError {
    fn code(&self) -> ErrorCode {
        match self {
            MergeError::Combination(reason) => reason.code(),
            _ => ErrorCode::Model,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for ImportError {
    fn code(&self) -> ErrorCode {
        match self {
            ImportError::Combination(reason) => reason.code(),
            ImportError::Clips(reason) => reason.code(),
            ImportError::Rollout(reason) => reason.code(),
            ImportError::Training(reason) => reason.code(),
            ImportError::Dataset(reason) => reason.code(),
            ImportError::Pose(_) | ImportError::Numerics(_) => ErrorCode::Numerics,
            _ => ErrorCode::Model,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for EvaluationError {
    fn code(&self) -> ErrorCode {
        match self {
            EvaluationError::Dataset(reason) => reason.code(),
            EvaluationError::Clip(reason) => reason.code(),
            EvaluationError::Pose(reason) => reason.code(),
            EvaluationError::Rollout(reason) => reason.code(),
            EvaluationError::Numerics(_) | EvaluationError::NotFinite { .. } | EvaluationError::Score(_) => {
                ErrorCode::Numerics
            }
            _ => ErrorCode::Comparison,
        }
    }
}

#[cfg(feature = "training")]
impl LibraryError for SyntheticError {
    fn code(&self) -> ErrorCode {
        match self {
            SyntheticError::Drive(_) => ErrorCode::Settings,
            SyntheticError::Numerics(_) => ErrorCode::Numerics,
            SyntheticError::Training(reason) => reason.code(),
            SyntheticError::Rollout(reason) => reason.code(),
            _ => ErrorCode::Training,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
