//! `vcgpdm rollout`: makes a new motion from a trained model.

mod latents;
mod parse;
mod summary;

use crate::clips::{self, Names, Up};
use crate::files;
use crate::numbers::whole;
use crate::rollout::parse::Start;
pub use crate::rollout::parse::part_index;
use crate::usage::{Usage, first_given, usage};
use nalgebra::DMatrix;
use std::error::Error;
use std::iter::once;
use std::path::{Path, PathBuf};
use vcgpdm_core::document::Document;
use vcgpdm_core::models::{
    Body, ColumnMapping, Coupled, FittedModel, Handles, MOST_FRAMES, MOST_SAMPLES, Model, ModelKind, Reading,
    Rollout, RolloutRequest,
};
use vcgpdm_core::series;

/// Roll a model out and write the motion as BVH, or its columns as CSV.
///
/// Of a vCGPDM or vGPDM of a body, one JSON object says how the motion ends and measures it. It has the
/// dynamics_elbo of the trained model, and the latent_log_density of the motion: the mean log density of the
/// latents of a frame under the learned dynamics, and its difference from that of the training, in nats a frame.
#[derive(clap::Args)]
pub struct Arguments {
    /// A trained model of any kind.
    #[arg(value_name = "MODEL.json")]
    model: PathBuf,
    /// Number of frames, with the start.
    #[arg(long, value_name = "N", value_parser = whole(1..=MOST_FRAMES))]
    frames: usize,
    /// Start where this training sequence starts, counted from 0 in the order of the training; or with the
    /// first frames of a clip of the same body, which need not be a training clip: the model infers its latents
    /// from them and goes on.
    #[arg(long, value_name = "SEQUENCE|CLIP:FRAMES", default_value = "0", value_parser = parse::start)]
    from: Start,
    #[command(flatten)]
    up: Up,
    /// Start at this frame of the sequence, counted from 0. Models of earlier versions have the first frames
    /// only.
    #[arg(long, value_name = "FRAME", default_value_t = 0, value_parser = whole::<usize>(0..))]
    frame: usize,
    /// Change the coupling variance from part SOURCE to part TARGET: a large variance is a weak coupling.
    /// Parts by name or number, from 0.
    #[arg(long, value_name = "SOURCE:TARGET=VALUE", num_args = 1..)]
    alpha: Vec<String>,
    /// How the experts respond to changed couplings: they stay as learned, or they are inferred again from
    /// the same data.
    #[arg(long, default_value = "as-learned")]
    reading: ReadingOption,
    /// Cut a coupling from frame FROM to the frame before TO.
    #[arg(long, value_name = "SOURCE:TARGET@FROM-TO", num_args = 1.., conflicts_with_all = ["samples", "variance"])]
    cut: Vec<String>,
    /// Push a part before frame FRAME is predicted. AMOUNT is a number for each latent dimension of the part,
    /// separated by commas; or one number followed by f, which moves the part that many frames ahead (-3f:
    /// three frames back).
    #[arg(long, value_name = "PART@FRAME=AMOUNT", num_args = 1.., conflicts_with_all = ["samples", "variance"])]
    push: Vec<String>,
    /// Write N sampled rollouts too, numbered from 1: OUT-1.bvh and so on, and the same for --latents.
    #[arg(long, value_name = "N", value_parser = whole(1..=MOST_SAMPLES))]
    samples: Option<u32>,
    /// The seed of the first sampled rollout; the next ones count on from it.
    #[arg(long, value_name = "S", requires = "samples", default_value_t = 0, value_parser = whole(0..=u32::MAX))]
    seed: u32,
    /// Write means and variances of the latents in every frame, by moment matching, to this file.
    #[arg(long, value_name = "OUT.csv")]
    variance: Option<PathBuf>,
    /// Write the motion to this file. A model of tables has no motion, only columns.
    #[arg(long, value_name = "OUT.bvh", required_unless_present = "columns")]
    out: Option<PathBuf>,
    #[command(flatten)]
    names: Names,
    /// Write all predicted columns with a header row to this file: of a body, the rates of the root and the
    /// rotation vectors of the joints.
    #[arg(long, value_name = "OUT.csv")]
    columns: Option<PathBuf>,
    /// Write the latent path to this file, with a header row.
    #[arg(long, value_name = "OUT.csv")]
    latents: Option<PathBuf>,
}

/// The values of `--reading`.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum ReadingOption {
    AsLearned,
    ReInferred,
}

impl From<ReadingOption> for Reading {
    fn from(option: ReadingOption) -> Self {
        match option {
            ReadingOption::AsLearned => Reading::AsLearned,
            ReadingOption::ReInferred => Reading::ReInferred,
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    arguments.up.check(matches!(arguments.from, Start::Clip { .. }), "--from CLIP:FRAMES")?;
    let document = Document::from_json(&files::read_text(&arguments.model)?);
    let document = document.map_err(|error| files::with_path(&arguments.model, &error))?;
    let outs = [&arguments.out, &arguments.columns, &arguments.latents, &arguments.variance];
    let outs = outs.into_iter().flatten();
    if arguments.samples.is_some() && outs.clone().any(|out| files::is_standard(out)) {
        return Err(usage("--samples: expected files to be numbered, found stdout"));
    }
    let mut read = vec![arguments.model.as_path()];
    if let Start::Clip { clip, .. } = &arguments.from {
        if arguments.frame > 0 {
            return Err(usage("--frame: expected --from SEQUENCE, found --from CLIP:FRAMES"));
        }
        read.push(clip);
    }
    files::check_outs(arguments.outs(), read)?;
    match document {
        Document::Body(model) => {
            let motion = |body: &Body, y: &DMatrix<f64>, out: &Path| -> Result<(), Box<dyn Error>> {
                let clip = body.clip(y, &files::name_of(out))?;
                files::write_text(out, &arguments.names.bvh(clip))
            };
            let start = match (&arguments.from, model.coupled()) {
                (Start::Clip { clip, frames }, Some(model)) => {
                    let clip = clips::read_for(clip, &arguments.up, &model.body.mapping)?;
                    Some(model.latents_of_clip(&clip, *frames)?)
                }
                _ => None,
            };
            let rolled_out = roll_out(arguments, &model, start, &motion)?;
            match (model.coupled(), rolled_out) {
                (Some(model), Some((request, rollout))) => {
                    summary::print(model, &request, &rollout, arguments.out.as_deref())
                }
                _ => Ok(()),
            }
        }
        Document::Series(model) => {
            if arguments.out.is_some() {
                return Err(usage("--out: expected --columns for a model of tables, which has no motion"));
            }
            if matches!(arguments.from, Start::Clip { .. }) {
                return Err(usage(
                    "--from: expected a training sequence for a model of tables, found a clip",
                ));
            }
            roll_out(arguments, &model, None, &|_, _, _| Ok(())).map(|_| ())
        }
    }
}

/// Writes columns [frames x D] as the motion of a body to a file.
type WriteMotion<'a, S> = &'a dyn Fn(&Body<S>, &DMatrix<f64>, &Path) -> Result<(), Box<dyn Error>>;

/// Writes what the options ask for. Returns the rollout of a model with couplings, and its request.
fn roll_out<S: ColumnMapping + Clone>(
    arguments: &Arguments,
    model: &Model<S>,
    start: Option<Vec<DMatrix<f64>>>,
    motion: WriteMotion<S>,
) -> Result<Option<(RolloutRequest, Rollout)>, Box<dyn Error>> {
    match model.coupled() {
        Some(model) => roll_out_coupled(arguments, model, start, motion).map(Some),
        None => {
            let changed = arguments.with_alpha(model)?;
            if let Some(option) = arguments.coupling_option(changed.is_some()) {
                let kind = model.kind().id();
                return Err(usage(format!(
                    "{option}: expected a vcgpdm or vgpdm model, found a {kind} model"
                )));
            }
            let y = changed.as_ref().unwrap_or(model).rollout(arguments.sequence(), arguments.frames)?;
            arguments.write(&model.body, &y, None, motion)?;
            Ok(None)
        }
    }
}

impl Arguments {
    /// The training sequence that the rollout starts as; 0 with a clip.
    fn sequence(&self) -> usize {
        match self.from {
            Start::Sequence(sequence) => sequence,
            Start::Clip { .. } => 0,
        }
    }

    /// A MAP CGPDM with the couplings of `--alpha`; `None` for all others.
    fn with_alpha<S: ColumnMapping + Clone>(
        &self,
        model: &Model<S>,
    ) -> Result<Option<Model<S>>, Box<dyn Error>> {
        match &model.fitted {
            FittedModel::Map(map) if !self.alpha.is_empty() && model.kind() == ModelKind::MapCgpdm => {
                Ok(model.with_alpha(self.couplings(map.alpha(), &model.body)?).transpose()?)
            }
            _ => Ok(None),
        }
    }

    /// The couplings of `--alpha`, the others as learned.
    fn couplings<S: ColumnMapping>(
        &self,
        learned: &DMatrix<f64>,
        body: &Body<S>,
    ) -> Result<DMatrix<f64>, Usage> {
        let (mut alpha, parts) = (learned.clone(), part_names(body));
        for coupling in &self.alpha {
            let (source, target, value) = parse::coupling(coupling, &parts).map_err(Usage)?;
            alpha[(source, target)] = value;
        }
        Ok(alpha)
    }

    /// The first option on the command line that only models with couplings have. A model that `takes_alpha` has
    /// `--alpha` too.
    fn coupling_option(&self, takes_alpha: bool) -> Option<&'static str> {
        let options = [
            ("--from", matches!(self.from, Start::Clip { .. })),
            ("--frame", self.frame > 0),
            ("--alpha", !takes_alpha && !self.alpha.is_empty()),
            ("--latents", self.latents.is_some()),
            ("--reading", self.reading != ReadingOption::AsLearned),
            ("--cut", !self.cut.is_empty()),
            ("--push", !self.push.is_empty()),
            ("--samples", self.samples.is_some()),
            ("--variance", self.variance.is_some()),
        ];
        first_given(options)
    }

    /// All output files, with those of the samples, each with its option.
    fn outs(&self) -> impl Iterator<Item = (&'static str, PathBuf)> {
        let samples = 1..=self.samples.unwrap_or(0) as usize;
        let each = [("--out", &self.out), ("--columns", &self.columns), ("--latents", &self.latents)];
        let each = each.into_iter().filter_map(|(option, out)| Some((option, out.as_ref()?)));
        let each = each.flat_map(move |(option, out)| {
            once(None).chain(samples.clone().map(Some)).map(move |number| (option, numbered(out, number)))
        });
        each.chain(self.variance.clone().map(|out| ("--variance", out)))
    }

    /// Writes a rollout as a motion and as columns, if the options ask for them.
    fn write<S: ColumnMapping>(
        &self,
        body: &Body<S>,
        y: &DMatrix<f64>,
        number: Option<usize>,
        motion: WriteMotion<S>,
    ) -> Result<(), Box<dyn Error>> {
        if let Some(out) = &self.out {
            motion(body, y, &numbered(out, number))?;
        }
        if let Some(path) = &self.columns {
            let names: Vec<String> = (0..y.ncols()).map(|column| body.mapping.column_name(column)).collect();
            files::write_text(&numbered(path, number), &series::write(&names, y, body.frame_time))?;
        }
        Ok(())
    }

    fn request<S: ColumnMapping>(
        &self,
        model: Coupled<S>,
        start: Option<Vec<DMatrix<f64>>>,
    ) -> Result<RolloutRequest, Usage> {
        let parts = &part_names(model.body);
        let alpha = self.couplings(&model.model.alpha, model.body)?;
        Ok(RolloutRequest {
            frames: self.frames,
            sequence: self.sequence(),
            frame: self.frame,
            start,
            alpha: Some(alpha),
            reading: self.reading.into(),
            handles: Handles::default(),
            cuts: self
                .cut
                .iter()
                .map(|cut| parse::cut(cut, parts))
                .collect::<Result<_, _>>()
                .map_err(Usage)?,
            pushes: self
                .push
                .iter()
                .map(|push| parse::push(push, parts))
                .collect::<Result<_, _>>()
                .map_err(Usage)?,
        })
    }
}

/// The names of the parts of a body.
pub fn part_names<S>(body: &Body<S>) -> Vec<String> {
    body.layout.parts().iter().map(|part| part.name.clone()).collect()
}

/// Rolls out a model with couplings, and writes its latents too.
fn roll_out_coupled<S: ColumnMapping>(
    arguments: &Arguments,
    model: Coupled<S>,
    start: Option<Vec<DMatrix<f64>>>,
    motion: WriteMotion<S>,
) -> Result<(RolloutRequest, Rollout), Box<dyn Error>> {
    let parts = part_names(model.body);
    let request = arguments.request(model, start)?;
    let rollout = model.rollout(&request)?;
    let write = |rollout: &Rollout, number: Option<usize>| -> Result<(), Box<dyn Error>> {
        arguments.write(model.body, &rollout.y, number, motion)?;
        if let Some(path) = &arguments.latents {
            let text = latents::csv(&parts, &rollout.latents, model.body.frame_time);
            files::write_text(&numbered(path, number), &text)?;
        }
        Ok(())
    };
    write(&rollout, None)?;
    if let Some(count) = arguments.samples {
        let seed = u64::from(arguments.seed);
        let seeds = seed..seed + u64::from(count);
        for (k, rollout) in model.sampled_rollouts(&request, seeds)?.enumerate() {
            write(&rollout?, Some(k + 1))?;
        }
    }
    if let Some(path) = &arguments.variance {
        let moments = model.moments(&request)?;
        files::write_text(path, &latents::moments_csv(&parts, &moments, model.body.frame_time))?;
    }
    Ok((request, rollout))
}

/// `walk-3.bvh` for `walk.bvh` and 3.
fn numbered(path: &Path, number: Option<usize>) -> PathBuf {
    let Some(number) = number else { return path.to_owned() };
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let extension = path.extension().map_or_else(String::new, |e| format!(".{}", e.to_string_lossy()));
    path.with_file_name(format!("{stem}-{number}{extension}"))
}

/// Reads a model document of any kind.
pub fn read_model(path: &Path) -> Result<Model, Box<dyn Error>> {
    Model::from_json(&files::read_text(path)?).map_err(|error| files::with_path(path, &error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_files_of_samples_before_the_extension() {
        let name = |path: &str| numbered(Path::new(path), Some(3)).to_string_lossy().into_owned();
        assert_eq!(name("out/walk.bvh"), "out/walk-3.bvh");
        assert_eq!(name("walk"), "walk-3");
    }
}
