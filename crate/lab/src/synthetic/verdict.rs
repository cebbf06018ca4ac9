//! The verdict of learned couplings about which part drives which, and whether it is true.

use nalgebra::DMatrix;

/// alpha^{21} is "much larger" than alpha^{11} if it is at least this many times as large.
pub const MUCH: f64 = 10.0;
/// When the first part drives the second, alpha^{12} is within this factor of alpha^{22}, larger or smaller.
pub const ALIKE: f64 = 4.0;

/// The verdict of coupling variances `alpha[source][target]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// alpha^{21} / alpha^{11}: how many times weaker the second part drives the first than the first drives
    /// itself.
    pub back: f64,
    /// alpha^{12} / alpha^{22}: how many times weaker the first part drives the second than the second drives
    /// itself.
    pub forth: f64,
}

impl Verdict {
    /// The verdict of learned couplings [2 x 2].
    pub fn new(alpha: &DMatrix<f64>) -> Self {
        Self { back: alpha[(1, 0)] / alpha[(0, 0)], forth: alpha[(0, 1)] / alpha[(1, 1)] }
    }

    /// Whether the verdict is that the second part does not drive the first.
    pub fn back_is_right(&self) -> bool {
        self.back >= MUCH
    }

    /// Whether the verdict about the first part driving the second is true: it drives if its share `drive` is
    /// not 0.
    pub fn forth_is_right(&self, drive: f64) -> bool {
        if drive > 0.0 { (1.0 / ALIKE..=ALIKE).contains(&self.forth) } else { self.forth >= MUCH }
    }

    /// Whether both verdicts are true.
    pub fn right(&self, drive: f64) -> bool {
        self.back_is_right() && self.forth_is_right(drive)
    }
}
