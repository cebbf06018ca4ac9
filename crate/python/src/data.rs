//! What a model is trained on: clips of a body, or arrays of numbers; and their parts.

use crate::arrays::matrix;
use crate::clip::Clip;
use crate::refused;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use vcgpdm_core::models::{Dataset, Source};
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::motion::parts::{self, GivenJoint, GivenPart};
use vcgpdm_core::motion::{Clip as Motion, Skeleton};
use vcgpdm_core::series::Table;
use vcgpdm_core::series::{Columns, parse_parts, whole};

/// A data set of either kind.
pub enum Data {
    Body(Box<Dataset>),
    Series(Box<Dataset<Columns>>),
}

/// The argument `parts`.
enum Parts {
    Usual,
    Text(String),
    Lists(Vec<(String, Vec<Member>)>),
}

/// A joint or column.
#[derive(FromPyObject)]
enum Member {
    Name(String),
    Place(i64),
}

/// The data set of the arguments of `fit`. Clips are brought to `fps` frames a second; arrays have them.
pub fn data(
    given: &Bound<'_, PyAny>,
    parts: Option<&Bound<'_, PyAny>>,
    columns: Option<Vec<String>>,
    fps: f64,
) -> PyResult<Data> {
    let parts = read_parts(parts)?;
    let trials = trials(given)?;
    let is_clip = |trial: &Bound<'_, PyAny>| trial.is_instance_of::<Clip>();
    if !trials.is_empty() && trials.iter().all(is_clip) {
        if columns.is_some() {
            return Err(refused("columns: expected none with clips, whose joints have names"));
        }
        let clips = trials.iter().map(|trial| Ok(trial.cast::<Clip>()?.get().clip.clone()));
        let clips: Vec<Motion> = clips.collect::<PyResult<_>>()?;
        let parts = body_parts(parts, &clips[0].skeleton)?;
        let sources: Vec<Source> = clips.iter().map(Source::from).collect();
        let dataset = Dataset::new(&sources, &parts, fps).map_err(refused)?;
        return Ok(Data::Body(Box::new(dataset)));
    }
    if let Some(place) = trials.iter().position(is_clip) {
        return Err(refused(format!("trial {place}: expected an array as the others, found a clip")));
    }
    if !(0.1..=100_000.0).contains(&fps) {
        return Err(refused(format!("fps: expected 0.1 to 100000 rows a second, found {fps}")));
    }
    let tables = trials.iter().enumerate().map(|(place, trial)| {
        let name = format!("trial {place}");
        let values = matrix(trial, &name)?;
        let usual = || (0..values.ncols()).map(|column| format!("y{column}")).collect();
        let names = columns.clone().unwrap_or_else(usual);
        let table = Table::checked(&name, names, values, 1.0 / fps).map_err(refused)?;
        // As a file without times: the frame rate is the argument, to the last bit.
        Ok(Table { frame_time: None, ..table })
    });
    let tables: Vec<Table> = tables.collect::<PyResult<_>>()?;
    let parts = column_parts(parts, tables.first().map_or(&[], |table| &table.columns))?;
    let dataset = Dataset::of_tables(&tables, &parts, fps).map_err(refused)?;
    Ok(Data::Series(Box::new(dataset)))
}

/// One trial, or several: clips, arrays of two dimensions or what numpy makes such arrays of.
fn trials<'py>(given: &Bound<'py, PyAny>) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let dimensions: Option<usize> =
        given.getattr("ndim").ok().and_then(|dimensions| dimensions.extract().ok());
    if given.is_instance_of::<Clip>() || dimensions.is_some_and(|dimensions| dimensions < 3) {
        return Ok(vec![given.clone()]);
    }
    let several = given.try_iter().map_err(|_| {
        let found = given.get_type();
        PyTypeError::new_err(format!("data: expected clips or arrays [frames x columns], found {found}"))
    })?;
    several.collect()
}

fn read_parts(given: Option<&Bound<'_, PyAny>>) -> PyResult<Parts> {
    let Some(given) = given else { return Ok(Parts::Usual) };
    if let Ok(text) = given.cast::<PyString>() {
        return Ok(Parts::Text(text.to_string()));
    }
    let lists = given.cast::<PyDict>().map_err(|_| {
        let found = given.get_type();
        let expected = "the name of a split, or a dict of names with lists";
        PyTypeError::new_err(format!("parts: expected {expected}, found {found}"))
    })?;
    let part = |(name, members): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        if members.is_instance_of::<PyString>() {
            return Err(PyTypeError::new_err(format!("part {name:?}: expected a list, found {members}")));
        }
        let members = members.try_iter()?.map(|member| member?.extract::<Member>());
        Ok((name, members.collect::<PyResult<_>>()?))
    };
    lists.iter().map(part).collect::<PyResult<_>>().map(Parts::Lists)
}

/// The parts of a body; usually those of the lower and upper body, or else the whole body.
fn body_parts(given: Parts, skeleton: &Skeleton) -> PyResult<Vec<PartSpec>> {
    match given {
        Parts::Usual => {
            let usual = ["lower-upper", "whole"].iter().find_map(|id| parts::preset_parts(id, skeleton));
            Ok(usual.unwrap_or_default())
        }
        Parts::Text(text) => parts::preset_parts(&text, skeleton).ok_or_else(|| {
            let splits = parts::preset_names(skeleton);
            refused(format!("parts: expected a dict or a split of this body ({splits}), found {text:?}"))
        }),
        Parts::Lists(lists) => {
            let joint = |member| match member {
                Member::Name(name) => GivenJoint::Name(name),
                Member::Place(place) => {
                    GivenJoint::Other { index: usize::try_from(place).ok(), shown: place.to_string() }
                }
            };
            let part = |(name, members): (String, Vec<Member>)| GivenPart {
                name,
                joints: members.into_iter().map(joint).collect(),
            };
            parts::from_given(lists.into_iter().map(part).collect(), skeleton).map_err(refused)
        }
    }
}

/// The parts of tables; usually one part with all columns.
fn column_parts(given: Parts, columns: &[String]) -> PyResult<Vec<PartSpec>> {
    let lists = match given {
        Parts::Usual => return Ok(whole(columns.len())),
        Parts::Text(text) if text == "whole" => return Ok(whole(columns.len())),
        Parts::Text(text) => return parse_parts(&text, columns).map_err(refused),
        Parts::Lists(lists) => lists,
    };
    let part = |(name, members): (String, Vec<Member>)| {
        let place = |member: &Member| {
            let (found, shown) = match member {
                Member::Name(column) => {
                    (columns.iter().position(|other| other == column), format!("{column:?}"))
                }
                Member::Place(place) => (usize::try_from(*place).ok(), place.to_string()),
            };
            let last = columns.len().saturating_sub(1);
            found.filter(|&place| place <= last).ok_or_else(|| {
                let expected = format!("a column from 0 to {last} or its name");
                refused(format!("part {name:?}: expected {expected}, found {shown}"))
            })
        };
        let joints = members.iter().map(place).collect::<PyResult<_>>()?;
        Ok(PartSpec { name, joints })
    };
    lists.into_iter().map(part).collect()
}
