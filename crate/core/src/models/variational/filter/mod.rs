//! The latents of all parts, inferred from observed columns while the movement goes on: the trained model
//! read as a state space.
//!
//! The state at time t is h_t, the last p latents of all parts, with the Gaussian belief N(m, P).
//!
//! *Predict.* x^i_{t+1} = sum_j w_{ji} f^{ji}(x^j) + noise under the product of experts (Velychko et al. 2018,
//! equations 1 and 2). Mean, covariance and the covariance with h_t are exact for a Gaussian h_t, by the psi
//! statistics with full covariances (their appendix B; Deisenroth, Huber and Hanebeck 2009); the result is
//! replaced by a Gaussian with these moments.
//!
//! *Correct.* Any columns c of any parts are observed: y_c = g_c(s) + e_c, where s are the newest latents of
//! the parts with observed columns and e_c has the variance R(s) = beta^i + the variance of the pose map
//! there. A few Gauss-Newton steps minimise
//!
//! sum_c (y_c - g_c(s))^2 / (2 R) + (s - m_s)^T P_ss^-1 (s - m_s) / 2,
//!
//! with R fixed within a step (the iterated extended Kalman filter; Bell and Cathey 1993). The pose map is
//! linearised at the minimum s*, because the columns of a part determine its latents far more exactly than
//! the prediction does. With s = m_s + L u, P_ss = L L^T, G the slopes at s* and B = I + L^T G R^-1 G^T L:
//!
//! m+ = m + A u*,   P+ = P - A (I - B^-1) A^T,   A = P_hs L^-T.
//!
//! All latents of the state change, of other parts and of earlier frames, through P_hs. By Laplace's method
//!
//! log p(y) = log N(y; g(s*), R) - |u*|^2 / 2 - log|B| / 2.
//!
//! A model whose training weighted the pose terms by gamma_i has latents under p(y | s)^gamma_i, and so has the
//! filter: R / gamma_i in place of R.
//!
//! Missing numbers are left out of the sum; a frame without any number is only predicted.
//!
//! *Smooth.* Backwards over a clip (Rauch, Tung and Striebel 1965; for moments as here Deisenroth, Turner et
//! al. 2012): the oldest latents o of h_t are those that h_{t+1} does not hold any more. With
//! J = cov(o, h_{t+1}) P_{t+1}^-1 from the prediction, o given all frames has the mean
//! m_o + J (m^s_{t+1} - m_{t+1}) and the covariance P_oo + J (P^s_{t+1} - P_{t+1}) J^T.
//!
//! The errors of a pose map are the same unknown function in all frames; here each frame counts them as new
//! noise, so that long recordings look more certain than they are (docs/completing.md measures by how much).

mod completion;
mod correction;
mod error;
mod pose_process;
mod run;
mod start;
mod step;
#[cfg(test)]
mod tests;

pub use completion::CompletionScore;
pub use error::ObservationError;
pub use pose_process::ColumnMoments;
pub use run::Filtered;
pub use step::Filter;
