//! Figure 7 of Velychko et al. (2018): the latent paths of each part, generated solid and training dashed,
//! both movements in one latent space.

use std::fmt::Write;
use vcgpdm::models::Reading;
use vcgpdm::models::library::TrainedLibrary;

const WIDTH: f64 = 420.0;
const MARGIN: f64 = 34.0;
/// Readable on white and on black. Training paths are dashed, generated ones solid.
const COLOURS: [&str; 2] = ["#c2543d", "#3b76b0"];

/// The movement of a path, whether it is a training path, and its points.
type Path = (usize, bool, Vec<(f64, f64)>);

pub fn svg(trained: &TrainedLibrary) -> String {
    let library = &trained.library;
    let parts = trained.body.layout.parts();
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        WIDTH * parts.len() as f64,
        WIDTH + 24.0
    );
    for (part, spec) in parts.iter().enumerate() {
        let mut paths: Vec<Path> = Vec::new();
        for (m, movement) in library.movements.iter().enumerate() {
            let model = library.movement(m).unwrap();
            let dynamics = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
            let frames = movement.starts[0][part].nrows();
            let generated = dynamics.path(&model.start(0, 0).unwrap(), frames).unwrap();
            let points = |x: &nalgebra::DMatrix<f64>| x.row_iter().map(|row| (row[0], row[1])).collect();
            paths.push((m, true, points(&movement.starts[0][part])));
            paths.push((m, false, points(&generated[part])));
        }
        let largest = paths
            .iter()
            .flat_map(|(_, _, points)| points)
            .fold(0.0_f64, |largest, (x, y)| largest.max(x.abs()).max(y.abs()));
        let scale = (WIDTH / 2.0 - MARGIN) / largest.max(1e-9);
        let (left, middle) = (WIDTH * part as f64, WIDTH / 2.0);
        for (m, training, points) in paths {
            let place =
                |(x, y): (f64, f64)| format!("{:.1},{:.1}", left + middle + scale * x, middle - scale * y);
            let points: Vec<String> = points.into_iter().map(place).collect();
            let dash = if training { " stroke-dasharray=\"4 4\" stroke-opacity=\"0.7\"" } else { "" };
            let _ = writeln!(
                out,
                "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{dash} points=\"{}\"/>",
                COLOURS[m % 2],
                points.join(" ")
            );
        }
        let _ = writeln!(
            out,
            "<text x=\"{}\" y=\"20\" text-anchor=\"middle\">{} body, latents 1 and 2</text>",
            left + middle,
            spec.name
        );
    }
    for (m, movement) in library.movements.iter().enumerate() {
        let x = 24.0 + 200.0 * m as f64;
        let _ = writeln!(
            out,
            "<text x=\"{x}\" y=\"{}\" fill=\"{}\">{} (dashed: training)</text>",
            WIDTH + 10.0,
            COLOURS[m % 2],
            movement.name
        );
    }
    out.push_str("</svg>\n");
    out
}
