//! Which parts of a combination stand still, and which part drives each of them.

use crate::models::library::{Library, WalkError};
use crate::models::rollout::couplings::{Reading, coupling_weights};
use nalgebra::DMatrix;
use serde::Serialize;

/// Frames of the rollout that is measured. Only the second half counts: by then, the effect of the start
/// has faded.
const FRAMES: usize = 240;
/// A part stands still when the variance of its latents is less than this share of that in training.
const STILL: f64 = 0.05;

/// The long-run motion of one part of a combination.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PartMotion {
    /// The variance of the part's latents, divided by their variance in the training movements of its
    /// primitive.
    pub share: f64,
    /// Whether the part stands still.
    pub still: bool,
    /// The other part whose predictions of this part have the largest weight; `None` if there is only one
    /// part. `met`: whether the primitives of the two parts learned from the same movement.
    #[cfg_attr(feature = "types", ts(inline))]
    pub leader: Option<Leader>,
}

/// The part that drives another part.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Leader {
    /// The part, counted from 0.
    pub part: usize,
    /// The weight of its predictions, 0 to 1.
    pub weight: f64,
    /// Whether the primitives of both parts learned from the same movement.
    pub met: bool,
}

impl Library {
    /// The motion of each part of a combination in the long run under the couplings `alpha` [M x M].
    ///
    /// # Errors
    ///
    /// When the primitives or the couplings do not fit the parts.
    pub fn motion(&self, uses: &[usize], alpha: &DMatrix<f64>) -> Result<Vec<PartMotion>, WalkError> {
        let model = self.combination(uses, alpha)?;
        let start = model.start(0, 0).unwrap_or_else(|_| self.zero_start());
        let path = model.dynamics(alpha, Reading::AsLearned)?.path(&start, FRAMES)?;
        let motion = |(part, path): (usize, &DMatrix<f64>)| {
            let share = variance(&[path.rows(FRAMES / 2, FRAMES / 2).into_owned()])
                / self.training_variance(uses[part], part);
            PartMotion {
                share,
                still: share.is_nan() || share < STILL,
                leader: self.leader(uses, alpha, part),
            }
        };
        Ok(path.iter().enumerate().map(motion).collect())
    }

    /// The variance of a part's latents in all movements of one of its primitives.
    fn training_variance(&self, primitive: usize, part: usize) -> f64 {
        let latents = self.starts_of(primitive).map(|start| start[part].clone());
        variance(&latents.collect::<Vec<_>>()).max(f64::MIN_POSITIVE)
    }

    fn leader(&self, uses: &[usize], alpha: &DMatrix<f64>, part: usize) -> Option<Leader> {
        let (_, weights) = coupling_weights(alpha.column(part).as_slice());
        let others = weights.into_iter().enumerate().filter(|(source, _)| *source != part);
        let (source, weight) = others.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let (own, other) = (uses[part], uses[source]);
        let share_an_excerpt = |a: usize, b: usize| {
            let names = |a: usize| self.primitives[a].excerpts.iter().map(|excerpt| &excerpt.movement);
            names(a).any(|name| names(b).any(|other| other == name))
        };
        let met = self
            .movements
            .iter()
            .any(|m| m.sums.is_some() && m.uses.contains(&own) && m.uses.contains(&other))
            || share_an_excerpt(own, other);
        Some(Leader { part: source, weight, met })
    }
}

/// The mean squared distance of all rows from the mean row.
fn variance(latents: &[DMatrix<f64>]) -> f64 {
    let count: usize = latents.iter().map(DMatrix::nrows).sum();
    let Some(first) = latents.first() else { return 0.0 };
    let mut mean = first.row_mean() * 0.0;
    for x in latents {
        for row in x.row_iter() {
            mean += row / count.max(1) as f64;
        }
    }
    let rows =
        latents.iter().flat_map(|x| x.row_iter().map(|row| (row - &mean).norm_squared()).collect::<Vec<_>>());
    rows.sum::<f64>() / count.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_variance_is_a_mean_over_all_rows() {
        let column = |values: &[f64]| DMatrix::from_column_slice(values.len(), 1, values);
        assert!((variance(&[column(&[1.0, 3.0]), column(&[5.0, 7.0])]) - 5.0).abs() < 1e-12);
    }
}
