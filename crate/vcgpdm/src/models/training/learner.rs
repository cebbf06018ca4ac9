//! A training under way, whatever the model.

use crate::gp::NumericsError;
use crate::models::fitted::model::Model;
use crate::models::training::progress::LearningProgress;

/// A training under way. Whoever calls it loops, shows progress and may stop at any time: the best so far is
/// kept.
///
/// ```
/// use vcgpdm::models::{DmpSettings, ModelSettings, Movements, Sequence};
/// use nalgebra::DMatrix;
///
/// let y = vec![DMatrix::from_fn(60, 2, |t, d| (0.3 * t as f64 + d as f64).sin())];
/// let movements = Movements { y, sequences: vec![Sequence { frames: 60, whole: true }] };
/// let settings = ModelSettings::DmpRhythmic(DmpSettings::default());
/// let mut learner = settings.learner(&movements, 0)?;
/// while !learner.step().done {}
/// let rolled_out = learner.model()?.rollout(0, 100)?;
/// assert_eq!(rolled_out[0].shape(), (100, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Learner {
    /// One iteration. After the end it does nothing.
    fn step(&mut self) -> LearningProgress;

    /// Computes in so many threads from now on, where the model knows how to; the outcome is the same to the
    /// bit.
    #[cfg(feature = "threads")]
    fn use_threads(&mut self, _threads: usize) {}

    /// What was asked for and is more than the data allow, in sentences without a full stop: it was reduced.
    fn notices(&self) -> &[String] {
        &[]
    }

    /// How far training is.
    fn progress(&self) -> LearningProgress;

    /// The best model so far.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    fn model(&self) -> Result<Model, NumericsError>;
}
