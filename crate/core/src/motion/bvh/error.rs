//! Why a file could not be read.

use thiserror::Error;

/// Why a file could not be read, and where.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{file}, line {line}: {problem}")]
pub struct BvhError {
    /// The file's name as given to [`read`](crate::motion::bvh::read).
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// What is wrong there.
    pub problem: BvhProblem,
}

/// What is wrong with a file.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum BvhProblem {
    /// The format requires something else at this place.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What was expected.
        expected: String,
        /// What was found.
        found: String,
    },
    /// A second ROOT.
    #[error("expected MOTION, found a second ROOT: a clip of one body is expected, please split the file")]
    SecondRoot,
    /// Too many joints, or too many end sites.
    #[error("expected at most {max} joints and as many end sites, found more")]
    TooManyJoints {
        /// The limit.
        max: usize,
    },
    /// More frames than [`Skeleton::max_frames`](crate::motion::skeleton::Skeleton::max_frames).
    #[error(
        "expected at most {most} frames of a body with {nodes} joints and end sites, found {frames}: \
         please cut the recording, or leave \
         out every second frame"
    )]
    TooManyFrames {
        /// Frames declared or found.
        frames: usize,
        /// Joints and end sites.
        nodes: usize,
        /// The limit.
        most: usize,
    },
    /// The number of rows is far from the one that the header declares.
    #[error(
        "expected {declared} rows as \"Frames:\" declares, found {found}: if the file is whole, write {found} there"
    )]
    RowCount {
        /// Rows declared.
        declared: usize,
        /// Rows found.
        found: usize,
    },
    /// A row that is too short or too long.
    #[error("expected {expected} values in the row of frame {frame}, found {found}")]
    RowLength {
        /// The frame, counted from 1.
        frame: usize,
        /// Channels of the skeleton.
        expected: usize,
        /// Numbers in the row.
        found: usize,
    },
}

impl BvhProblem {
    /// An error with the found word shortened and quoted.
    pub(super) fn expected(expected: &str, found: Option<&str>) -> BvhProblem {
        let found = found.map_or("the end of the file".to_owned(), quoted);
        BvhProblem::Expected { expected: expected.to_owned(), found }
    }
}

/// A word of the file for a message: escaped, in quotes, at most 40 characters.
pub(super) fn quoted(word: &str) -> String {
    const LONGEST: usize = 40;
    if word.chars().count() <= LONGEST {
        return format!("{word:?}");
    }
    format!("{:?}", word.chars().take(LONGEST).chain(['…']).collect::<String>())
}

crate::coded!(BvhError => Clip);
