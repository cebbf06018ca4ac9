//! `vcgpdm report`: the tables of an evaluation, as Markdown or as JSON.

mod one_line;

use crate::files;
pub use crate::report::one_line::one_line;
use crate::report::one_line::spread;
use crate::results::{Merged, Preferred, read};
use serde_json::{Value, json};
use std::collections::HashSet;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use vcgpdm_lab::evaluation::stats::Interval;
use vcgpdm_lab::evaluation::{Claim, Comparison, FramesAndTime, Labels, Results, fixed};

/// Print the tables of an evaluation, and what they mean for the claims of the papers.
///
/// Results of the same trials and parts are put together. Results of other trials are another subject with
/// its own tables; one more table is for all subjects.
#[derive(clap::Args)]
pub struct Arguments {
    /// Files that `evaluate` wrote.
    #[arg(value_name = "RESULTS.json", required = true)]
    results: Vec<PathBuf>,
    /// Which file counts where files hold different numbers of the same job.
    #[arg(long)]
    prefer: Option<Preferred>,
    /// Print the numbers of the tables as one JSON object instead.
    #[arg(long)]
    json: bool,
    /// Print only the primary claims over all subjects, and the ratio of the errors of each subject. Only models
    /// and sizes of which all subjects have results count.
    #[arg(long, conflicts_with = "json")]
    primary: bool,
}

/// Results of the same trials.
struct Subject {
    name: String,
    results: Results,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let subjects = subjects(&arguments.results, arguments.prefer)?;
    if arguments.json {
        return files::print_json(&numbers(&subjects));
    }
    let mut text = String::new();
    if arguments.primary {
        let different = different(&subjects);
        let all: Vec<&Results> = different.iter().map(|subject| &subject.results).collect();
        let alike: Vec<Results> = all.iter().map(|results| results.in_common(&all)).collect();
        let comparison = Comparison::of_several(&alike.iter().collect::<Vec<_>>());
        claims(&mut text, &comparison, true)?;
        ratios(&mut text, &comparison, &different)?;
        return files::print(&files::escape(&text));
    }
    for subject in &subjects {
        if subjects.len() > 1 {
            writeln!(text, "### {}\n", one_line(&subject.name))?;
        }
        let setting = subject.results.setting();
        let comparison = Comparison::new(&subject.results);
        let names: Vec<String> = comparison.parts.iter().map(|part| one_line(part)).collect();
        writeln!(
            text,
            "{} trials, parts {}, {} frames a second; predictions start from {} frames.\n",
            setting.trials.len(),
            names.join(" and "),
            setting.frames_per_second,
            setting.start_frames
        )?;
        models(&mut text, &comparison)?;
        details(&mut text, &comparison)?;
        correlations(&mut text, &comparison)?;
        growth(&mut text, &comparison)?;
        evidence(&mut text, &comparison)?;
        failures(&mut text, &subject.results)?;
        claims(&mut text, &comparison, false)?;
    }
    if subjects.len() > 1 {
        let comparison = together(&subjects);
        writeln!(
            text,
            "\n### All together\n\nEvery trial counts once: of files with the same clips, the first one counts.\n"
        )?;
        models(&mut text, &comparison)?;
        details(&mut text, &comparison)?;
        claims(&mut text, &comparison, false)?;
    }
    files::print(&files::escape(&text))
}

/// The numbers of the tables: of each subject and, if there are several, of all together.
fn numbers(subjects: &[Subject]) -> Value {
    let numbers = |subject: &Subject| {
        let results = &subject.results;
        let failed = results.finished().iter().filter(|finished| finished.failure.is_some());
        json!({
            "name": subject.name,
            "setting": results.setting(),
            "comparison": Comparison::new(results),
            "failed": failed.collect::<Vec<_>>(),
        })
    };
    let all = (subjects.len() > 1).then(|| together(subjects));
    json!({ "subjects": subjects.iter().map(numbers).collect::<Vec<_>>(), "all_together": all })
}

/// The subjects without those whose clips belong to an earlier subject, which were predicted from another
/// number of frames or cut.
fn different(subjects: &[Subject]) -> Vec<&Subject> {
    let mut clips: HashSet<&str> = HashSet::new();
    let mut all = Vec::new();
    for subject in subjects {
        let trials = || subject.results.setting().trials.iter().map(|trial| trial.sha256.as_str());
        if trials().all(|clip| !clips.contains(clip)) {
            clips.extend(trials());
            all.push(subject);
        }
    }
    all
}

fn together(subjects: &[Subject]) -> Comparison {
    Comparison::of_several(&different(subjects).iter().map(|subject| &subject.results).collect::<Vec<_>>())
}

/// Reads the files; those of the same trials become one subject.
fn subjects(paths: &[PathBuf], preferred: Option<Preferred>) -> Result<Vec<Subject>, Box<dyn Error>> {
    let mut subjects: Vec<(String, Merged)> = Vec::new();
    for path in paths {
        let results = read(path)?;
        match subjects.iter_mut().find(|(_, merged)| merged.results.has_same_setting(&results)) {
            Some((_, merged)) => merged.add(path, results, preferred)?,
            None => {
                let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
                subjects.push((stem.unwrap_or_default(), Merged::new(path, results)));
            }
        }
    }
    Ok(subjects.into_iter().map(|(name, merged)| Subject { name, results: merged.results }).collect())
}

/// Figure 4 of Velychko et al. 2018 as a table.
fn models(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.models.is_empty() {
        return Ok(());
    }
    let parts = &comparison.parts;
    let part_headings: String = parts.iter().map(|part| format!(" {} |", one_line(part))).collect();
    writeln!(
        text,
        "| model | settings | DTW MSE | median of the DTW MSE | DTW MSE in % of the trial's variance |{part_headings} DTW MSE on the training trials | bound | bound: pose terms | bound: dynamics terms | training, s | converged | numbers stored | folds | runs |"
    )?;
    writeln!(text, "{}|", "|---".repeat(13 + parts.len()))?;
    for s in &comparison.models {
        writeln!(
            text,
            "| {} | {} | {} | {} | {} % |{} {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            s.model.id(),
            s.label,
            spread(&s.mse, 5),
            fixed(s.mse_median, 5),
            fixed(100.0 * s.mse.mean / s.variance, 0),
            (0..parts.len())
                .map(|k| s
                    .part_errors
                    .get(k)
                    .map_or(" |".to_owned(), |error| format!(" {} |", fixed(*error, 5))))
                .collect::<String>(),
            s.training_mse.as_ref().map_or(String::new(), |error| spread(error, 5)),
            s.bound.as_ref().map_or(String::new(), |b| spread(b, 0)),
            s.terms.map_or(String::new(), |terms| fixed(terms.pose, 0)),
            s.terms.map_or(String::new(), |terms| fixed(terms.dynamics, 0)),
            spread(&s.seconds, 1),
            s.converged.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share)),
            fixed(s.stored_numbers.mean, 0),
            s.folds,
            s.runs
        )?;
    }
    writeln!(
        text,
        "\nMean ± standard error over the trials held out. *Converged* is the share of trainings that ended because the bound or the density no longer changed. The pose terms are those of the pose maps; the dynamics terms are all others."
    )?;
    if !parts.is_empty() {
        writeln!(text, "The columns of the parts are the errors of each part along the same warping path.")?;
    }
    writeln!(text)
}

/// More about the predictions, of the models whose results have it.
fn details(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    let rows = || comparison.models.iter().filter_map(|model| Some((model, model.details.as_ref()?)));
    let Some((_, first)) = rows().next() else { return Ok(()) };
    let parts: Vec<String> = match comparison.parts.is_empty() {
        true => (1..=first.own_path.len()).map(|part| format!("part {part}")).collect(),
        false => comparison.parts.iter().map(|part| one_line(part)).collect(),
    };
    let headings = |what: &str| parts.iter().map(|part| format!(" {what}, {part} |")).collect::<String>();
    writeln!(
        text,
        "| model | settings |{}{} speed : recorded | foot slide (recorded) | still at 20 s | in the 50 % band | in the 95 % band | log density | folds |",
        headings("first half second"),
        headings("own path")
    )?;
    writeln!(text, "{}|", "|---".repeat(9 + 2 * parts.len()))?;
    for (model, details) in rows() {
        let errors = |errors: &[f64]| {
            errors.iter().map(|error| format!(" {} |", fixed(*error, 5))).collect::<String>()
        };
        let slide = details.foot_slide.map_or(String::new(), |slide| {
            format!("{} ({})", fixed(slide.predicted, 2), fixed(slide.recorded, 2))
        });
        let bands = details.bands.map_or(" | | ".to_owned(), |bands| {
            let (half, most) = (fixed(100.0 * bands.within_50, 0), fixed(100.0 * bands.within_95, 0));
            format!("{half} % | {most} % | {}", fixed(bands.log_density, 2))
        });
        writeln!(
            text,
            "| {} | {} |{}{} {} | {slide} | {:.0} % | {bands} | {} |",
            model.model.id(),
            model.label,
            errors(&details.first_half_second),
            errors(&details.own_path),
            fixed(details.speed, 2),
            100.0 * details.still_at_20_s,
            details.folds
        )?;
    }
    writeln!(
        text,
        "\nMeans over the trials held out. *First half second*: mean squared error frame by frame after the given frames, not centred. *Own path*: DTW MSE of a part along a path of its own. *Speed*: of the nodes relative to the root. *Foot slide*: horizontal speed of the standing foot in walking speeds. *Still at 20 s*: all columns keep their last values for a second. *Bands* and *log density* (nats for each number): predicted Gaussians of single columns over two seconds after the given frames, with the observation noise.\n"
    )
}

fn correlations(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.correlations.is_empty() {
        return Ok(());
    }
    writeln!(
        text,
        "| model | settings compared | rank correlation of bound and MSE within a trial | 95 % interval |\n|---|---|---|---|"
    )?;
    for c in &comparison.correlations {
        let (comma, label) = if c.label.is_empty() { ("", "") } else { (", ", c.label.as_str()) };
        let (id, range) = (c.model.id(), c.interval.map_or(String::new(), |interval| interval.to_string()));
        writeln!(text, "| {id}{comma}{label} | {} | {:.2} | {range} |", c.settings, c.rank)?;
    }
    writeln!(text, "\nThe mean over the trials held out, with Student's interval over these trials.\n")
}

fn growth(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.growth.is_empty() {
        return Ok(());
    }
    writeln!(
        text,
        "| model | settings | frames: ms an iteration (s a training) | converged | exponent of an iteration | of a training |\n|---|---|---|---|---|---|"
    )?;
    for g in &comparison.growth {
        let point = |p: &FramesAndTime| {
            let (frames, milliseconds) = (fixed(p.frames, 0), fixed(1e3 * p.seconds, 2));
            format!("{frames}: {milliseconds} ({})", fixed(p.training_seconds, 1))
        };
        let list: Vec<String> = g.points.iter().map(point).collect();
        let power = |exponent: Option<f64>, interval: Option<Interval>| {
            let range = interval.map_or(String::new(), |i| format!(" ({i})"));
            exponent.map_or(String::new(), |e| format!("{}{range}", fixed(e, 2)))
        };
        writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            g.model.id(),
            g.label,
            list.join(", "),
            g.converged.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share)),
            power(g.exponent, g.interval),
            power(g.training_exponent, g.training_interval)
        )?;
    }
    writeln!(text)
}

/// Bayes factors next to ratios of errors.
fn evidence(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.evidence.is_empty() {
        return Ok(());
    }
    writeln!(
        text,
        "| trial held out | ln Bayes factor, several parts : one part (difference of the bounds) | error, several parts : one part |\n|---|---|---|"
    )?;
    for e in &comparison.evidence {
        let sign = if e.log_bayes_factor.is_sign_negative() { "" } else { "+" };
        let (factor, ratio) = (fixed(e.log_bayes_factor, 0), fixed(e.error_ratio, 2));
        writeln!(text, "| {} | {sign}{factor} | {ratio} |", one_line(&e.trial))?;
    }
    writeln!(text)
}

fn failures(text: &mut String, results: &Results) -> std::fmt::Result {
    let labels = Labels::new(results);
    for f in results.finished().iter().filter(|f| f.failure.is_some()) {
        let (job, why) = (&f.job, one_line(f.failure.as_deref().unwrap_or_default()));
        let (kind, label) = (job.candidate.kind().id(), labels.label(&job.candidate));
        writeln!(
            text,
            "Failed: {kind}, {label}, trial {} held out, seed {}: {why}\n",
            job.held_out + 1,
            job.seed
        )?;
    }
    Ok(())
}

/// What each subject says about the primary claims.
fn ratios(text: &mut String, comparison: &Comparison, subjects: &[&Subject]) -> std::fmt::Result {
    let claims: Vec<&Claim> = comparison.claims.iter().filter(|claim| !claim.persons.is_empty()).collect();
    if claims.is_empty() {
        return Ok(());
    }
    let headings: String = (1..=claims.len()).map(|claim| format!(" claim {claim} |")).collect();
    writeln!(text, "| ratio of the errors in the median trial | trials |{headings}")?;
    writeln!(text, "{}|", "|---".repeat(2 + claims.len()))?;
    for (k, subject) in subjects.iter().enumerate() {
        let ratio = |claim: &&Claim| match claim.persons.get(k) {
            Some(Some(ratio)) => format!(" {} |", fixed(*ratio, 2)),
            _ => " |".to_owned(),
        };
        let ratios: String = claims.iter().map(ratio).collect();
        let trials = subject.results.setting().trials.len();
        writeln!(text, "| {} | {trials} |{ratios}", one_line(&subject.name))?;
    }
    writeln!(text, "\nThe claims are numbered in the order of the table above.\n")
}

/// The claims of the papers, and whether they hold in these results.
fn claims(text: &mut String, comparison: &Comparison, only_primary: bool) -> std::fmt::Result {
    if comparison.claims.is_empty() {
        return Ok(());
    }
    for (heading, primary) in [("primary claim", true), ("secondary claim", false)] {
        let claims: Vec<&Claim> = comparison.claims.iter().filter(|claim| claim.primary == primary).collect();
        if claims.is_empty() || only_primary && !primary {
            continue;
        }
        writeln!(text, "| {heading} | our criterion | we find | holds here |\n|---|---|---|---|")?;
        for c in claims {
            let (claim, found) = (one_line(&c.claim), one_line(&c.found));
            writeln!(text, "| {claim} ({}) | {} | {found} | {} |", c.place, c.criterion, c.answer.word())?;
        }
        writeln!(text)?;
    }
    writeln!(
        text,
        "Errors are compared trial by trial: \"0.90 times\" is the error of the first model divided by that of the second. Settings are chosen for each trial by the error of rollouts on the training trials; claims about the bound take the highest bound. A row names those chosen most often.\n"
    )?;
    write!(
        text,
        "Primary claims were named before the tables were made. Within one person their p value is that of the sign test over the trials, with fewer than six trials that of Student's t test of the logarithms; over several persons it is that of Student's t test of the persons' median logarithms. Holm's correction keeps the probability of any false answer among them below 5 %, if the numbers of persons and trials were fixed before. "
    )?;
    if !only_primary {
        write!(
            text,
            "Secondary claims are not corrected for their number, and their unit is the trial: of many such answers some are false. Their interval of the median covers at least 95 % (sign test), those of means, of logarithms or rank correlations, about 95 % (Student's t). The answer follows from the interval of the median, with fewer than six trials from that of the mean; it is yes or no only if the whole interval says so. "
        )?;
    }
    writeln!(text, "Trials share their training data, so that the intervals are a little too narrow.\n")
}
