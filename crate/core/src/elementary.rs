//! Elementary functions that give the same bits natively and in wasm.
//!
//! Those of the standard library come from the platform (glibc natively, another library in wasm) and differ
//! in the last bit. After fifty iterations of training this grows to a difference of about one nat.

/// Replacements for the functions of the standard library whose results depend on the platform.
pub trait Elementary: Sized {
    /// e^x.
    fn exponential(self) -> Self;
    /// ln x.
    fn logarithm(self) -> Self;
    /// sin x.
    fn sine(self) -> Self;
    /// cos x.
    fn cosine(self) -> Self;
    /// sin x and cos x.
    fn sine_cosine(self) -> (Self, Self);
    /// The angle of the point (x, y), `self` being y.
    fn arctangent(self, x: Self) -> Self;
    /// sqrt(x^2 + y^2).
    fn hypotenuse(self, y: Self) -> Self;
    /// x^y.
    fn power(self, y: Self) -> Self;
}

impl Elementary for f64 {
    fn exponential(self) -> f64 {
        libm::exp(self)
    }

    fn logarithm(self) -> f64 {
        libm::log(self)
    }

    fn sine(self) -> f64 {
        libm::sin(self)
    }

    fn cosine(self) -> f64 {
        libm::cos(self)
    }

    fn sine_cosine(self) -> (f64, f64) {
        libm::sincos(self)
    }

    fn arctangent(self, x: f64) -> f64 {
        libm::atan2(self, x)
    }

    fn hypotenuse(self, y: f64) -> f64 {
        libm::hypot(self, y)
    }

    fn power(self, y: f64) -> f64 {
        libm::pow(self, y)
    }
}
