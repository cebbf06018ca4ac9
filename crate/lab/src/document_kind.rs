//! Which of the project's documents a JSON text is.

use crate::evaluation::Results;
use crate::perception::Study;
use serde::Serialize;
use vcgpdm_core::json::{Value, outline};

/// A kind of JSON document: a model of a body or of tables, a library of primitives, results of a comparison,
/// a study, a list (as the answers to a study are), or anything else.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum DocumentKind {
    /// A model of a body.
    Model,
    /// A model of tables.
    SeriesModel,
    /// A library of primitives.
    Library,
    /// The results of a comparison.
    Results,
    /// A study for the graphics Turing test.
    Study,
    /// A list, as the answers to a study are.
    List,
    /// Anything else, and a text that is not JSON.
    Unknown,
}

impl DocumentKind {
    /// Reads only the names and texts of the outermost fields, in any order. A document that is damaged
    /// further inside has a kind too.
    pub fn from_json(text: &str) -> Self {
        if text.trim_start_matches(['\u{feff}', ' ', '\t', '\r', '\n']).starts_with('[') {
            return Self::List;
        }
        let fields = outline(text).unwrap_or_default();
        let field = |name: &str| fields.iter().find(|(found, _)| found == name).map(|(_, value)| value);
        let text = |name: &str| match field(name) {
            Some(Value::Text(text)) => text.as_str(),
            _ => "",
        };
        match text("format") {
            Study::FORMAT => Self::Study,
            Results::FORMAT => Self::Results,
            vcgpdm_core::document::FORMAT if text("kind") == vcgpdm_core::document::LIBRARY => Self::Library,
            vcgpdm_core::document::FORMAT if field("columns").is_some() => Self::SeriesModel,
            vcgpdm_core::document::FORMAT => Self::Model,
            _ => Self::Unknown,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::DocumentKind::{self, *};

    #[test]
    fn finds_the_kind_whatever_the_order_of_the_keys() {
        for (file, kind) in [
            ("crate/vcgpdm/tests/library/documents/vcgpdm.json", Model),
            ("crate/vcgpdm/tests/library/documents/tmp.json", Model),
            ("crate/vcgpdm/tests/library/documents/series.json", SeriesModel),
            ("crate/vcgpdm/tests/library/documents/library.json", Library),
            ("crate/vcgpdm/tests/library/documents/primitives.json", Library),
            ("www/public/comparison/walks.results.json", Results),
            ("www/public/study/walks.study.json", Study),
            ("docs/model.schema.json", Unknown),
        ] {
            let path = format!("{}/../../{file}", env!("CARGO_MANIFEST_DIR"));
            let text = std::fs::read_to_string(path).unwrap();
            let value: serde_json::Value = serde_json::from_str(&text).unwrap();
            // A map of serde_json sorts its keys.
            let sorted = serde_json::to_string_pretty(&value).unwrap();
            assert_eq!([&text, &sorted].map(|text| DocumentKind::from_json(text)), [kind; 2], "{file}");
        }
    }

    #[test]
    fn calls_other_texts_lists_or_unknown() {
        for (text, kind) in [
            ("\u{feff}\n [{\"trial_type\": 1}]", List),
            ("", Unknown),
            ("HIERARCHY", Unknown),
            ("{\"format\": \"vcgpdm study\"", Unknown),
            ("{\"inner\": {\"format\": \"vcgpdm study\"}}", Unknown),
            ("{\"format\": 3, \"kind\": \"library\"}", Unknown),
        ] {
            assert_eq!(DocumentKind::from_json(text), kind, "{text}");
        }
    }
}
