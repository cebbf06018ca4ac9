//! The shared model as a versioned JSON document. No I/O.
//!
//! It holds what a rollout needs and no training clip: skeleton and pose mapping, column means, parts with their pose maps,
//! the dynamics into each part, couplings, the sums from which experts can be inferred again, start latents and provenance.

use crate::dataset::SequenceInfo;
use crate::linalg::NumericsError;
use crate::model::{BoundTerms, DynamicsSums, FittedExpert, FittedModel, Kernel, PoseMap};
use crate::motion_model::{MotionModel, Provenance};
use crate::parts::{PartSpec, PartsError, PartsLayout};
use crate::pose::PoseMapping;
use crate::rows;
use crate::training::TrainingSettings;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use thiserror::Error;

const FORMAT: &str = "vcgpdm model";
/// Raised whenever an older program could no longer read the document.
const VERSION: u64 = 1;
const MOST_BYTES: usize = 100 << 20;
const MOST_PARTS: usize = 64;
const MOST_LATENT: usize = 100;
const MOST_IPS: usize = 1000;
const MOST_ORDER: usize = 100;
const MOST_SEQUENCES: usize = 10_000;

/// Why a text is not a model that can be used.
#[derive(Debug, Error)]
pub enum DocumentError {
    /// Larger than any model.
    #[error("expected a model of at most {} megabytes, found {found} bytes", MOST_BYTES >> 20)]
    Size {
        /// Bytes found.
        found: usize,
    },
    /// Not JSON.
    #[error("expected a model as JSON: {0}")]
    Json(serde_json::Error),
    /// JSON, but something else.
    #[error("expected a model with \"format\": \"{FORMAT}\", found {found}")]
    Format {
        /// What the document says it is.
        found: String,
    },
    /// From a later program.
    #[error(
        "expected a model of version {VERSION} or earlier, found version {found}; a newer program wrote it"
    )]
    Version {
        /// What the document says.
        found: u64,
    },
    /// A field is missing, of the wrong type or out of its range.
    #[error("at {path}: {message}")]
    Field {
        /// The field's path.
        path: String,
        /// What was expected and found.
        message: String,
    },
    /// The parts do not fit the body.
    #[error("at parts: {0}")]
    Parts(#[from] PartsError),
    /// The pose maps cannot be solved for.
    #[error("the model cannot be used: {0}")]
    Numerics(#[from] NumericsError),
}

#[derive(Deserialize)]
struct Header {
    format: Option<serde_json::Value>,
    version: Option<u64>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    format: String,
    version: u64,
    pose: PoseMapping,
    frame_time: f64,
    #[serde(with = "rows::vector")]
    column_means: DVector<f64>,
    order: usize,
    jitter: f64,
    parts: Vec<PartJson>,
    dynamics: Vec<TargetJson>,
    /// Row the source, column the target.
    #[serde(with = "rows::matrix")]
    alpha: DMatrix<f64>,
    sequences: Vec<SequenceJson>,
    provenance: ProvenanceJson,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct PartJson {
    name: String,
    joints: Vec<usize>,
    lambda: Vec<f64>,
    variance: f64,
    beta: f64,
    #[serde(with = "rows::matrix")]
    r: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    v_mean: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    v_covariance: DMatrix<f64>,
}

/// The dynamics into one part; matrices over its sources stack them in order.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct TargetJson {
    experts: Vec<ExpertJson>,
    #[serde(with = "rows::matrix")]
    u_covariance: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    sum_psi2: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    sum_psi1_mu: DMatrix<f64>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ExpertJson {
    lambda: Vec<f64>,
    #[serde(with = "rows::matrix")]
    z: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    u_mean: DMatrix<f64>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SequenceJson {
    clip: String,
    sha256: String,
    frames: usize,
    /// The latent means of the first frames of each part.
    start: Vec<Vec<Vec<f64>>>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ProvenanceJson {
    engine: String,
    settings: TrainingSettings,
    frames_per_second: f64,
    bound: f64,
    terms: BoundTerms,
    iterations: usize,
    evaluations: usize,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

impl MotionModel {
    /// The model as a JSON document.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        let fitted = &self.fitted;
        let parts = fitted.parts.iter().zip(self.layout.parts()).map(|(map, spec)| PartJson {
            name: spec.name.clone(),
            joints: spec.joints.clone(),
            lambda: map.kernel.lambda.as_slice().to_vec(),
            variance: map.kernel.variance,
            beta: map.beta,
            r: map.r.clone(),
            v_mean: map.mean.clone(),
            v_covariance: map.covariance.clone(),
        });
        let dynamics = (0..fitted.part_count()).map(|i| TargetJson {
            experts: fitted.experts.iter().map(|row| expert_json(&row[i])).collect(),
            u_covariance: fitted.dynamics_covariance[i].clone(),
            sum_psi2: fitted.sums[i].psi2.clone(),
            sum_psi1_mu: fitted.sums[i].psi1_mu.clone(),
        });
        let sequences = self.sequences.iter().zip(&fitted.starts).map(|(info, start)| SequenceJson {
            clip: info.name.clone(),
            sha256: info.sha256.clone(),
            frames: info.frames,
            start: start.iter().map(rows::rows_of).collect(),
        });
        let Provenance { engine, settings, frames_per_second, bound, terms, iterations, evaluations, note } =
            self.provenance.clone();
        serde_json::to_string(&Document {
            format: FORMAT.to_owned(),
            version: VERSION,
            pose: self.mapping.clone(),
            frame_time: self.frame_time,
            column_means: DVector::from_column_slice(&self.column_means),
            order: fitted.order,
            jitter: fitted.jitter,
            parts: parts.collect(),
            dynamics: dynamics.collect(),
            alpha: fitted.alpha.clone(),
            sequences: sequences.collect(),
            provenance: ProvenanceJson {
                engine,
                settings,
                frames_per_second,
                bound,
                terms,
                iterations,
                evaluations,
                note,
            },
        })
    }

    /// Reads a document; nothing but a whole and consistent model is accepted.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        if text.len() > MOST_BYTES {
            return Err(DocumentError::Size { found: text.len() });
        }
        let value: serde_json::Value = serde_json::from_str(text).map_err(DocumentError::Json)?;
        let header = Header::deserialize(&value)
            .map_err(|e| DocumentError::Field { path: "the document".into(), message: e.to_string() })?;
        match header.format {
            Some(serde_json::Value::String(format)) if format == FORMAT => {}
            Some(other) => return Err(DocumentError::Format { found: other.to_string() }),
            None => return Err(DocumentError::Format { found: "no format".to_owned() }),
        }
        match header.version {
            Some(found) if found > VERSION => return Err(DocumentError::Version { found }),
            Some(VERSION) => {}
            _ => return field("version", format!("expected {VERSION}")),
        }
        let document: Document = serde_path_to_error::deserialize(value).map_err(|e| {
            DocumentError::Field { path: e.path().to_string(), message: e.inner().to_string() }
        })?;
        document.into_model()
    }
}

fn expert_json(expert: &FittedExpert) -> ExpertJson {
    ExpertJson {
        lambda: expert.kernel.lambda.as_slice().to_vec(),
        z: expert.z.clone(),
        u_mean: expert.mean.clone(),
    }
}

fn field<T>(path: impl Into<String>, message: impl Into<String>) -> Result<T, DocumentError> {
    Err(DocumentError::Field { path: path.into(), message: message.into() })
}

fn shape(path: String, found: (usize, usize), expected: (usize, usize)) -> Result<(), DocumentError> {
    if found == expected {
        return Ok(());
    }
    field(path, format!("expected {} x {} numbers, found {} x {}", expected.0, expected.1, found.0, found.1))
}

fn count(path: impl Into<String>, found: usize, lowest: usize, highest: usize) -> Result<(), DocumentError> {
    if (lowest..=highest).contains(&found) {
        return Ok(());
    }
    let expected = if lowest == highest { lowest.to_string() } else { format!("from {lowest} to {highest}") };
    field(path, format!("expected {expected}, found {found}"))
}

fn positive(path: impl Into<String>, values: &[f64]) -> Result<(), DocumentError> {
    match values.iter().find(|v| !(1e-12..=1e12).contains(*v)) {
        None => Ok(()),
        Some(v) => field(path, format!("expected positive numbers up to 1e12, found {v}")),
    }
}

/// Beyond this no sum of products stays finite for sure.
fn tame(path: impl Into<String>, values: &[f64]) -> Result<(), DocumentError> {
    match values.iter().find(|v| !(-1e12..=1e12).contains(*v)) {
        None => Ok(()),
        Some(v) => field(path, format!("expected numbers up to 1e12 in size, found {v}")),
    }
}

impl Document {
    fn into_model(self) -> Result<MotionModel, DocumentError> {
        let m = self.parts.len();
        count("parts", m, 1, MOST_PARTS)?;
        count("order", self.order, 1, MOST_ORDER)?;
        count("dynamics", self.dynamics.len(), m, m)?;
        count("sequences", self.sequences.len(), 1, MOST_SEQUENCES)?;
        if !(0.0..=1.0).contains(&self.jitter) {
            return field("jitter", format!("expected a number from 0 to 1, found {}", self.jitter));
        }
        if !(1e-5..=10.0).contains(&self.frame_time) {
            return field(
                "frame_time",
                format!("expected seconds from 0.00001 to 10, found {}", self.frame_time),
            );
        }
        shape("alpha".to_owned(), self.alpha.shape(), (m, m))?;
        positive("alpha", self.alpha.as_slice())?;
        let specs: Vec<PartSpec> =
            self.parts.iter().map(|p| PartSpec { name: p.name.clone(), joints: p.joints.clone() }).collect();
        let layout = PartsLayout::new(&specs, &self.pose)?;
        let columns = self.pose.column_count();
        shape("column_means".to_owned(), self.column_means.shape(), (columns, 1))?;
        tame("column_means", self.column_means.as_slice())?;
        for (i, part) in self.parts.iter().enumerate() {
            part.check(&format!("parts[{i}]"), layout.columns(i).len())?;
        }
        let latent: Vec<usize> = self.parts.iter().map(|p| p.lambda.len()).collect();
        for (i, target) in self.dynamics.iter().enumerate() {
            target.check(&format!("dynamics[{i}]"), &latent, i, self.order)?;
        }
        let mut starts = Vec::new();
        for (s, sequence) in self.sequences.iter().enumerate() {
            starts.push(sequence.start(&format!("sequences[{s}]"), &latent, self.order)?);
        }
        let experts = (0..m).map(|j| self.dynamics.iter().map(|target| target.experts[j].fitted()).collect());
        let fitted = FittedModel {
            order: self.order,
            jitter: self.jitter,
            experts: experts.collect(),
            dynamics_covariance: self.dynamics.iter().map(|t| t.u_covariance.clone()).collect(),
            sums: self.dynamics.iter().map(TargetJson::sums).collect(),
            parts: self.parts.into_iter().map(PartJson::pose_map).collect(),
            alpha: self.alpha,
            starts,
        };
        let info = |s: SequenceJson| SequenceInfo { name: s.clip, sha256: s.sha256, frames: s.frames };
        let sequences = self.sequences.into_iter().map(info).collect();
        let ProvenanceJson {
            engine,
            settings,
            frames_per_second,
            bound,
            terms,
            iterations,
            evaluations,
            note,
        } = self.provenance;
        let provenance =
            Provenance { engine, settings, frames_per_second, bound, terms, iterations, evaluations, note };
        let means = self.column_means.as_slice().to_vec();
        Ok(MotionModel::new(fitted, self.pose, layout, means, self.frame_time, sequences, provenance)?)
    }
}

impl PartJson {
    fn check(&self, path: &str, columns: usize) -> Result<(), DocumentError> {
        let q = self.lambda.len();
        count(format!("{path}.lambda"), q, 1, MOST_LATENT)?;
        positive(format!("{path}.lambda"), &self.lambda)?;
        positive(format!("{path}.variance"), &[self.variance])?;
        positive(format!("{path}.beta"), &[self.beta])?;
        let l = self.r.nrows();
        count(format!("{path}.r"), l, 1, MOST_IPS)?;
        shape(format!("{path}.r"), self.r.shape(), (l, q))?;
        shape(format!("{path}.v_mean"), self.v_mean.shape(), (l, columns))?;
        shape(format!("{path}.v_covariance"), self.v_covariance.shape(), (l, l))?;
        tame(format!("{path}.r"), self.r.as_slice())?;
        tame(format!("{path}.v_mean"), self.v_mean.as_slice())?;
        tame(format!("{path}.v_covariance"), self.v_covariance.as_slice())
    }

    fn pose_map(self) -> PoseMap {
        PoseMap {
            r: self.r,
            kernel: Kernel { lambda: DVector::from_vec(self.lambda), variance: self.variance },
            beta: self.beta,
            mean: self.v_mean,
            covariance: self.v_covariance,
        }
    }
}

impl TargetJson {
    fn check(&self, path: &str, latent: &[usize], target: usize, order: usize) -> Result<(), DocumentError> {
        count(format!("{path}.experts"), self.experts.len(), latent.len(), latent.len())?;
        let mut total = 0;
        for (j, (expert, q)) in self.experts.iter().zip(latent).enumerate() {
            let at = |name: &str| format!("{path}.experts[{j}].{name}");
            let (k, dims) = (expert.z.nrows(), order * q);
            count(at("z"), k, 1, MOST_IPS)?;
            shape(at("z"), expert.z.shape(), (k, dims))?;
            count(at("lambda"), expert.lambda.len(), dims, dims)?;
            positive(at("lambda"), &expert.lambda)?;
            shape(at("u_mean"), expert.u_mean.shape(), (k, latent[target]))?;
            tame(at("z"), expert.z.as_slice())?;
            tame(at("u_mean"), expert.u_mean.as_slice())?;
            total += k;
        }
        let square = (total, total);
        shape(format!("{path}.u_covariance"), self.u_covariance.shape(), square)?;
        shape(format!("{path}.sum_psi2"), self.sum_psi2.shape(), square)?;
        shape(format!("{path}.sum_psi1_mu"), self.sum_psi1_mu.shape(), (total, latent[target]))?;
        tame(format!("{path}.u_covariance"), self.u_covariance.as_slice())?;
        tame(format!("{path}.sum_psi2"), self.sum_psi2.as_slice())?;
        tame(format!("{path}.sum_psi1_mu"), self.sum_psi1_mu.as_slice())
    }

    fn sums(&self) -> DynamicsSums {
        DynamicsSums { psi2: self.sum_psi2.clone(), psi1_mu: self.sum_psi1_mu.clone() }
    }
}

impl ExpertJson {
    fn fitted(&self) -> FittedExpert {
        let kernel = Kernel { lambda: DVector::from_column_slice(&self.lambda), variance: 1.0 };
        FittedExpert { z: self.z.clone(), kernel, mean: self.u_mean.clone() }
    }
}

impl SequenceJson {
    fn start(&self, path: &str, latent: &[usize], order: usize) -> Result<Vec<DMatrix<f64>>, DocumentError> {
        count(format!("{path}.start"), self.start.len(), latent.len(), latent.len())?;
        let parts = self.start.iter().zip(latent).enumerate().map(|(i, (rows, q))| {
            let at = format!("{path}.start[{i}]");
            let start = rows::matrix_from_rows(rows)
                .map_err(|message| DocumentError::Field { path: at.clone(), message })?;
            shape(at.clone(), start.shape(), (order, *q))?;
            tame(at, start.as_slice())?;
            Ok(start)
        });
        parts.collect()
    }
}

#[cfg(test)]
mod tests;
