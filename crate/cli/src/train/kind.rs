//! The kind of model that `vcgpdm train` makes, and the options that only some kinds have.

use crate::numbers::whole;
use crate::usage::usage;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command, FromArgMatches};
use std::error::Error;
use std::path::PathBuf;
use vcgpdm_core::models::{
    BALANCED, DmpSettings, MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, MOST_PRIMITIVES, MapSettings,
    ModelKind, POSE_WEIGHTS, POSE_WEIGHTS_TEXT, PoseWeight, Settings, TmpSettings, VariationalSettings,
};

/// The options that only some kinds have. Other kinds ignore their defaults.
#[derive(clap::Args)]
pub struct Options {
    // This comes first, because clap removes an option when it reads it.
    #[command(flatten)]
    given: Given,
    /// The seed of everything random (GPDMs).
    #[arg(long, value_name = "S", default_value_t = 0, value_parser = whole(0..=u32::MAX))]
    pub seed: u32,
    /// Latent dimensions of every part (GPDMs).
    #[arg(long, value_name = "Q", default_value_t = VariationalSettings::default().latent, value_parser = whole(1..=MOST_DIMENSIONS))]
    latent: usize,
    /// Inducing points of every dynamics map (vcgpdm, vgpdm). Absent: 12, or 30 if a clip of the body has 8
    /// seconds or more (a library: 12).
    #[arg(long, value_name = "K", value_parser = whole(1..=MOST_INDUCING))]
    dynamics_ips: Option<usize>,
    /// Inducing points of every pose map (vcgpdm, vgpdm). Absent: as for the dynamics.
    #[arg(long, value_name = "L", value_parser = whole(1..=MOST_INDUCING))]
    pose_ips: Option<usize>,
    /// Frames of history that the dynamics see (GPDMs).
    #[arg(long, value_name = "P", default_value_t = VariationalSettings::default().order, value_parser = whole(1..=MOST_DIMENSIONS))]
    order: usize,
    /// Most iterations of the optimiser (GPDMs).
    #[arg(long, value_name = "N", default_value_t = VariationalSettings::default().max_iterations, value_parser = whole::<usize>(0..))]
    max_iterations: usize,
    /// Give dynamics and poses the same weight: balance latent dimensions against the many columns (GPDMs).
    #[arg(long)]
    balanced: bool,
    /// Multiply the pose terms of the objective by this number, or balance them (vcgpdm, vgpdm). With 1 the
    /// objective is the bound on the log evidence. Absent: balanced for one body, 1 for tables and libraries.
    #[arg(long, value_name = "W|balanced", conflicts_with = "balanced", value_parser = pose_weight)]
    pose_weight: Option<PoseWeight>,
    /// Train as in the papers, with `--pose-weight 1 --no-own-rollouts` (vcgpdm, vgpdm, libraries).
    #[arg(long, conflicts_with_all = ["balanced", "pose_weight", "no_own_rollouts"])]
    as_in_papers: bool,
    /// Keep the couplings between parts off: each part learns as if it were alone (vcgpdm).
    #[arg(long)]
    uncoupled: bool,
    /// Leave the dynamics as the bound has them: they do not learn from rollouts of the trained model (vcgpdm,
    /// vgpdm of a body, libraries).
    #[arg(long, conflicts_with = "columns")]
    pub no_own_rollouts: bool,
    /// A linear term in the kernels of the dynamics (map-gpdm, map-cgpdm).
    #[arg(long)]
    linear: bool,
    /// Primitives over normalised time, with weights that all trials share, nearer to the papers (tmp); absent:
    /// over learned phases.
    #[arg(long)]
    normalised_time: bool,
    /// Number of primitives (tmp); absent: chosen by the bound.
    #[arg(long, value_name = "N", value_parser = whole(1..=MOST_PRIMITIVES))]
    primitives: Option<usize>,
    /// Basis functions of every column (dmp-discrete, dmp-rhythmic).
    #[arg(long, value_name = "B", default_value_t = DmpSettings::default().bases, value_parser = whole(1..=MOST_BASES))]
    bases: usize,
    /// Threads that compute the bound (vcgpdm, vgpdm): at most two for each part have work. The model is the
    /// same, but the training takes more memory.
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = whole(1..=u16::MAX))]
    pub threads: u16,
    /// Write the starting point as the input of a case, from which another implementation can start (vcgpdm,
    /// vgpdm).
    #[arg(long, value_name = "CASE.json")]
    pub write_start: Option<PathBuf>,
}

const VARIATIONAL: &[ModelKind] = &[ModelKind::Vcgpdm, ModelKind::Vgpdm];
const POINT: &[ModelKind] = &[ModelKind::MapGpdm, ModelKind::MapCgpdm];
const GPDMS: &[ModelKind] = &[ModelKind::Vcgpdm, ModelKind::Vgpdm, ModelKind::MapGpdm, ModelKind::MapCgpdm];
const TMP: &[ModelKind] = &[ModelKind::Tmp];
const DMPS: &[ModelKind] = &[ModelKind::DmpDiscrete, ModelKind::DmpRhythmic];

/// The kinds that have an option.
const KINDS: [(&str, &[ModelKind]); 17] = [
    ("seed", GPDMS),
    ("latent", GPDMS),
    ("dynamics_ips", VARIATIONAL),
    ("pose_ips", VARIATIONAL),
    ("order", GPDMS),
    ("max_iterations", GPDMS),
    ("threads", VARIATIONAL),
    ("balanced", GPDMS),
    ("pose_weight", VARIATIONAL),
    ("as_in_papers", VARIATIONAL),
    ("uncoupled", &[ModelKind::Vcgpdm]),
    ("no_own_rollouts", VARIATIONAL),
    ("linear", POINT),
    ("primitives", TMP),
    ("normalised_time", TMP),
    ("bases", DMPS),
    ("write_start", VARIATIONAL),
];

impl Options {
    /// The settings of a model of this kind. Inducing points and the weight of the pose terms are as in `usual`
    /// if none are given. An option that the kind does not have is refused.
    pub fn settings(&self, kind: ModelKind, usual: &VariationalSettings) -> Result<Settings, Box<dyn Error>> {
        let misplaced = KINDS.iter().find(|(id, kinds)| self.given.has(id) && !kinds.contains(&kind));
        if let Some((id, kinds)) = misplaced {
            let kinds: Vec<&str> = kinds.iter().map(|kind| kind.id()).collect();
            let option = id.replace('_', "-");
            return Err(usage(format!(
                "--{option}: expected a model that has it ({}), found {}",
                kinds.join(", "),
                kind.id()
            )));
        }
        let &Options { latent, order, max_iterations, balanced, uncoupled, linear, bases, .. } = self;
        let pose_weight = weight(balanced, self.pose_weight, usual.pose_weight);
        let variational = VariationalSettings {
            latent,
            order,
            dynamics_ips: self.dynamics_ips.unwrap_or(usual.dynamics_ips),
            pose_ips: self.pose_ips.unwrap_or(usual.pose_ips),
            max_iterations,
            pose_weight,
            uncoupled,
            own_rollouts: usual.own_rollouts && !self.no_own_rollouts,
        };
        let variational = if self.as_in_papers { variational.as_in_papers() } else { variational };
        let point = MapSettings { latent, order, max_iterations, balanced, linear };
        Ok(match kind {
            ModelKind::Vcgpdm => Settings::Vcgpdm(variational),
            ModelKind::Vgpdm => Settings::Vgpdm(variational),
            ModelKind::MapGpdm => Settings::MapGpdm(point),
            ModelKind::MapCgpdm => Settings::MapCgpdm(point),
            ModelKind::Tmp => {
                let (primitives, normalised_time) = (self.primitives, self.normalised_time);
                Settings::Tmp(TmpSettings { primitives, normalised_time })
            }
            ModelKind::DmpDiscrete => Settings::DmpDiscrete(DmpSettings { bases }),
            ModelKind::DmpRhythmic => Settings::DmpRhythmic(DmpSettings { bases }),
        })
    }
}

/// The weight of the pose terms of `--balanced` and `--pose-weight`, or the usual one.
pub fn weight(balanced: bool, pose_weight: Option<PoseWeight>, usual: PoseWeight) -> PoseWeight {
    if balanced { PoseWeight::Balanced } else { pose_weight.unwrap_or(usual) }
}

/// The name of the objective that a training with these settings maximises.
pub fn objective(settings: &Settings) -> &'static str {
    match settings {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) if !s.pose_weight.is_plain() => "weighted objective",
        Settings::Vcgpdm(_) | Settings::Vgpdm(_) | Settings::Tmp(_) => "bound",
        Settings::MapGpdm(_) | Settings::MapCgpdm(_) => "log density",
        Settings::DmpDiscrete(_) | Settings::DmpRhythmic(_) => "minus the mean squared error",
    }
}

/// Reads the value of `--pose-weight`.
pub fn pose_weight(text: &str) -> Result<PoseWeight, String> {
    if text == BALANCED {
        return Ok(PoseWeight::Balanced);
    }
    let number = text.parse().ok().filter(|number| POSE_WEIGHTS.contains(number));
    number.map(PoseWeight::Fixed).ok_or_else(|| format!("expected {POSE_WEIGHTS_TEXT}, or {BALANCED}"))
}

/// Reads the value of `--model`.
pub fn parse(id: &str) -> Result<ModelKind, String> {
    ModelKind::from_id(id).ok_or_else(|| {
        let ids: Vec<&str> = ModelKind::ALL.iter().map(|kind| kind.id()).collect();
        format!("expected one of {}", ids.join(", "))
    })
}

/// The kind of `--model`; without it, the variational kind for this number of parts. A kind that cannot have
/// this number of parts is refused. `split` is the value of `--parts`.
pub fn check_parts(kind: Option<ModelKind>, parts: usize, split: &str) -> Result<ModelKind, Box<dyn Error>> {
    let Some(kind) = kind else {
        return Ok(if parts == 1 { ModelKind::Vgpdm } else { ModelKind::Vcgpdm });
    };
    let wrong = match kind {
        ModelKind::Vcgpdm if parts == 1 => ("two parts or more", "with one part choose vgpdm"),
        ModelKind::MapCgpdm if parts == 1 => ("two parts or more", "with one part choose map-gpdm"),
        ModelKind::Vgpdm if parts > 1 => ("one part (whole)", "with several parts choose vcgpdm"),
        ModelKind::MapGpdm if parts > 1 => ("one part (whole)", "with several parts choose map-cgpdm"),
        _ => return Ok(kind),
    };
    let ((expected, other), kind) = (wrong, kind.id());
    Err(usage(format!("--parts {split}: expected {expected} for a {kind} model, found {parts}; {other}")))
}

/// The options on the command line; all others have their defaults.
struct Given(Vec<String>);

impl Given {
    fn has(&self, id: &str) -> bool {
        self.0.iter().any(|given| given == id)
    }
}

impl clap::Args for Given {
    fn augment_args(command: Command) -> Command {
        command
    }

    fn augment_args_for_update(command: Command) -> Command {
        command
    }
}

impl FromArgMatches for Given {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let ids = matches.ids().map(clap::Id::as_str);
        let given = ids.filter(|id| matches.value_source(id) == Some(ValueSource::CommandLine));
        Ok(Given(given.map(str::to_owned).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
