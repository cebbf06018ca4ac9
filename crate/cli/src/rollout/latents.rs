//! Latents as tables: CSV with a header and one row for each frame.

use nalgebra::DMatrix;
use vcgpdm_core::models::variational::LatentMoments;
use vcgpdm_core::series;

/// One row for each frame: frame, time in seconds, and the latents of all parts.
pub fn csv(parts: &[String], latents: &[DMatrix<f64>], frame_time: f64) -> String {
    let columns: Vec<_> = (parts.iter().zip(latents))
        .flat_map(|(part, x)| {
            let column = move |q| (format!("{part}_{q}"), x.column(q).iter().copied().collect());
            (0..x.ncols()).map(column)
        })
        .collect();
    table(&columns, frame_time)
}

/// One row for each frame: frame, time in seconds, and mean and variance of the latents of all parts.
pub fn moments_csv(parts: &[String], moments: &LatentMoments, frame_time: f64) -> String {
    let columns: Vec<_> = (parts.iter().enumerate())
        .flat_map(|(i, part)| {
            let means = &moments.means[i];
            (0..means.ncols()).flat_map(move |q| {
                let variances = moments.covariances[i].iter().map(|covariance| covariance[(q, q)]);
                [
                    (format!("{part}_{q}_mean"), means.column(q).iter().copied().collect()),
                    (format!("{part}_{q}_variance"), variances.collect::<Vec<f64>>()),
                ]
            })
        })
        .collect();
    table(&columns, frame_time)
}

fn table(columns: &[(String, Vec<f64>)], frame_time: f64) -> String {
    let names: Vec<String> = columns.iter().map(|(name, _)| name.clone()).collect();
    let frames = columns.first().map_or(0, |(_, values)| values.len());
    series::write(
        &names,
        &DMatrix::from_fn(frames, columns.len(), |frame, k| columns[k].1[frame]),
        frame_time,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_a_header_and_a_row_for_each_frame() {
        let latents = [
            DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 3.0, 4.5]),
            DMatrix::from_row_slice(2, 1, &[-1.0, 0.5]),
        ];
        let names = ["lower".to_owned(), "up, \"er\"".to_owned()];
        let text = csv(&names, &latents, 0.25);
        assert_eq!(text, "frame,time,lower_0,lower_1,\"up, \"\"er\"\"_0\"\n0,0,1,2,-1\n1,0.25,3,4.5,0.5\n");
    }

    #[test]
    fn guards_names_against_spreadsheets() {
        let text = csv(&["=1+1".to_owned()], &[DMatrix::from_element(1, 1, 2.0)], 0.25);
        assert_eq!(text, "frame,time,'=1+1_0\n0,0,2\n");
    }

    #[test]
    fn writes_a_mean_and_a_variance_for_each_latent() {
        let moments = LatentMoments {
            means: vec![DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 3.0, 4.5])],
            covariances: vec![vec![
                DMatrix::zeros(2, 2),
                DMatrix::from_row_slice(2, 2, &[0.25, 9.0, 9.0, 0.5]),
            ]],
        };
        let text = moments_csv(&["lower".to_owned()], &moments, 0.5);
        let header = "frame,time,lower_0_mean,lower_0_variance,lower_1_mean,lower_1_variance";
        assert_eq!(text, format!("{header}\n0,0,1,0,2,0\n1,0.5,3,0.25,4.5,0.5\n"));
    }
}
