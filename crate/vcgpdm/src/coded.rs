//! Codes of errors, which a program can tell apart.

/// An error with a code: one word for its subject.
pub trait Coded {
    /// The code; that of the reason, where the error only says where it occurred.
    fn code(&self) -> &'static str;
}

/// Gives an error its code: one word, or one for each pattern.
#[doc(hidden)]
#[macro_export]
macro_rules! coded {
    ($error:ty => $code:literal) => {
        $crate::coded!($error { _ => $code });
    };
    ($error:ty { $($pattern:pat $(if $guard:expr)? => $code:expr),+ $(,)? }) => {
        impl $crate::coded::Coded for $error {
            fn code(&self) -> &'static str {
                match self {
                    $($pattern $(if $guard)? => $code),+
                }
            }
        }
    };
}
