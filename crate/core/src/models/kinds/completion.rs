//! A recording of which a model observes some parts and infers the others.

use crate::models::data::dataset::DatasetError;
use crate::models::kinds::body::Body;
use crate::models::kinds::coupled::Coupled;
use crate::models::rollout::request::RolloutRequest;
use crate::models::variational::{CompletionScore, LatentMoments, ObservationError};
use crate::motion::Clip;
use nalgebra::DMatrix;
use serde::Serialize;
use std::ops::Range;

/// A completed recording.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Completion {
    /// All columns [frames x D]: recorded ones of the given parts until the cut, inferred ones elsewhere.
    pub y: DMatrix<f64>,
    /// The latents of all parts given all observed columns.
    pub latents: LatentMoments,
    /// The parts that were not given, by number, with their errors.
    pub parts: Vec<(usize, PartCompletion)>,
}

/// The errors of a part that was not given, while the others are observed.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PartCompletion {
    /// While the other parts are observed.
    #[serde(flatten)]
    pub observed: CompletionScore,
    /// From the cut on.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub after_cut: Option<CompletionScore>,
}

impl Body {
    /// All columns [frames x D] of a clip of this body, at the frame rate of the model.
    ///
    /// # Errors
    ///
    /// When the clip has another body, or cannot be brought to the frame rate.
    pub fn encode(&self, clip: &Clip) -> Result<DMatrix<f64>, DatasetError> {
        let body = self.mapping.skeleton();
        body.same_body(&clip.in_order_of(body).skeleton).map_err(|reason| DatasetError::OtherBody {
            clip: clip.name.clone(),
            reason: Box::new(reason),
        })?;
        let resampled = clip.resample(1.0 / self.frame_time)?;
        let encoded = self.mapping.encode(&resampled);
        let encoded = encoded
            .map_err(|reason| DatasetError::Pose { clip: clip.name.clone(), reason: Box::new(reason) })?;
        Ok(encoded.y)
    }
}

impl Coupled<'_> {
    /// Completes recorded columns [frames x D] of which the parts `given` are observed, under the couplings of
    /// a request. From the frame `cut` on nothing is observed: the model goes on by itself.
    ///
    /// # Errors
    ///
    /// When no part or every part is given, the cut is not within the recording and after its first p frames,
    /// the columns cannot be filtered, or the couplings do not fit the model.
    #[doc(hidden)]
    pub fn complete(
        &self,
        request: &RolloutRequest,
        columns: &DMatrix<f64>,
        given: &[usize],
        cut: Option<usize>,
    ) -> Result<Completion, ObservationError> {
        let recorded = self.body.centred(columns);
        let (parts, frames, order) = (recorded.len(), columns.nrows(), self.model.order);
        let is_given = |part: &usize| given.contains(part);
        let found = (0..parts).filter(is_given).count();
        if found == 0 || found == parts || given.iter().any(|part| *part >= parts) {
            return Err(ObservationError::Given { parts, found: given.to_vec() });
        }
        let end = cut.unwrap_or(frames);
        if cut.is_some() && !(order..frames).contains(&end) {
            return Err(ObservationError::Cut { least: order, end: frames, found: end });
        }
        let mut observed = recorded.clone();
        for (part, y) in observed.iter_mut().enumerate() {
            let first = if is_given(&part) { end } else { 0 };
            y.rows_mut(first, frames - first).fill(f64::NAN);
        }
        let filter = self.filter(request)?;
        let latents = self.infer(&filter, &observed)?;
        let (mut shown, mut scores) = (Vec::new(), Vec::new());
        for (part, recorded) in recorded.iter().enumerate() {
            let mut columns = filter.mean_columns(part, &latents)?;
            if is_given(&part) {
                columns.rows_mut(0, end).copy_from(&recorded.rows(0, end));
            } else {
                let score = |rows| filter.score(part, &latents, &only(recorded, rows));
                let after_cut = cut.map(|cut| score(cut..frames)).transpose()?;
                scores.push((part, PartCompletion { observed: score(0..end)?, after_cut }));
            }
            shown.push(columns);
        }
        Ok(Completion { y: self.body.columns(&shown), latents, parts: scores })
    }
}

/// The columns with all rows missing but these.
fn only(y: &DMatrix<f64>, rows: Range<usize>) -> DMatrix<f64> {
    DMatrix::from_fn(y.nrows(), y.ncols(), |t, c| if rows.contains(&t) { y[(t, c)] } else { f64::NAN })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::kinds::health::tests::walk;

    #[test]
    fn refuses_given_parts_of_which_one_does_not_exist() {
        let (model, rollout) = walk();
        let y = rollout.y.rows(0, 5).into_owned();
        let complete =
            |given: &[usize]| model.coupled().unwrap().complete(&RolloutRequest::default(), &y, given, None);
        assert_eq!(complete(&[0]).unwrap().parts[0].0, 1);
        for given in [&[0, 2][..], &[2], &[0, 1], &[]] {
            let refused = complete(given).unwrap_err();
            assert!(matches!(refused, ObservationError::Given { parts: 2, .. }), "{given:?}: {refused}");
        }
    }
}
