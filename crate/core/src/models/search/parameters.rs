//! Named parameters as a flat vector for an optimiser, and the boxes of their values.

use crate::elementary::Elementary;
use crate::gp::exp::exp;

/// Groups of parameters that a schedule can free or fix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// mu and S, or point latents.
    Latents,
    /// Coupling variances alpha.
    Couplings,
    /// Lengthscales, signal and noise variances.
    Kernels,
    /// r and z.
    InducingInputs,
}

/// A kind of parameter: its group, whether it is positive (its flat entry is then a logarithm), the box of
/// its values and the unit of its flat entry.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its group.
    pub group: Group,
    positive: bool,
    lowest: f64,
    highest: f64,
    unit: f64,
}

const fn free(group: Group, limit: f64) -> Kind {
    Kind { group, positive: false, lowest: -limit, highest: limit, unit: 1.0 }
}

const fn positive(group: Group, lowest: f64, highest: f64) -> Kind {
    Kind { group, positive: true, lowest, highest, unit: 1.0 }
}

impl Kind {
    const fn in_units_of(self, unit: f64) -> Kind {
        Kind { unit, ..self }
    }

    /// The flat entry of a value.
    fn flat(&self, value: f64) -> f64 {
        (if self.positive { value.logarithm() } else { value }) / self.unit
    }
}

/// The largest coupling variance that training can reach.
pub const LARGEST_COUPLING: f64 = 10.0;
/// The smallest variance S that training can reach. In a trained model, a tenth to a half of all S have this
/// value. Smaller ones would raise the bound, but some models would then predict worse or stand still
/// (docs/training.md).
pub const SMALLEST_S: f64 = 1e-3;

// The boxes exclude values at which a covariance is not positive definite. A good model is inside them,
// except for S and for lengthscales, which are largest where a map is linear.
//
// A search is fast when a step of one unit changes the objective by a similar amount in all directions. At
// the best S, log S has the curvature 1/2 and mu the curvature 1/S, some hundreds, so log S has a far larger
// unit. log beta has the curvature N D / 2, some ten thousands, and so a smaller unit.
pub(crate) const MU: Kind = free(Group::Latents, 10.0);
pub(crate) const S: Kind = positive(Group::Latents, SMALLEST_S, 2.0).in_units_of(20.0);
pub(crate) const IPS: Kind = free(Group::InducingInputs, 10.0);
pub(crate) const LAMBDA: Kind = positive(Group::Kernels, 1e-3, 1e4);
pub(crate) const SIGNAL: Kind = positive(Group::Kernels, 1e-4, 1e3);
pub(crate) const BETA: Kind = positive(Group::Kernels, 1e-6, 1e2).in_units_of(0.3);
pub(crate) const ALPHA: Kind = positive(Group::Couplings, 1e-3, LARGEST_COUPLING);

/// Named parameters that an optimiser can see as one flat vector.
pub trait Parameters: Clone {
    /// Calls `f` with every block of values and its kind, in the order of the flat vector.
    fn visit<'a>(&'a self, f: &mut dyn FnMut(Kind, &'a [f64]));

    /// The same with values that can be changed.
    fn visit_mut(&mut self, f: &mut dyn FnMut(Kind, &mut [f64]));

    /// The flat vector: logarithms of the positive parameters and the values of the others, inside their
    /// boxes and in the units of their kinds.
    fn to_flat(&self) -> Vec<f64> {
        let mut flat = Vec::new();
        self.visit(&mut |kind, values| {
            flat.extend(values.iter().map(|v| kind.flat(v.clamp(kind.lowest, kind.highest))));
        });
        flat
    }

    /// Sets the values from a flat vector of the same shape.
    fn set_flat(&mut self, flat: &[f64]) {
        let mut rest = flat.iter();
        self.visit_mut(&mut |kind, values| {
            for (value, flat) in values.iter_mut().zip(&mut rest) {
                let counted = kind.unit * flat;
                // Clamped again, because the exponential of a logarithm can round past the end of the box.
                *value = if kind.positive { exp(counted) } else { counted }.clamp(kind.lowest, kind.highest);
            }
        });
    }

    /// Writes the gradient with respect to the flat vector into `flat`; `self` is the gradient with respect
    /// to the natural parameters `at`.
    fn flat_gradient_into(&self, at: &Self, flat: &mut Vec<f64>) {
        flat.clear();
        self.visit(&mut |_, gradient| flat.extend_from_slice(gradient));
        let mut k = 0;
        at.visit(&mut |kind, values| {
            for (g, value) in flat[k..k + values.len()].iter_mut().zip(values) {
                *g *= if kind.positive { kind.unit * value } else { kind.unit };
            }
            k += values.len();
        });
    }

    /// The kind of every entry of the flat vector.
    fn flat_kinds(&self) -> Vec<Kind> {
        let mut kinds = Vec::new();
        self.visit(&mut |kind, values| kinds.extend(std::iter::repeat_n(kind, values.len())));
        kinds
    }
}

impl Kind {
    /// The box of a flat entry of this kind.
    pub fn flat_box(&self) -> (f64, f64) {
        (self.flat(self.lowest), self.flat(self.highest))
    }
}
