//! Models of every kind that the terminal and the page write, of bodies and of tables, as they were learned.

use crate::body::BodyInfo;
use crate::clip::Clip;
use crate::convert::{flat, from_js, rows, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::{Text, Whole};
use crate::model::Model;
use nalgebra::DMatrix;
use serde::Serialize;
use std::rc::Rc;
use vcgpdm::document::Document;
use vcgpdm::models::{
    Body, ColumnMapping, Model as TrainedModel, ModelKind, RolloutRequest, SequenceInfo, SeriesModel,
    Settings,
};
use vcgpdm::motion::parts::PartSpec;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What there is to know of a model of any kind. */
export interface AnyModelInfo {
    kind: ModelKind;
    /** Of a body its parts as they are; of tables the joints are places of columns. */
    parts: PartSpec[];
    /** The names of all columns, in the order of a rollout's values. */
    columns: string[];
    /** Seconds from one frame to the next. */
    frameTime: number;
    sequences: SequenceInfo[];
    /** Coupling variances as learned, `alpha[source][target]`, of a vCGPDM or vGPDM; null for other kinds. */
    alpha: number[][] | null;
    /** The body; null for a model of tables. */
    body: { joints: JointInfo[]; figure: Figure } | null;
    provenance: {
        engine: string;
        settings: Candidate;
        seed: number;
        framesPerSecond: number;
        /** The bound or what else training maximised. */
        objective: number;
        iterations: number;
        note: string | null;
    };
}
"#;

#[derive(Serialize)]
struct Made<'a> {
    engine: &'a str,
    settings: &'a Settings,
    seed: u32,
    frames_per_second: f64,
    objective: f64,
    iterations: usize,
    note: Option<&'a str>,
}

#[derive(Serialize)]
struct AnyModelInfo<'a> {
    kind: ModelKind,
    parts: &'a [PartSpec],
    columns: Vec<String>,
    frame_time: f64,
    sequences: &'a [SequenceInfo],
    alpha: Option<Vec<Vec<f64>>>,
    body: Option<BodyInfo>,
    provenance: Made<'a>,
}

/// A model of a body or of tables.
pub(crate) enum Any {
    Body(Rc<TrainedModel>),
    Series(Rc<SeriesModel>),
}

/// A trained model of any kind, of a body or of tables, as it was learned.
#[wasm_bindgen]
pub struct AnyModel {
    pub(crate) model: Any,
}

#[wasm_bindgen]
impl AnyModel {
    /// Reads a model of any kind. Throws the reason and the path of the field when the text is not one.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<AnyModel, VcgpdmError> {
        let text = text.get(ErrorCode::Model, "the document")?;
        let model = match Document::from_json(&text)? {
            Document::Body(model) => Any::Body(Rc::new(*model)),
            Document::Series(model) => Any::Series(Rc::new(*model)),
        };
        Ok(AnyModel { model })
    }

    /// The model as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        Ok(match &self.model {
            Any::Body(model) => model.to_json()?,
            Any::Series(model) => model.to_json()?,
        })
    }

    /// What there is to know of it.
    #[wasm_bindgen(unchecked_return_type = "AnyModelInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        match &self.model {
            Any::Body(model) => to_js(&info(model, Some(BodyInfo::new(model.body.mapping.skeleton())))),
            Any::Series(model) => to_js(&info(model, None)),
        }
    }

    /// The same model with its couplings, latents and inducing points; undefined for a model of tables, or
    /// one that is neither a vCGPDM nor a vGPDM.
    pub fn coupled(&self) -> Option<Model> {
        let Any::Body(model) = &self.model else { return None };
        model.coupled().map(|_| Model { model: Rc::clone(model) })
    }

    /// A rollout from a training sequence's start. Only a vCGPDM or vGPDM can start from another frame or
    /// have other couplings.
    pub fn rollout(
        &self,
        #[wasm_bindgen(unchecked_param_type = "RolloutOptions")] options: JsValue,
    ) -> Result<AnyRollout, VcgpdmError> {
        let request: RolloutRequest = from_js(ErrorCode::Rollout, "rollout", &options)?;
        let (rolled, frame_time, body) = match &self.model {
            Any::Body(model) => (roll(model, &request)?, model.body.frame_time, Some(Rc::clone(model))),
            Any::Series(model) => (roll(model, &request)?, model.body.frame_time, None),
        };
        let Rolled { y, latents, weights, columns } = rolled;
        Ok(AnyRollout { y, latents, weights, columns, frame_time, body })
    }
}

fn info<'a, S: ColumnMapping>(trained: &'a TrainedModel<S>, figure: Option<BodyInfo>) -> AnyModelInfo<'a> {
    let (body, made) = (&trained.body, &trained.provenance);
    AnyModelInfo {
        kind: trained.kind(),
        parts: body.layout.parts(),
        columns: names(body),
        frame_time: body.frame_time,
        sequences: &body.sequences,
        alpha: trained.coupled().map(|coupled| rows(&coupled.model.alpha)),
        body: figure,
        provenance: Made {
            engine: &made.engine,
            settings: &made.settings,
            seed: made.seed,
            frames_per_second: made.frames_per_second,
            objective: made.objective,
            iterations: made.iterations,
            note: made.note.as_deref(),
        },
    }
}

fn names<S: ColumnMapping>(body: &Body<S>) -> Vec<String> {
    (0..body.column_means.len()).map(|column| body.mapping.column_name(column)).collect()
}

struct Rolled {
    y: DMatrix<f64>,
    latents: Vec<DMatrix<f64>>,
    weights: Option<DMatrix<f64>>,
    columns: Vec<String>,
}

fn roll<S: ColumnMapping>(model: &TrainedModel<S>, request: &RolloutRequest) -> Result<Rolled, VcgpdmError> {
    let columns = names(&model.body);
    match model.coupled() {
        Some(coupled) => {
            let rolled = coupled.rollout(request)?;
            Ok(Rolled { y: rolled.y, latents: rolled.latents, weights: Some(rolled.weights), columns })
        }
        None if request.alpha.is_some() || request.frame > 0 => {
            let words = format_args!(
                "expected a vcgpdm or vgpdm model for other couplings or another frame, found a {} model",
                model.kind().id()
            );
            Err(VcgpdmError::new(ErrorCode::Rollout, &words))
        }
        None => {
            let y = model.rollout(request.sequence, request.frames)?;
            Ok(Rolled { y, latents: Vec::new(), weights: None, columns })
        }
    }
}

/// What a model of any kind predicts.
#[wasm_bindgen]
pub struct AnyRollout {
    y: DMatrix<f64>,
    latents: Vec<DMatrix<f64>>,
    weights: Option<DMatrix<f64>>,
    columns: Vec<String>,
    frame_time: f64,
    body: Option<Rc<TrainedModel>>,
}

#[wasm_bindgen]
impl AnyRollout {
    /// All columns [frames x columns], in their own units.
    pub fn values(&self) -> Vec<f64> {
        flat(&self.y)
    }

    /// The latent path of a part [frames x Q], of a vCGPDM or vGPDM.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        self.latents.get(part).map(flat).ok_or_else(|| {
            let words = format_args!(
                "expected a part below {} of a model with latents, found {part}",
                self.latents.len()
            );
            VcgpdmError::new(ErrorCode::Rollout, &words)
        })
    }

    /// The weights `w[source][target]` that the couplings give the experts, of a vCGPDM or vGPDM; null for
    /// other kinds.
    #[wasm_bindgen(unchecked_return_type = "number[][] | null")]
    pub fn weights(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.weights.as_ref().map(rows))
    }

    /// The columns as CSV: frame, time in seconds, and a column for each.
    #[wasm_bindgen(js_name = toCsv)]
    pub fn to_csv(&self) -> String {
        vcgpdm::series::write(&self.columns, &self.y, self.frame_time)
    }

    /// The motion of a model of a body. Throws for a model of tables, which has none.
    #[wasm_bindgen(js_name = toClip)]
    pub fn to_clip(&self) -> Result<Clip, VcgpdmError> {
        let Some(model) = &self.body else {
            return Err(VcgpdmError::new(
                ErrorCode::Rollout,
                &"expected a model of a body, found a model of tables",
            ));
        };
        Ok(Clip { clip: model.body.clip(&self.y, "motion.bvh")? })
    }
}
