//! The face of the wasm package: converts and forwards. The only folder with `#[wasm_bindgen]`.

#[cfg(feature = "speed")]
mod case;
mod clip;
#[cfg(feature = "comparison")]
mod comparison;
mod model;
mod rollout;
#[cfg(feature = "comparison")]
mod synthetic;
mod training;

use crate::models::variational::elbo::BoundTerms;
use crate::motion::parts::PartSpec as Part;
use crate::motion::skeleton::Skeleton;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// Which joints move together: a part is a named group of joints, by their place in the skeleton.
#[derive(Clone, Serialize, Deserialize, Tsify)]
pub struct PartSpec {
    pub name: String,
    pub joints: Vec<usize>,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct JointInfo {
    pub name: String,
    pub parent: Option<usize>,
    pub channels: Vec<String>,
}

/// What a picture of the body draws: a node for every joint and end site; a bone runs from each node to its parent node.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct FigureNode {
    pub joint: usize,
    pub parent: Option<usize>,
    pub end_site: bool,
}

#[derive(Serialize, Tsify)]
pub struct Figure {
    pub nodes: Vec<FigureNode>,
}

/// The terms of the bound, in nats.
#[derive(Serialize, Tsify)]
pub struct Terms {
    /// The pose map of each part.
    pub kinematics: Vec<f64>,
    /// The dynamics into each part.
    pub dynamics: Vec<f64>,
    pub initial: f64,
    pub entropy: f64,
}

fn error(e: impl std::fmt::Display) -> JsError {
    JsError::new(&e.to_string())
}

/// A value from JavaScript. The error names it and says what was wrong with it, without the program's own names of types.
fn read<T>(what: &str, value: &Ts<T>) -> Result<T, JsError>
where
    T: Tsify<JsType: Clone> + serde::de::DeserializeOwned,
{
    value.to_rust().map_err(|problem| {
        let text = problem.to_string();
        let words = text.split_once("`: ").map_or(text.as_str(), |(_, words)| words);
        error(format!("{what}: {}", words.trim_start_matches("Error: ")))
    })
}

fn joints(skeleton: &Skeleton) -> Vec<JointInfo> {
    let joint = |j: &crate::motion::skeleton::Joint| JointInfo {
        name: j.name.clone(),
        parent: j.parent,
        channels: j.channels.iter().map(|c| c.name().to_owned()).collect(),
    };
    skeleton.joints.iter().map(joint).collect()
}

fn figure(skeleton: &Skeleton) -> Figure {
    let nodes = skeleton.figure().into_iter();
    Figure {
        nodes: nodes.map(|n| FigureNode { joint: n.joint, parent: n.parent, end_site: n.end_site }).collect(),
    }
}

fn part_spec(part: &Part) -> PartSpec {
    PartSpec { name: part.name.clone(), joints: part.joints.clone() }
}

fn parts(specs: &[PartSpec]) -> Vec<Part> {
    specs.iter().map(|p| Part { name: p.name.clone(), joints: p.joints.clone() }).collect()
}

fn terms(terms: &BoundTerms) -> Terms {
    Terms {
        kinematics: terms.kinematics.clone(),
        dynamics: terms.dynamics.clone(),
        initial: terms.initial,
        entropy: terms.entropy,
    }
}

/// Row after row.
fn flat(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

/// A fresh seed from the machine's own randomness.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<u32, JsError> {
    getrandom::u32().map_err(error)
}

/// The version of this package.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
