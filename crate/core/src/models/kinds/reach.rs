//! Inverse kinematics: the latents of a part with which a node of the figure is near a wanted place.
//!
//! The latents x of the next frame minimise
//!
//! |g(x) - t|^2 / s^2 + |x - m|^2 / v^2 + max(0, u(x) - u0)^2 / w^2,
//!
//! where g is the node's place relative to the root and the heading, at the mean of the pose map, t the wanted place, m the
//! model's prediction of x, and u(x) the share of the pose map's prior variance that its inducing points do not
//! explain. The second term is the prior of the path, the third keeps x near the latents of the training, where
//! poses are plausible. A few damped Gauss-Newton steps (Levenberg and Marquardt) find the minimum.

use crate::models::kinds::coupled::Coupled;
use crate::models::variational::Familiarity;
use nalgebra::{DMatrix, DVector, Vector3};
use std::sync::Arc;

/// s: metres.
const NEAR: f64 = 0.01;
/// v: latent units.
const STEP: f64 = 0.5;
/// u0 and w: shares of the prior variance. On the learned loop of the page's first model u is below 0.0003.
const FAMILIAR: f64 = 0.01;
const UNFAMILIAR: f64 = 0.002;
/// The node comes nearer to its place by at most this much in a frame, in metres.
const FASTEST: f64 = 0.1;
/// Half the width of the finite differences, in latent units.
const DIFFERENCE: f64 = 1e-3;
/// The most Gauss-Newton steps in a frame.
const STEPS: usize = 6;

/// A node of the figure that shall be at a place.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    pub(super) node: usize,
    /// Relative to the root, in metres, y up; z is the heading.
    pub(super) place: Vector3<f64>,
    familiarity: Arc<Familiarity>,
}

impl Reach {
    pub(super) fn new(node: usize, place: Vector3<f64>, familiarity: Familiarity) -> Self {
        Self { node, place, familiarity: Arc::new(familiarity) }
    }

    /// The latents of `part` in the newest frame, where the model predicts `latents` [1 x Q_i] of all parts;
    /// `before` are the part's latents in the frame before.
    pub(super) fn latents(
        &self,
        model: Coupled,
        part: usize,
        latents: &[DMatrix<f64>],
        before: &[f64],
    ) -> Vec<f64> {
        let predicted = DVector::from_column_slice(latents[part].as_slice());
        let place = |x: &DVector<f64>| place_of(model, self.node, part, latents, x);
        let before = DVector::from_column_slice(before);
        let Some(begin) = place(&before) else { return before.as_slice().to_vec() };
        let wanted = begin + (self.place - begin).cap_magnitude(FASTEST);
        let residuals = |x: &DVector<f64>| -> Option<DVector<f64>> {
            let mut all = Vec::with_capacity(4 + x.len());
            all.extend(((place(x)? - wanted) / NEAR).iter());
            all.extend(((x - &predicted) / STEP).iter());
            let unexplained = 1.0 - self.familiarity.share(x.as_slice());
            all.push((unexplained - FAMILIAR).max(0.0) / UNFAMILIAR);
            let all = DVector::from_vec(all);
            all.iter().all(|r| r.is_finite()).then_some(all)
        };
        minimum(before, residuals).as_slice().to_vec()
    }
}

/// The place of a node relative to the root and the heading, with a part at the latents `x`; `None` if it is not finite.
fn place_of(
    model: Coupled,
    node: usize,
    part: usize,
    latents: &[DMatrix<f64>],
    x: &DVector<f64>,
) -> Option<Vector3<f64>> {
    let mut all = latents.to_vec();
    all[part].copy_from_slice(x.as_slice());
    let y = model.body.columns(&model.model.observations(&all));
    let positions = model.body.positions(&y).ok()?;
    let at = |node: usize| Vector3::from_fn(|axis, _| f64::from(positions[3 * node + axis]));
    Some(at(node) - at(0))
}

/// The minimum of a sum of squared residuals near `x`, by damped Gauss-Newton steps; `x` itself where they are
/// not finite.
pub(crate) fn minimum(
    mut x: DVector<f64>,
    residuals: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
) -> DVector<f64> {
    let Some(mut now) = residuals(&x) else { return x };
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let slope = |k: usize| -> Option<DVector<f64>> {
            let (mut up, mut down) = (x.clone(), x.clone());
            up[k] += DIFFERENCE;
            down[k] -= DIFFERENCE;
            Some((residuals(&up)? - residuals(&down)?) / (2.0 * DIFFERENCE))
        };
        let Some(slopes) = (0..x.len()).map(slope).collect::<Option<Vec<_>>>() else { return x };
        let slopes = DMatrix::from_columns(&slopes);
        let (squares, right) = (slopes.tr_mul(&slopes), -slopes.tr_mul(&now));
        // A larger damping shortens the step until the sum becomes smaller.
        let better = (0..STEPS).find_map(|_| {
            let mut damped = squares.clone();
            (0..x.len()).for_each(|k| damped[(k, k)] *= 1.0 + damping);
            let next = &x + damped.cholesky()?.solve(&right);
            let found = residuals(&next).filter(|found| found.norm_squared() < now.norm_squared());
            damping = if found.is_some() { damping / 10.0 } else { damping * 10.0 };
            Some((next, found?))
        });
        let Some((next, found)) = better else { return x };
        let gained = now.norm_squared() - found.norm_squared();
        (x, now) = (next, found);
        if gained < 1e-3 * now.norm_squared() {
            return x;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_minimum_of_a_curved_valley() {
        // Rosenbrock's function.
        let residuals =
            |x: &DVector<f64>| Some(DVector::from_vec(vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]));
        let mut x = DVector::from_vec(vec![-1.2, 1.0]);
        for _ in 0..8 {
            x = minimum(x, residuals);
        }
        assert!((x - DVector::from_vec(vec![1.0, 1.0])).amax() < 1e-3);
    }

    #[test]
    fn stays_where_residuals_are_not_finite() {
        let start = DVector::from_vec(vec![1.0]);
        assert_eq!(minimum(start.clone(), |_| None), start);
        let wall = |x: &DVector<f64>| (x[0] < 1.5).then(|| x.map(|x| 3.0 - x));
        let found = minimum(start, wall)[0];
        assert!((1.0..1.5).contains(&found), "{found}");
    }
}
