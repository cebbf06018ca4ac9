//! The TypeScript declarations of the package: those of the structs that its functions give and take. A struct
//! that no other struct here names needs a line in `declarations`.

use crate::data::body::BodyInfo;
use crate::data::clip::BvhOptions;
use crate::data::clip::{ClipInfo, ClipState};
use crate::data::tables::{TableInfo, TablePart};
use crate::lab::evaluation::{ComparisonSettings, EvaluationProgress, FoldOptions};
use crate::lab::perception::AnswersFile;
use crate::lab::results::IdentifiedJob;
use crate::lab::study::MadeMovement;
use crate::lab::study::StudyInfo;
use crate::lab::synthetic::{SyntheticFindings, SyntheticTruth};
use crate::library::LibraryInfo;
use crate::library::recognition::Segment;
use crate::library::trainers::Planned;
use crate::library::walk::WalkStart;
use crate::models::completion::{Options, PartScores};
use crate::models::model::{ModelInfo, NoBody, PartInfo};
use crate::models::plane::PlanePicture;
use crate::models::rollout::Parts;
use crate::models::settings::{Part, Task};
use std::collections::BTreeMap;
use ts_rs::{Config, TS, TypeVisitor};
use vcgpdm_core::models::library::PartMotion;
use vcgpdm_core::models::variational::LatentField;
use vcgpdm_core::models::{
    Health, LatentLogDensity, Progress, RolloutRequest, Settings, TrainingCost, VariationalSettings,
};
use vcgpdm_core::motion::measures::Measures;
use vcgpdm_core::motion::samples::SampleInfo;
use vcgpdm_lab::DocumentKind;
use vcgpdm_lab::evaluation::{Comparison, Finished, Outcome, Plan, PlannedJob, Rival, Setting};
use vcgpdm_lab::perception::{FigureTable, PerceptionResults, Preset, StudyTrial};

/// All declarations, in the order of their names.
pub fn declarations() -> String {
    let mut all = Declarations::default();
    all.visit::<AnswersFile>();
    all.visit::<BvhOptions>();
    all.visit::<ClipState>();
    all.visit::<Comparison>();
    all.visit::<ComparisonSettings>();
    all.visit::<DocumentKind>();
    all.visit::<EvaluationProgress>();
    all.visit::<LatentField>();
    all.visit::<FigureTable>();
    all.visit::<FoldOptions>();
    all.visit::<Health>();
    all.visit::<MadeMovement>();
    all.visit::<Options>();
    all.visit::<Outcome>();
    all.visit::<Part>();
    all.visit::<PartInfo>();
    all.visit::<PartMotion>();
    all.visit::<PartScores>();
    all.visit::<PerceptionResults>();
    all.visit::<Plan>();
    all.visit::<PlanePicture>();
    all.visit::<Planned>();
    all.visit::<LatentLogDensity>();
    all.visit::<Preset>();
    all.visit::<Rival>();
    all.visit::<RolloutRequest>();
    all.visit::<SampleInfo>();
    all.visit::<Segment>();
    all.visit::<Setting>();
    all.visit::<Settings>();
    all.visit::<StudyInfo>();
    all.visit::<StudyTrial>();
    all.visit::<SyntheticFindings>();
    all.visit::<SyntheticTruth>();
    all.visit::<TableInfo>();
    all.visit::<TablePart>();
    all.visit::<TrainingCost>();
    all.visit::<Progress>();
    all.visit::<VariationalSettings>();
    all.visit::<WalkStart>();
    all.joined::<ClipInfo, BodyInfo>();
    all.joined::<Finished, IdentifiedJob>();
    all.joined::<LibraryInfo, BodyInfo>();
    all.joined::<Measures, Parts>();
    all.joined::<ModelInfo, NoBody>();
    all.joined::<PlannedJob, IdentifiedJob>();
    all.joined::<Task, VariationalSettings>();
    all.texts.into_values().collect()
}

/// The text of each type, by its name.
#[derive(Default)]
struct Declarations {
    texts: BTreeMap<String, String>,
    config: Config,
}

impl Declarations {
    /// One type with the fields of both structs, as of `to_js_joined`. It has the name of the first.
    fn joined<A: TS + 'static, B: TS + 'static>(&mut self) {
        let both = format!("{} & {}", A::inline(&self.config), B::inline(&self.config));
        self.declare::<A>(&both.replace(" } & { ", " "));
        B::visit_dependencies(self);
    }

    fn declare<T: TS + 'static + ?Sized>(&mut self, text: &str) {
        let name = T::ident(&self.config);
        // The first paragraph is for all readers, the others are for those of the Rust code.
        let docs = T::docs().unwrap_or_default();
        let docs = docs.split_once("\n *\n").map_or(docs.clone(), |(first, _)| format!("{first}\n */\n"));
        let text = format!("{docs}export type {name} = {text};\n").replace("[`", "`").replace("`]", "`");
        let text = text.replace("`None`", "null");
        self.texts.insert(name, text);
        T::visit_dependencies(self);
    }
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        // Numbers, texts and lists have no declaration.
        if T::output_path().is_some() && !self.texts.contains_key(&T::ident(&self.config)) {
            self.declare::<T>(&T::inline(&self.config));
        }
    }
}
