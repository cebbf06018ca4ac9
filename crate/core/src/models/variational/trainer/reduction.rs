//! Reduces settings that the data do not allow.

use crate::models::training::settings::VariationalSettings;
use crate::models::variational::repertoire::Repertoire;
use crate::plural::counted;
use nalgebra::DMatrix;

/// The settings with at most one inducing point for each row at the start, and a notice of each reduction, as
/// a sentence without a full stop.
pub(super) fn reduce_settings(
    settings: &VariationalSettings,
    repertoire: &Repertoire,
    y: &[DMatrix<f64>],
) -> (VariationalSettings, Vec<String>) {
    let mut settings = settings.clone();
    let mut notices = Vec::new();
    let frames = repertoire.sequences().frames();
    if settings.pose_ips > frames {
        notices.push(fewer("pose", settings.pose_ips, &counted(frames, "frame")));
        settings.pose_ips = frames;
    }
    let rows = (0..repertoire.primitives().len()).map(|primitive| {
        let in_use = repertoire.movements().iter().filter(|movement| movement.uses().contains(&primitive));
        in_use.map(|movement| movement.sequences().transitions()).sum::<usize>()
    });
    // A primitive that no movement uses starts with the histories of all.
    let rows = rows.filter(|rows| *rows > 0).min().unwrap_or(frames);
    if settings.dynamics_ips > rows {
        let there = format!("{} with a history", counted(rows, "frame"));
        notices.push(fewer("dynamics", settings.dynamics_ips, &there));
        settings.dynamics_ips = rows;
    }
    if let Some(columns) = y.iter().map(DMatrix::ncols).min().filter(|columns| *columns < settings.latent) {
        notices.push(format!(
            "a part has only {}: for {} of its {} latent dimensions there is only noise to begin with",
            counted(columns, "column"),
            settings.latent - columns,
            settings.latent
        ));
    }
    (settings, notices)
}

fn fewer(what: &str, asked: usize, there: &str) -> String {
    format!("{asked} {what} inducing points are reduced, because there are only {there}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::data::sequences::Sequences;

    fn reduce(
        lengths: &[usize],
        columns: usize,
        asked: (usize, usize, usize),
    ) -> (VariationalSettings, Vec<String>) {
        let (latent, dynamics_ips, pose_ips) = asked;
        let settings =
            VariationalSettings { latent, dynamics_ips, pose_ips, ..VariationalSettings::default() };
        let sequences = Sequences::new(lengths.to_vec(), settings.order).unwrap();
        let y = [DMatrix::zeros(sequences.frames(), columns), DMatrix::zeros(sequences.frames(), 9)];
        reduce_settings(&settings, &Repertoire::plain(sequences, 2), &y)
    }

    #[test]
    fn leaves_settings_that_the_data_allow() {
        let (settings, notices) = reduce(&[8, 8], 3, (3, 12, 16));
        assert_eq!((settings.dynamics_ips, settings.pose_ips), (12, 16));
        assert_eq!(notices, [""; 0]);
    }

    #[test]
    fn reduces_other_settings_with_notices() {
        let (settings, notices) = reduce(&[8, 8], 1, (3, 13, 17));
        assert_eq!((settings.latent, settings.dynamics_ips, settings.pose_ips), (3, 12, 16));
        assert_eq!(
            notices,
            [
                "17 pose inducing points are reduced, because there are only 16 frames",
                "13 dynamics inducing points are reduced, because there are only 12 frames with a history",
                "a part has only 1 column: for 2 of its 3 latent dimensions there is only noise to begin with",
            ]
        );
    }

    #[test]
    fn a_primitive_that_no_movement_uses_reduces_nothing() {
        let settings = VariationalSettings { dynamics_ips: 12, pose_ips: 16, ..Default::default() };
        let sequences = Sequences::new(vec![8, 8], settings.order).unwrap();
        let repertoire = Repertoire::new(sequences, 1, vec![0, 0], vec![(2, vec![0])]).unwrap();
        let reduced = reduce_settings(&settings, &repertoire, &[DMatrix::zeros(16, 9)]);
        assert_eq!(reduced, (settings, Vec::new()));
    }
}
