//! Paints how sure a model is in a plane through the latent space of a part, in a canvas of a worker.

use crate::models::rollout::Rollout;
use crate::models::trained::coupled;
use crate::values::arguments::Whole;
use crate::values::convert::{from_js, matrix, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use serde::Deserialize;
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::models::variational::LatentField;
use wasm_bindgen::prelude::*;
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{ImageData, OffscreenCanvas, OffscreenCanvasRenderingContext2d};

/// Pixels of a cell, which has one colour before the picture is smoothed.
const CELL: usize = 4;
/// Pixels between two arrows.
const ARROWS: usize = 22;
/// Arrows are longer than the steps of one frame by this factor, and at most `ARROWS` pixels long.
const STRETCH: f64 = 4.0;
/// How opaque the colour is where the pose map is certain, of 255.
const OPAQUE: f64 = 110.0;
/// The widest and highest picture, in pixels.
const MOST_PIXELS: usize = 4096;

/// A picture of a plane through the latent space of a part.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct PlanePicture {
    /// In pixels.
    width: usize,
    /// In pixels.
    height: usize,
    /// The latents in the middle of the picture [Q].
    centre: Vec<f64>,
    /// The step of the latents for one pixel to the right [Q].
    right: Vec<f64>,
    /// The step of the latents for one pixel down [Q].
    down: Vec<f64>,
    /// Red, green and blue, 0 to 255.
    colour: [u8; 3],
}

impl PlanePicture {
    fn read(options: &JsValue) -> Result<Self, VcgpdmError> {
        let picture: Self = from_js(ErrorCode::Rollout, "picture", options)?;
        let Self { width, height, centre, right, down, .. } = &picture;
        if ![width, height].iter().all(|size| (1..=MOST_PIXELS).contains(*size)) {
            let words =
                format_args!("picture: expected from 1 to {MOST_PIXELS} pixels, found {width} x {height}");
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        if right.len() != centre.len() || down.len() != centre.len() {
            let words = format_args!(
                "picture: expected steps of {} dimensions, found {} and {}",
                centre.len(),
                right.len(),
                down.len()
            );
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        Ok(picture)
    }

    /// The latents at the middles of squares of `size` pixels, row after row [N x Q], and how many squares
    /// there are in a row and in a column.
    fn points(&self, size: usize) -> (DMatrix<f64>, usize, usize) {
        let (columns, rows) = (self.width.div_ceil(size), self.height.div_ceil(size));
        let offset = |k: usize, pixels: usize| (k as f64 + 0.5) * size as f64 - 0.5 * pixels as f64;
        let points = DMatrix::from_fn(rows * columns, self.centre.len(), |n, q| {
            let (x, y) = (offset(n % columns, self.width), offset(n / columns, self.height));
            self.centre[q] + x * self.right[q] + y * self.down[q]
        });
        (points, columns, rows)
    }

    /// A step of the latents in pixels to the right and down. Both directions of the plane are orthogonal.
    fn pixels(&self, step: &[f64]) -> (f64, f64) {
        let along = |axis: &[f64]| {
            let squared: f64 = axis.iter().map(|x| x * x).sum();
            // A latent space of one dimension has no direction down.
            let product: f64 = step.iter().zip(axis).map(|(step, x)| step * x).sum();
            if squared > 0.0 { product / squared } else { 0.0 }
        };
        (along(&self.right), along(&self.down))
    }

    /// The opacity of the colour: high where the pose map is certain.
    fn bytes(&self, field: &LatentField) -> Vec<u8> {
        let [red, green, blue] = self.colour;
        let alpha = |variance: &f64| (OPAQUE * (1.0 - variance)).round() as u8;
        field.pose_variance.iter().flat_map(|variance| [red, green, blue, alpha(variance)]).collect()
    }

    fn paint(&self, rollout: &Rollout, part: usize) -> Result<OffscreenCanvas, JsValue> {
        let (points, columns, rows) = self.points(CELL);
        let cells = canvas(columns, rows)?;
        let bytes = self.bytes(&field(rollout, part, &points)?);
        let image =
            ImageData::new_with_u8_clamped_array_and_sh(Clamped(&bytes), columns as u32, rows as u32)?;
        context(&cells)?.put_image_data(&image, 0.0, 0.0)?;

        let picture = canvas(self.width, self.height)?;
        let draw = context(&picture)?;
        let (wide, high) = ((columns * CELL) as f64, (rows * CELL) as f64);
        draw.draw_image_with_offscreen_canvas_and_dw_and_dh(&cells, 0.0, 0.0, wide, high)?;
        self.paint_arrows(&draw, rollout, part)?;
        Ok(picture)
    }

    /// The flow: an arrow along the mean step, faint where the dynamics are not certain.
    fn paint_arrows(
        &self,
        draw: &OffscreenCanvasRenderingContext2d,
        rollout: &Rollout,
        part: usize,
    ) -> Result<(), JsValue> {
        let (points, columns, _) = self.points(ARROWS);
        let field = field(rollout, part, &points)?;
        let [red, green, blue] = self.colour;
        draw.set_stroke_style_str(&format!("rgb({red} {green} {blue})"));
        draw.set_line_width(1.0);
        for (n, step) in field.steps.row_iter().enumerate() {
            let step: Vec<f64> = step.iter().copied().collect();
            let (right, down) = self.pixels(&step);
            let pixels = right.hypotenuse(down);
            let length = (STRETCH * pixels).min(ARROWS as f64);
            if length < 1.0 {
                continue;
            }
            let scale = length / pixels;
            let (dx, dy) = (scale * right, scale * down);
            let middle = |k: usize| (k as f64 + 0.5) * ARROWS as f64;
            let (x, y) = (middle(n % columns) - 0.5 * dx, middle(n / columns) - 0.5 * dy);
            let (tip_x, tip_y) = (x + dx, y + dy);
            draw.set_global_alpha(0.7 * (1.0 - field.dynamics_variance[n]).max(0.0));
            draw.begin_path();
            draw.move_to(x, y);
            draw.line_to(tip_x, tip_y);
            for side in [-1.0, 1.0] {
                draw.move_to(tip_x - 0.25 * (dx - side * dy), tip_y - 0.25 * (dy + side * dx));
                draw.line_to(tip_x, tip_y);
            }
            draw.stroke();
        }
        Ok(())
    }
}

fn field(rollout: &Rollout, part: usize, points: &DMatrix<f64>) -> Result<LatentField, VcgpdmError> {
    let model = coupled(rollout.model.body()?)?.model;
    Ok(model.latent_field(part, points, &rollout.rollout.latents, &rollout.request)?)
}

fn canvas(width: usize, height: usize) -> Result<OffscreenCanvas, JsValue> {
    OffscreenCanvas::new(width as u32, height as u32)
}

fn context(canvas: &OffscreenCanvas) -> Result<OffscreenCanvasRenderingContext2d, JsValue> {
    let context = canvas.get_context("2d")?.ok_or("expected a 2-D canvas, found none")?;
    Ok(context.unchecked_into())
}

#[wasm_bindgen]
impl Rollout {
    /// Paints how sure the model is in a plane through the latent space of a part: the colour where the pose
    /// map is certain, and arrows where the dynamics lead. Only where there is an `OffscreenCanvas`: in
    /// browsers and their workers.
    #[wasm_bindgen(js_name = paintPlane)]
    pub fn paint_plane(
        &self,
        part: &Whole,
        #[wasm_bindgen(unchecked_param_type = "PlanePicture")] picture: JsValue,
    ) -> Result<OffscreenCanvas, JsValue> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        PlanePicture::read(&picture)?.paint(self, part)
    }

    /// The numbers behind `paintPlane` at points of the latent space of a part [points][Q].
    #[wasm_bindgen(js_name = latentField, unchecked_return_type = "LatentField")]
    pub fn latent_field(
        &self,
        part: &Whole,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] points: JsValue,
    ) -> Result<JsValue, VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let points: Vec<Vec<f64>> = from_js(ErrorCode::Rollout, "points", &points)?;
        to_js(&field(self, part, &matrix(&points))?)
    }
}
