//! Answers of participants: files that jsPsych writes, with our columns.

use crate::perception::csv::{CsvError, rows};
use crate::perception::study::Study;
use crate::perception::trials::{NaturalSide, TrialKind};
use std::collections::{HashMap, HashSet};
use thiserror::Error;
use vcgpdm_core::json::{Field, FieldError, JsonError, Value, parse};

/// Largest file; thousands of trials are smaller.
const MOST_BYTES: usize = 64 << 20;

/// A file of answers.
#[derive(Clone, Copy, Debug)]
pub struct AnswerFile<'a> {
    /// The name of the file.
    pub name: &'a str,
    /// Its text: CSV or JSON.
    pub text: &'a str,
}

/// One answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The participant.
    pub participant: String,
    /// The number of the trial in the file.
    pub trial_index: usize,
    /// The kind of trial.
    pub kind: TrialKind,
    /// The index of the stimulus on the left.
    pub left: usize,
    /// The index of the stimulus on the right.
    pub right: usize,
    /// Whether the participant chose the left movement; absent without an answer.
    pub chose_left: Option<bool>,
    /// From the start of the movements to the answer, in milliseconds; absent if unknown.
    pub rt: Option<f64>,
    /// Time between the starts of the two movements, in milliseconds; absent if unknown.
    pub started_apart_ms: Option<f64>,
    /// Duration of the movements, in milliseconds; absent if unknown.
    pub lasted_ms: Option<f64>,
}

/// Why answers cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{file}: {reason}")]
pub struct AnswersError {
    /// The file.
    pub file: String,
    /// The reason.
    pub reason: AnswersReason,
}

/// The reason why answers cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum AnswersReason {
    /// The file is too large.
    #[error("expected at most {} megabytes, found {found} bytes", MOST_BYTES >> 20)]
    Size {
        /// Bytes found.
        found: usize,
    },
    /// The text is not a table.
    #[error(transparent)]
    Csv(CsvError),
    /// The text is not JSON.
    #[error(transparent)]
    Json(JsonError),
    /// The JSON is not a list of answers.
    #[error(transparent)]
    Field(FieldError),
    /// A column is missing.
    #[error("expected a column \"{0}\", found none")]
    Column(&'static str),
    /// A value is impossible.
    #[error("{place}, {column}: expected {expected}, found {found:?}")]
    Value {
        /// The line or the answer.
        place: String,
        /// The column.
        column: &'static str,
        /// The expectation.
        expected: String,
        /// The value found.
        found: String,
    },
    /// A trial of a participant comes twice.
    #[error(
        "{place}: expected every trial of a participant once, found trial {trial} of {participant:?} twice"
    )]
    Twice {
        /// The line or the answer of the second.
        place: String,
        /// The trial's number.
        trial: usize,
        /// The participant.
        participant: String,
    },
    /// The file has no answer.
    #[error("expected answers to comparisons, found none")]
    Empty,
}

/// The answers of several files.
///
/// # Errors
/// A file is neither a table nor a list of answers, or its answers are of another study.
pub fn read(study: &Study, files: &[AnswerFile]) -> Result<Vec<Answer>, AnswersError> {
    let hash = study.hash().unwrap_or_default();
    let reader = Reader {
        study,
        hash,
        places: study.stimuli.iter().enumerate().map(|(k, stimulus)| (stimulus.id.as_str(), k)).collect(),
    };
    let mut answers: Vec<Answer> = Vec::new();
    let mut seen: HashSet<(String, usize)> = HashSet::new();
    for file in files {
        let about = |reason| AnswersError { file: file.name.to_owned(), reason };
        let found = reader.file(file).map_err(about)?;
        if found.is_empty() {
            return Err(about(AnswersReason::Empty));
        }
        for (place, answer) in found {
            let Answer { participant, trial_index: trial, .. } = &answer;
            if !seen.insert((participant.clone(), *trial)) {
                let (trial, participant) = (*trial, participant.clone());
                return Err(about(AnswersReason::Twice { place, trial, participant }));
            }
            answers.push(answer);
        }
    }
    Ok(answers)
}

struct Reader<'a> {
    study: &'a Study,
    hash: String,
    places: HashMap<&'a str, usize>,
}

/// The fields of one row of a table, or of one item of a list, by name.
struct Fields<'a> {
    place: String,
    get: &'a dyn Fn(&str) -> Option<String>,
}

impl Fields<'_> {
    /// The text of a field; absent if there is no such field, or if it is empty.
    fn text(&self, name: &str) -> Option<String> {
        (self.get)(name).map(|text| text.trim().to_owned()).filter(|text| !text.is_empty() && text != "null")
    }

    fn wrong(&self, column: &'static str, expected: &str, found: Option<String>) -> AnswersReason {
        let found = found.unwrap_or_default().chars().take(60).collect();
        AnswersReason::Value { place: self.place.clone(), column, expected: expected.to_owned(), found }
    }

    /// A number from 0; absent if the field is empty.
    fn number(&self, column: &'static str) -> Result<Option<f64>, AnswersReason> {
        let Some(text) = self.text(column) else { return Ok(None) };
        match text.parse::<f64>() {
            Ok(number) if (0.0..1e12).contains(&number) => Ok(Some(number)),
            _ => Err(self.wrong(column, "a number from 0", Some(text))),
        }
    }
}

impl Reader<'_> {
    fn file(&self, file: &AnswerFile) -> Result<Vec<(String, Answer)>, AnswersReason> {
        let AnswerFile { name, text } = file;
        if text.len() > MOST_BYTES {
            return Err(AnswersReason::Size { found: text.len() });
        }
        let begin = text.trim_start_matches('\u{feff}').trim_start();
        if begin.starts_with(['[', '{']) { self.json(name, text) } else { self.csv(name, text) }
    }

    fn csv(&self, name: &str, text: &str) -> Result<Vec<(String, Answer)>, AnswersReason> {
        let rows = rows(text).map_err(AnswersReason::Csv)?;
        let Some(((_, header), rows)) = rows.split_first() else { return Ok(Vec::new()) };
        for needed in ["kind", "left", "right", "response", "trial_index"] {
            if !header.iter().any(|field| field == needed) {
                return Err(AnswersReason::Column(needed));
            }
        }
        let mut answers = Vec::new();
        for (line, row) in rows {
            let get = |name: &str| {
                let column = header.iter().position(|field| field == name)?;
                row.get(column).map(|field| without_guard(field).to_owned())
            };
            let fields = Fields { place: format!("line {line}"), get: &get };
            answers.extend(self.answer(name, &fields)?.map(|answer| (fields.place, answer)));
        }
        Ok(answers)
    }

    /// A list of trials, as jsPsych writes it, or an object with such a list as its "answers".
    fn json(&self, name: &str, text: &str) -> Result<Vec<(String, Answer)>, AnswersReason> {
        let value = parse(text).map_err(AnswersReason::Json)?;
        let list = match &value {
            Value::Object(fields) => fields.iter().find(|(name, _)| name == "answers").map(|(_, list)| list),
            _ => None,
        };
        let items = Field::root(list.unwrap_or(&value)).items().map_err(AnswersReason::Field)?;
        let mut answers = Vec::new();
        for (k, item) in items.iter().enumerate() {
            let Value::Object(object) = item.value() else {
                return Err(AnswersReason::Field(item.wrong("an object")));
            };
            let get = |name: &str| {
                let value = object.iter().find(|(field, _)| field == name).map(|(_, value)| value)?;
                match value {
                    Value::Text(text) => Some(text.clone()),
                    Value::Number(number) => Some(number.to_string()),
                    Value::Bool(value) => Some(value.to_string()),
                    _ => None,
                }
            };
            let fields = Fields { place: format!("answer {}", k + 1), get: &get };
            answers.extend(self.answer(name, &fields)?.map(|answer| (fields.place, answer)));
        }
        Ok(answers)
    }

    /// The answer of a row; none for rows of instructions and pauses.
    fn answer(&self, file: &str, fields: &Fields) -> Result<Option<Answer>, AnswersReason> {
        let Some(kind) = fields.text("kind") else { return Ok(None) };
        let Some(kind) = TrialKind::from_id(&kind) else {
            return Err(fields.wrong("kind", "comparison, attention or catch", Some(kind)));
        };
        if let Some(found) = fields.text("study")
            && found != self.study.title
            && (found.len() < 8 || !self.hash.starts_with(&found))
        {
            let expected = format!("the study {}", self.hash.get(..12).unwrap_or_default());
            return Err(fields.wrong("study", &expected, Some(found)));
        }
        let (left, right) = (self.stimulus(fields, "left")?, self.stimulus(fields, "right")?);
        self.check_kind(fields, kind, left, right)?;
        let trial = fields.text("trial_index");
        let trial_index = trial.as_deref().and_then(|text| text.parse().ok());
        let Some(trial_index) = trial_index else {
            return Err(fields.wrong("trial_index", "a whole number from 0", trial));
        };
        let chose_left = match fields.text("response").as_deref() {
            None => None,
            Some("left") => Some(true),
            Some("right") => Some(false),
            Some(_) => {
                return Err(fields.wrong("response", "left, right or nothing", fields.text("response")));
            }
        };
        Ok(Some(Answer {
            participant: fields.text("participant").unwrap_or_else(|| file.to_owned()),
            trial_index,
            kind,
            left,
            right,
            chose_left,
            rt: fields.number("rt")?,
            started_apart_ms: fields.number("started_apart_ms")?,
            lasted_ms: fields.number("lasted_ms")?,
        }))
    }

    /// The index of a stimulus, from its id or its index in the study.
    fn stimulus(&self, fields: &Fields, column: &'static str) -> Result<usize, AnswersReason> {
        let text = fields.text(column);
        let by_id = text.as_deref().and_then(|id| self.places.get(id).copied());
        let by_index = || text.as_deref()?.parse().ok().filter(|index| *index < self.study.stimuli.len());
        by_id.or_else(by_index).ok_or_else(|| fields.wrong(column, "a movement of the study", text.clone()))
    }

    /// Checks that a trial of this kind can have these movements, and the side of the natural one.
    fn check_kind(
        &self,
        fields: &Fields,
        kind: TrialKind,
        left: usize,
        right: usize,
    ) -> Result<(), AnswersReason> {
        let natural = [left, right].map(|k| self.study.stimuli[k].natural());
        let side = match (kind, natural) {
            (TrialKind::Catch, [Some(a), Some(b)]) if a != b => NaturalSide::None,
            (TrialKind::Comparison | TrialKind::Attention, [Some(_), None]) => NaturalSide::Left,
            (TrialKind::Comparison | TrialKind::Attention, [None, Some(_)]) => NaturalSide::Right,
            _ => {
                let expected = match kind {
                    TrialKind::Catch => "two natural movements, of which one is unseen",
                    _ => "a natural and a generated movement",
                };
                let ids = [left, right].map(|k| self.study.stimuli[k].id.as_str()).join(" and ");
                return Err(fields.wrong("kind", expected, Some(ids)));
            }
        };
        match fields.text("natural_side") {
            Some(found) if found != side.id() => Err(fields.wrong("natural_side", side.id(), Some(found))),
            _ => Ok(()),
        }
    }
}

/// The text without the apostrophe that the page puts before text that a spreadsheet would compute.
fn without_guard(field: &str) -> &str {
    match field.strip_prefix('\'') {
        Some(text) if text.starts_with(['=', '+', '-', '@', '\t', '\r']) => text,
        _ => field,
    }
}

vcgpdm_core::coded!(AnswersError => Study);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::perception::testing::{answers, study};

    fn read_text(text: &str) -> Result<Vec<Answer>, AnswersError> {
        read(&study(), &[AnswerFile { name: "a.csv", text }])
    }

    fn csv() -> String {
        answers(&study(), "p1", 4, true, &|_| 0.4)
    }

    /// The error after the first `from` in the CSV is replaced.
    fn refused(from: &str, to: &str) -> String {
        let text = csv();
        assert!(text.contains(from), "{from}");
        read_text(&text.replacen(from, to, 1)).unwrap_err().to_string()
    }

    #[test]
    fn reads_files_of_jspsych() {
        let found = read_text(&csv()).unwrap();
        assert_eq!(found.len(), 60);
        let trials = study().trials(4);
        for (answer, trial) in found.iter().zip(&trials) {
            assert_eq!((answer.kind, answer.left, answer.right), (trial.kind, trial.left, trial.right));
            assert_eq!((answer.participant.as_str(), answer.rt), ("p1", Some(4100.5)));
            assert!(answer.chose_left.is_some());
        }
        // The same as JSON, as a list and as a document, with indices instead of ids.
        let rows: Vec<serde_json::Value> = found
            .iter()
            .map(|a| {
                let response = if a.chose_left == Some(true) { "left" } else { "right" };
                serde_json::json!({
                    "kind": a.kind.id(), "left": a.left, "right": a.right, "response": response, "rt": a.rt,
                    "trial_index": a.trial_index, "participant": "p1", "started_apart_ms": 0.3, "lasted_ms": 1200,
                    "stimulus": null, "extra": {"more": [1]},
                })
            })
            .collect();
        let list = serde_json::Value::from(rows.clone()).to_string();
        assert_eq!(read_text(&list).unwrap(), found);
        let document = serde_json::json!({"format": "anything", "answers": rows}).to_string();
        assert_eq!(read_text(&document).unwrap(), found);
    }

    /// The page guards text that a spreadsheet would compute with an apostrophe.
    #[test]
    fn reads_names_that_are_guarded_against_spreadsheets() {
        let participant = |name: &str| {
            let text = csv().replace("\"p1\"", &format!("\"{name}\""));
            read_text(&text).unwrap()[0].participant.clone()
        };
        assert_eq!(participant("'=1+1"), "=1+1");
        assert_eq!(participant("'t Hooft"), "'t Hooft");
    }

    #[test]
    fn reads_trials_without_an_answer() {
        let text = csv();
        let (header, rows) = text.split_once("\r\n").unwrap();
        let rows = rows.replace("\"left\"", "\"null\"").replace("\"right\"", "\"\"");
        let text = format!("{header}\r\n{rows}");
        let text = text.replace("\"natural_side\"", "\"side\"");
        let found = read_text(&text).unwrap();
        assert!(found.len() == 60 && found.iter().all(|answer| answer.chose_left.is_none()));
    }

    #[test]
    fn names_the_line_of_an_error() {
        let title = study().title;
        let hash = study().hash().unwrap();
        assert!(read_text(&csv().replace(&hash, &title)).is_ok());
        assert!(read_text(&csv().replace(&hash, &hash[..16])).is_ok());
        let other = refused(&hash, "another");
        let expected = format!("a.csv: line 3, study: expected the study {}, found \"another\"", &hash[..12]);
        assert_eq!(other, expected);
        assert_eq!(refused("\"kind\"", "\"sort\""), "a.csv: expected a column \"kind\", found none");
        let kind = refused("\"comparison\"", "\"test\"");
        assert!(kind.contains("kind: expected comparison, attention or catch, found \"test\""), "{kind}");
        let kind = refused("\"comparison\"", "\"catch\"");
        assert!(
            kind.contains("kind: expected two natural movements, of which one is unseen, found \""),
            "{kind}"
        );
        let index = refused("\"side-by-side\",\"1\"", "\"side-by-side\",\"x\"");
        assert_eq!(index, "a.csv: line 3, trial_index: expected a whole number from 0, found \"x\"");
        let twice = refused("\"side-by-side\",\"2\"", "\"side-by-side\",\"1\"");
        let expected =
            "a.csv: line 4: expected every trial of a participant once, found trial 1 of \"p1\" twice";
        assert_eq!(twice, expected);
        let rt = refused("\"4100.5\"", "\"soon\"");
        assert_eq!(rt, "a.csv: line 3, rt: expected a number from 0, found \"soon\"");
        let movement = refused("\"natural-1\"", "\"natural-9\"");
        assert!(movement.contains(": expected a movement of the study, found \"natural-9\""), "{movement}");
        let side =
            if csv().contains("\"left\",\"left\"") { "\"left\",\"left\"" } else { "\"right\",\"left\"" };
        let side = refused(side, &side.replacen("left", "none", 1).replacen("right", "none", 1));
        assert!(side.contains("natural_side: expected ") && side.ends_with("found \"none\""), "{side}");
        assert!(refused("\"0.3\"", "\"0.3").contains("line 3: expected 14 fields"));
        let error = read_text("{\"answers\": 3}").unwrap_err().to_string();
        assert_eq!(error, "a.csv: at the top of the document: expected a list, found 3");
        assert!(read_text("[1]").unwrap_err().to_string().contains("at [0]: expected an object, found 1"));
        assert!(read_text("[}").unwrap_err().to_string().starts_with("a.csv: line 1, column 2"));
        assert_eq!(
            read_text("").unwrap_err().to_string(),
            "a.csv: expected answers to comparisons, found none"
        );
    }
}
