//! Libraries of primitives: what they hold, and how they are combined.

use crate::body::BodyInfo;
use crate::clip::TrainingSet;
use crate::convert::{flat, from_js, rows, to_js, to_js_beside};
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::{Text, Whole};
use crate::model::{Model, PartInfo, Provenance, part_infos, provenance_info};
use crate::settings::{Task, settings_from_js, settings_to_js};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use vcgpdm::models::library::{
    CouplingTrainer as Fit, CouplingsFrom, LearnedMovement, LibraryPlan, LibraryTrainer as Training,
    LibraryWalk as Walk, PlannedMovement, TrainedLibrary, WalkFrames as Frames,
};
use vcgpdm::models::variational::InducingError;
use vcgpdm::models::{Dataset, SequenceInfo, Source};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Where the couplings of a movement come from: learned with the primitives, fitted to clips, taken from a movement, or 1 each. */
export type CouplingsFrom =
    | { from: "training" }
    | { from: "clips"; bound: number; iterations: number }
    | { from: "movement"; movement: string }
    | { from: "nothing" };

/** A primitive: the dynamics of one part. */
export interface PrimitiveInfo {
    name: string;
    /** The part that it belongs to. */
    part: number;
}

/** A movement of a library. */
export interface MovementInfo {
    name: string;
    /** The primitive of each part. */
    uses: number[];
    /** Coupling variances, `alpha[source][target]`. */
    alpha: number[][];
    /** Whether the primitives learned from it. */
    learned: boolean;
    couplings: CouplingsFrom;
    sequences: SequenceInfo[];
}

/** What there is to know of a library. */
export interface LibraryInfo {
    parts: PartInfo[];
    primitives: PrimitiveInfo[];
    movements: MovementInfo[];
    /** Order p of the dynamics. */
    order: number;
    /** Seconds from one frame to the next. */
    frameTime: number;
    joints: JointInfo[];
    figure: Figure;
    provenance: Provenance;
}

/** What a library learns: movements with how many clips each has, in order, and of each part whether its primitive is the same in all. */
export interface LibraryPlan {
    movements: { name: string; sequences: number }[];
    shared: boolean[];
}
"#;

#[derive(Serialize)]
#[serde(tag = "from", rename_all = "lowercase")]
enum Origin<'a> {
    Training,
    Clips { bound: f64, iterations: usize },
    Movement { movement: &'a str },
    Nothing,
}

impl<'a> From<&'a CouplingsFrom> for Origin<'a> {
    fn from(couplings: &'a CouplingsFrom) -> Self {
        match couplings {
            CouplingsFrom::Training => Self::Training,
            CouplingsFrom::Clips { bound, iterations } => {
                Self::Clips { bound: *bound, iterations: *iterations }
            }
            CouplingsFrom::Movement(movement) => Self::Movement { movement },
            CouplingsFrom::Nothing => Self::Nothing,
        }
    }
}

#[derive(Serialize)]
struct PrimitiveInfo<'a> {
    name: &'a str,
    part: usize,
}

#[derive(Serialize)]
struct MovementInfo<'a> {
    name: &'a str,
    uses: &'a [usize],
    alpha: Vec<Vec<f64>>,
    learned: bool,
    couplings: Origin<'a>,
    sequences: &'a [SequenceInfo],
}

#[derive(Serialize)]
struct LibraryInfo<'a> {
    parts: Vec<PartInfo<'a>>,
    primitives: Vec<PrimitiveInfo<'a>>,
    movements: Vec<MovementInfo<'a>>,
    order: usize,
    frame_time: f64,
    provenance: Provenance<'a>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planned {
    movements: Vec<PlannedName>,
    shared: Vec<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PlannedName {
    name: String,
    sequences: usize,
}

fn matrix(alpha: &[Vec<f64>]) -> DMatrix<f64> {
    // What is missing is no number, which the library refuses.
    let at = |j: usize, i: usize| alpha.get(j).and_then(|row: &Vec<f64>| row.get(i)).copied();
    let columns = alpha.iter().map(Vec::len).max().unwrap_or(0);
    DMatrix::from_fn(alpha.len(), columns, |j, i| at(j, i).unwrap_or(f64::NAN))
}

fn uses_of(uses: &JsValue) -> Result<Vec<usize>, VcgpdmError> {
    from_js(ErrorCode::Model, "the primitives", uses)
}

/// A library of primitives.
#[wasm_bindgen]
pub struct Library {
    trained: Rc<TrainedLibrary>,
}

#[wasm_bindgen]
impl Library {
    /// Reads a shared library. Throws the reason and the path of the field when the text is not one.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Library, VcgpdmError> {
        let text = text.get(ErrorCode::Model, "the document")?;
        Ok(Library { trained: Rc::new(TrainedLibrary::from_json(&text)?) })
    }

    /// The library as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        Ok(self.trained.to_json()?)
    }

    /// What there is to know of it.
    #[wasm_bindgen(unchecked_return_type = "LibraryInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let TrainedLibrary { library, body, provenance } = &*self.trained;
        let task = Task {
            parts: body.layout.parts().to_vec(),
            frames_per_second: provenance.frames_per_second,
            seed: provenance.seed,
        };
        let mut rest = &body.sequences[..];
        let movement = |movement: &LearnedMovement| {
            let (own, others) = rest.split_at(movement.starts.len().min(rest.len()));
            rest = others;
            (own, movement.clone())
        };
        let movements: Vec<_> = library.movements.iter().map(movement).collect();
        let info = LibraryInfo {
            parts: part_infos(body.layout.parts(), &library.parts),
            primitives: library
                .primitives
                .iter()
                .map(|primitive| PrimitiveInfo { name: &primitive.name, part: primitive.part })
                .collect(),
            movements: movements
                .iter()
                .map(|(sequences, movement)| MovementInfo {
                    name: &movement.name,
                    uses: &movement.uses,
                    alpha: rows(&movement.alpha),
                    learned: movement.sums.is_some(),
                    couplings: Origin::from(&movement.couplings),
                    sequences,
                })
                .collect(),
            order: library.order,
            frame_time: body.frame_time,
            provenance: provenance_info(
                provenance,
                &library.terms,
                settings_to_js(&task, &provenance.settings)?,
            ),
        };
        to_js_beside(&info, &BodyInfo::new(body.mapping.skeleton()))
    }

    /// The model of a movement, as it was learned.
    pub fn movement(&self, index: &Whole) -> Result<Model, VcgpdmError> {
        let index = index.count(ErrorCode::Model, "the movement")?;
        Ok(Model { model: Rc::new(self.trained.movement(index)?) })
    }

    /// The model of a combination, the primitive of each part; under the couplings of `nearestCouplings` where none are given.
    pub fn combination(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number[][] | null")] alpha: JsValue,
    ) -> Result<Model, VcgpdmError> {
        let uses = uses_of(&uses)?;
        let given: Option<Vec<Vec<f64>>> = from_js(ErrorCode::Model, "the couplings", &alpha)?;
        let alpha = match given {
            Some(alpha) => matrix(&alpha),
            None => self.trained.library.nearest_couplings(&uses),
        };
        Ok(Model { model: Rc::new(self.trained.combination(&uses, &alpha)?) })
    }

    /// The couplings of a combination that nobody has fitted, `alpha[source][target]`: of each source those of a trained movement that
    /// uses its primitive, of several of the one most like the combination; 1 where there is none.
    #[wasm_bindgen(js_name = nearestCouplings, unchecked_return_type = "number[][]")]
    pub fn nearest_couplings(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
    ) -> Result<JsValue, VcgpdmError> {
        let uses = uses_of(&uses)?;
        self.trained.library.check_uses(&uses)?;
        to_js(&rows(&self.trained.library.nearest_couplings(&uses)))
    }

    /// A library with the combination added as a movement of that name, under these couplings; one of the same name makes way.
    #[wasm_bindgen(js_name = withCombination)]
    pub fn with_combination(
        &self,
        name: &Text,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] alpha: JsValue,
    ) -> Result<Library, VcgpdmError> {
        let name = name.get(ErrorCode::Model, "the name")?;
        let uses = uses_of(&uses)?;
        let alpha: Vec<Vec<f64>> = from_js(ErrorCode::Model, "the couplings", &alpha)?;
        let alpha = matrix(&alpha);
        let mut trained = TrainedLibrary::clone(&self.trained);
        // The same checks as those of a model that is rolled out.
        trained.combination(&uses, &alpha)?;
        let movement = LearnedMovement { alpha, ..trained.library.nearest_combination(&name, &uses)? };
        let infos = trained.start_infos(&uses);
        trained.add(movement, infos);
        Ok(Library { trained: Rc::new(trained) })
    }

    /// A figure that goes on without an end, of a combination.
    pub fn walk(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
    ) -> Result<LibraryWalk, VcgpdmError> {
        let walk = Walk::new(&self.trained, &uses_of(&uses)?)?;
        Ok(LibraryWalk { trained: Rc::clone(&self.trained), walk })
    }

    /// How firmly the target is locked to the source, 0 to 1, for each tempo of the target and strength of the coupling between them
    /// [tempos x strengths, one tempo after the other]. A strength divides the coupling variance.
    #[wasm_bindgen(js_name = lockingMap)]
    pub fn locking_map(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        source: &Whole,
        target: &Whole,
        tempos: &[f64],
        strengths: &[f64],
    ) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Rollout, "the source")?;
        let target = target.count(ErrorCode::Rollout, "the target")?;
        let uses = uses_of(&uses)?;
        let map = self.trained.library.locking(&uses, (source, target), tempos, strengths, LOCKING_FRAMES)?;
        Ok(flat(&map))
    }
}

/// Frames of each rollout of a map of locking: some twenty seconds.
const LOCKING_FRAMES: usize = 600;

/// A training of a library under way, step by step.
#[wasm_bindgen]
pub struct LibraryTrainer {
    dataset: Dataset,
    training: Training,
    frames_per_second: f64,
}

#[wasm_bindgen]
impl LibraryTrainer {
    /// Prepares the clips, which are those of the plan's movements one after the other, and finds the starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "TrainingSettings")] settings: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LibraryPlan")] plan: JsValue,
    ) -> Result<LibraryTrainer, VcgpdmError> {
        let (Task { parts, frames_per_second, seed }, settings) = settings_from_js(&settings)?;
        let Planned { movements, shared } = from_js(ErrorCode::Training, "the plan", &plan)?;
        let movements = movements
            .into_iter()
            .map(|movement| PlannedMovement { name: movement.name, sequences: movement.sequences });
        let plan = LibraryPlan::new(movements.collect(), shared)
            .map_err(|reason| VcgpdmError::new(ErrorCode::Training, &reason))?;
        let sources: Vec<Source> =
            clips.clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
        let training = Training::new(dataset.y.clone(), dataset.lengths(), plan, &settings, seed)
            .map_err(|reason| dataset.refusal(reason))?;
        Ok(LibraryTrainer { dataset, training, frames_per_second })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.training.step())
    }

    /// Allows so many more iterations: training goes on where it stopped.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        self.training.extend(iterations.count(ErrorCode::Training, "the number of iterations")?);
        Ok(())
    }

    /// The best library so far, at any time.
    pub fn library(&self) -> Result<Library, VcgpdmError> {
        let trained = TrainedLibrary::trained(&self.dataset, &self.training, self.frames_per_second)?;
        Ok(Library { trained: Rc::new(trained) })
    }
}

/// A fit of couplings under way: of a combination, to clips, while its primitives stay.
#[wasm_bindgen]
pub struct CouplingTrainer {
    trained: Rc<TrainedLibrary>,
    fit: Fit,
    sequences: Vec<SequenceInfo>,
}

#[wasm_bindgen]
impl CouplingTrainer {
    /// Prepares the clips, which must have the library's body.
    #[wasm_bindgen(constructor)]
    pub fn new(
        library: &Library,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        clips: &TrainingSet,
        max_iterations: &Whole,
    ) -> Result<CouplingTrainer, VcgpdmError> {
        let iterations = max_iterations.count(ErrorCode::Training, "the number of iterations")?;
        let observed = clips.clips.iter().map(|clip| library.trained.observed(clip));
        let observed = observed.collect::<Result<Vec<_>, _>>()?;
        let fit = library.trained.coupling_trainer(&uses_of(&uses)?, &observed, iterations)?;
        let sequences = observed.into_iter().map(|clip| clip.info).collect();
        Ok(CouplingTrainer { trained: Rc::clone(&library.trained), fit, sequences })
    }

    /// One iteration of the optimiser. The bound is that of the clips under the stored primitives.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.fit.step())
    }

    /// The best couplings so far, `alpha[source][target]`.
    #[wasm_bindgen(unchecked_return_type = "number[][]")]
    pub fn alpha(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&rows(&self.fit.alpha()))
    }

    /// A library with the combination as a movement of that name, which starts where the clips do.
    pub fn library(&self, name: &Text) -> Result<Library, VcgpdmError> {
        let name = name.get(ErrorCode::Model, "the name")?;
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.add(self.fit.movement(&name), self.sequences.clone());
        Ok(Library { trained: Rc::new(trained) })
    }

    /// The combination with the best couplings so far.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.add(self.fit.movement(""), self.sequences.clone());
        Ok(Model { model: Rc::new(trained.movement(trained.library.movements.len() - 1)?) })
    }
}

/// A figure that goes on without an end, while primitives are exchanged and mixed, couplings and tempos changed.
#[wasm_bindgen]
pub struct LibraryWalk {
    trained: Rc<TrainedLibrary>,
    walk: Walk,
}

#[wasm_bindgen]
impl LibraryWalk {
    /// Gives a part another of its primitives, at the state that is nearest to what the other parts do; these go on as they are.
    #[wasm_bindgen(js_name = use)]
    pub fn use_primitive(&mut self, part: &Whole, primitive: &Whole) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let primitive = primitive.count(ErrorCode::Rollout, "the primitive")?;
        Ok(self.walk.latents.use_primitive(&self.trained.library, part, primitive)?)
    }

    /// Mixes the predictions of a part's primitive with those of another one of the part: a share of it from 0 to 1.
    pub fn mix(&mut self, part: &Whole, other: &Whole, share: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let other = other.count(ErrorCode::Rollout, "the primitive")?;
        Ok(self.walk.latents.mix(&self.trained.library, part, other, share)?)
    }

    /// Other couplings, `alpha[source][target]`, from the next frame on.
    #[wasm_bindgen(js_name = setAlpha)]
    pub fn set_alpha(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] alpha: JsValue,
    ) -> Result<(), VcgpdmError> {
        let alpha: Vec<Vec<f64>> = from_js(ErrorCode::Rollout, "the couplings", &alpha)?;
        Ok(self.walk.latents.set_alpha(matrix(&alpha))?)
    }

    /// Lets a part go through its own time at another tempo, 0.25 to 2; 1 is as learned.
    #[wasm_bindgen(js_name = setTempo)]
    pub fn set_tempo(&mut self, part: &Whole, tempo: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.walk.latents.set_tempo(part, tempo)?)
    }

    /// The next frames.
    pub fn advance(&mut self, frames: &Whole) -> Result<WalkFrames, VcgpdmError> {
        let frames = frames.count(ErrorCode::Rollout, "the number of frames")?;
        Ok(WalkFrames(self.walk.advance(&self.trained, frames)?))
    }
}

/// The next frames of a walk.
#[wasm_bindgen]
pub struct WalkFrames(Frames);

#[wasm_bindgen]
impl WalkFrames {
    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let paths = &self.0.latents;
        Ok(flat(paths.get(part).ok_or(InducingError::Part { count: paths.len(), found: part })?))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.0.positions.clone()
    }
}
