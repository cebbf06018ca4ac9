//! What every model of movement has in common: what it learns from, a training under way, and a fitted model that rolls out.
//!
//! The protocol of a comparison: train on all trials but one, and on the first frames of the one held out as a sequence of
//! its own; roll out from that sequence for the length of the trial.

use crate::gp::NumericsError;
use crate::json::Value;
use crate::models::rollout::RolloutError;
use nalgebra::DMatrix;

/// The kinds of models that can be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ModelKind {
    /// Variational coupled GPDM, two parts or more (Velychko et al. 2018).
    Vcgpdm,
    /// Variational GPDM: all columns are one part.
    Vgpdm,
    /// GPDM with point estimates of the latents, all columns one part (Wang et al. 2008).
    MapGpdm,
    /// Coupled GPDM with point estimates of the latents (Velychko et al. 2014).
    MapCgpdm,
    /// Temporal movement primitives (Clever et al. 2016).
    Tmp,
    /// Dynamic movement primitives towards a goal (Ijspeert et al. 2013).
    DmpDiscrete,
    /// Dynamic movement primitives around a centre (Ijspeert et al. 2013).
    DmpRhythmic,
}

impl ModelKind {
    /// All kinds, in the order in which tables list them.
    pub const ALL: [ModelKind; 7] = [
        ModelKind::Vcgpdm,
        ModelKind::Vgpdm,
        ModelKind::MapGpdm,
        ModelKind::MapCgpdm,
        ModelKind::Tmp,
        ModelKind::DmpDiscrete,
        ModelKind::DmpRhythmic,
    ];

    /// Its name in documents and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            ModelKind::Vcgpdm => "vcgpdm",
            ModelKind::Vgpdm => "vgpdm",
            ModelKind::MapGpdm => "map-gpdm",
            ModelKind::MapCgpdm => "map-cgpdm",
            ModelKind::Tmp => "tmp",
            ModelKind::DmpDiscrete => "dmp-discrete",
            ModelKind::DmpRhythmic => "dmp-rhythmic",
        }
    }

    /// The kind of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.id() == id)
    }
}

/// What a model of movement learns from.
#[derive(Clone, Debug, PartialEq)]
pub struct Movements {
    /// Centred columns of each part [N x D_i], stacked sequence after sequence.
    pub y: Vec<DMatrix<f64>>,
    /// The sequences; their frames sum to N.
    pub sequences: Vec<Sequence>,
}

/// One sequence of the stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    /// T_s.
    pub frames: usize,
    /// False: only the first frames of a trial that will be predicted.
    pub whole: bool,
}

impl Movements {
    /// T_s.
    pub fn lengths(&self) -> Vec<usize> {
        self.sequences.iter().map(|s| s.frames).collect()
    }

    /// The same movements with the columns of all parts side by side, as one part.
    pub fn as_one_part(&self) -> Movements {
        let (rows, columns) =
            (self.y.first().map_or(0, |y| y.nrows()), self.y.iter().map(|y| y.ncols()).sum());
        let mut all = DMatrix::zeros(rows, columns);
        let mut at = 0;
        for y in &self.y {
            all.columns_mut(at, y.ncols()).copy_from(y);
            at += y.ncols();
        }
        Movements { y: vec![all], sequences: self.sequences.clone() }
    }
}

/// How far a training is.
#[derive(Clone, Debug, PartialEq)]
pub struct LearningProgress {
    /// Iterations so far.
    pub iteration: usize,
    /// Most iterations there can be.
    pub max_iterations: usize,
    /// What is maximised, now: the bound, a log density, or the negative of an error.
    pub objective: f64,
    /// The best so far.
    pub best: f64,
    /// Whether training has ended.
    pub done: bool,
    /// Why it ended, in plain words.
    pub reason: Option<String>,
    /// Share of the work done, 0 to 1. Time left is at most elapsed (1 - fraction) / fraction.
    pub fraction: f64,
}

/// A training under way. Whoever calls it loops, shows progress and may stop at any time: the best so far is kept.
pub trait Learner {
    /// One iteration. After the end it does nothing.
    fn step(&mut self) -> LearningProgress;

    /// How far training is.
    fn progress(&self) -> LearningProgress;

    /// The best model so far.
    fn model(&self) -> Result<Box<dyn MovementModel>, NumericsError>;
}

/// A fitted model of movement.
pub trait MovementModel {
    /// Which kind of model it is.
    fn kind(&self) -> ModelKind;

    /// Centred columns of each part [frames x D_i], starting as the training sequence `sequence` starts.
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError>;

    /// How many numbers must be kept to roll out from one sequence ("size" in figure 4 of Velychko et al. 2018); the column
    /// means and the body are the same for all models and do not count.
    fn stored_numbers(&self) -> usize;

    /// The bound on the log evidence, in nats, where the model has one.
    fn bound(&self) -> Option<f64>;

    /// What a document holds of it under "model"; `None` for the variational models, whose document is that of
    /// [`MotionModel`](crate::models::motion_model::MotionModel).
    fn to_value(&self) -> Option<Value> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_name_their_kind() {
        for kind in ModelKind::ALL {
            assert_eq!(ModelKind::from_id(kind.id()), Some(kind));
        }
        assert_eq!(ModelKind::from_id("gplvm"), None);
    }

    #[test]
    fn one_part_has_all_columns_in_order() {
        let y = vec![DMatrix::from_element(3, 2, 1.0), DMatrix::from_element(3, 1, 2.0)];
        let one = Movements { y, sequences: vec![Sequence { frames: 3, whole: true }] }.as_one_part();
        assert_eq!(one.y, [DMatrix::from_row_slice(3, 3, &[1., 1., 2., 1., 1., 2., 1., 1., 2.])]);
        assert_eq!(one.lengths(), [3]);
    }
}
