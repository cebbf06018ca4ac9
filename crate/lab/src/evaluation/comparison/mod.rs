//! The tables of a comparison: models, correlations of bound and error, growth of the time, claims.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::claims::{secondary_claims, three_part_claims};
use crate::evaluation::correlation::{correlations, evidence, growth};
use crate::evaluation::effect::{Choice, Contender};
use crate::evaluation::labels::Labels;
use crate::evaluation::primary::primary_claims;
use crate::evaluation::results::Results;
use crate::evaluation::rows::{Row, groups, rows};
use crate::evaluation::summary::{Claim, Correlation, Evidence, Growth, ModelSummary};
use serde::Serialize;
use std::ops::Range;

/// Tables and claims computed from the results of a comparison.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Comparison {
    /// Names of the parts in `partErrors` of the models.
    pub parts: Vec<String>,
    /// Every candidate that was trained on all other trials.
    pub models: Vec<ModelSummary>,
    /// One entry for each kind of model with a bound and at least three candidates that differ only in size.
    pub correlations: Vec<Correlation>,
    /// One entry for each kind of model that was trained on at least three different numbers of trials.
    pub growth: Vec<Growth>,
    /// One entry for each fold with results of both variational models.
    pub evidence: Vec<Evidence>,
    /// The claims that these results can test.
    pub claims: Vec<Claim>,
}

impl Comparison {
    /// The tables of these results.
    pub fn new(results: &Results) -> Self {
        Self::of_several(&[results])
    }

    /// The tables of several comparisons together, each with its own trials. Errors are compared trial by
    /// trial, so that errors of different people and movements are never mixed.
    pub fn of_several(several: &[&Results]) -> Self {
        let (rows, labels) = (rows(several), Labels::of_several(several));
        let growth = growth(several, &labels);
        let trials = several.iter().flat_map(|results| &results.setting().trials);
        let names: Vec<&str> = trials.map(|trial| trial.name.as_str()).collect();
        let evidence = evidence(&rows, &|fold| names.get(fold).unwrap_or(&"").to_string());
        let mut begin = 0;
        let folds = |results: &&Results| {
            begin += results.setting().trials.len();
            begin - results.setting().trials.len()..begin
        };
        let people: Vec<Range<usize>> = several.iter().map(folds).collect();
        let parts = several.first().map_or(1, |results| results.setting().parts.len());
        let mut claims = primary_claims(&rows, &people, parts, &labels);
        claims.extend(secondary_claims(&rows, &people, parts, &growth, &labels));
        if several.iter().all(|results| results.setting().parts.len() == 3) {
            claims.extend(three_part_claims(&rows, &labels));
        }
        let groups = groups(rows.iter()).into_iter();
        let chosen: Vec<(&Candidate, usize)> = groups
            .filter_map(|group| {
                let (count, first) = (group.len(), group.first()?.candidate);
                // Without a common trial no size can be chosen.
                Some((
                    Contender::new(group, Choice::Rollouts).map_or(first, |c| c.most_often().candidate),
                    count,
                ))
            })
            .collect();
        let stands_for = |candidate: &Candidate| {
            chosen.iter().find(|(of_group, _)| *of_group == candidate).map_or(0, |(_, count)| *count)
        };
        let summary = |row: &Row| row.summary(labels.label(row.candidate), stands_for(row.candidate));
        let models = rows.iter().filter_map(summary).collect();
        let names = |results: &Results| -> Vec<String> {
            results.setting().parts.iter().map(|part| part.name.clone()).collect()
        };
        let first = several.first().map_or_else(Vec::new, |results| names(results));
        let parts = if several.iter().all(|results| names(results) == first) { first } else { Vec::new() };
        Self { parts, models, correlations: correlations(&rows, &labels), growth, evidence, claims }
    }
}

#[cfg(test)]
mod tests;
