//! Codes of errors, which a program can tell apart.

macro_rules! codes {
    ($($(#[$doc:meta])* $name:ident $word:literal,)+) => {
        /// The subject of an error. The wasm holds one byte for each, so this is no text.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Code {
            $($(#[$doc])* $name,)+
        }

        impl Code {
            /// The code as a word.
            pub fn word(self) -> &'static str {
                match self {
                    $(Self::$name => $word,)+
                }
            }
        }
    };
}

codes! {
    /// One clip: its file, a cut, a frame rate.
    Clip "clip",
    /// Clips that do not go together.
    Clips "clips",
    /// Clips whose joints are the same but whose bones are not: `Clip.withBonesOf` makes them go together.
    Bones "bones",
    /// How the body is split.
    Parts "parts",
    /// A setting.
    Settings "settings",
    /// A training that cannot start.
    Training "training",
    /// A model, or its document.
    Model "model",
    /// A rollout that cannot be made.
    Rollout "rollout",
    /// A comparison, or a job of it.
    Comparison "comparison",
    /// Results, or their file.
    Results "results",
    /// A table of numbers, or tables that do not go together.
    Table "table",
    /// A study of perceived naturalness, or answers to one.
    Study "study",
    /// A number out of bounds, or a matrix that cannot be factorised.
    Numerics "numerics",
}

/// An error with a code.
pub trait Coded {
    /// The code; that of the reason, where the error only says where it occurred.
    fn code(&self) -> Code;
}

/// Gives an error its code: one for all of its patterns, or one for each.
#[doc(hidden)]
#[macro_export]
macro_rules! coded {
    ($error:ty => $code:ident) => {
        impl $crate::coded::Coded for $error {
            fn code(&self) -> $crate::coded::Code {
                $crate::coded::Code::$code
            }
        }
    };
    ($error:ty { $($pattern:pat $(if $guard:expr)? => $code:expr),+ $(,)? }) => {
        impl $crate::coded::Coded for $error {
            fn code(&self) -> $crate::coded::Code {
                use $crate::coded::Code::*;
                match self {
                    $($pattern $(if $guard)? => $code),+
                }
            }
        }
    };
}
