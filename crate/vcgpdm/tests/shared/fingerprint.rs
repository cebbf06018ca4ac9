//! Fingerprints of results. A test compares them with those of earlier versions, and so notices a change that no other
//! test notices. When it fails, it prints the results: compare them with those of the version before.

use super::sha256;

/// Mean and mean square of some numbers, to five digits: the other digits can differ between processors.
pub fn numbers<'a>(values: impl IntoIterator<Item = &'a f64>) -> String {
    let values: Vec<f64> = values.into_iter().copied().collect();
    let count = values.len().max(1) as f64;
    let [mean, square] = [1, 2].map(|power| values.iter().map(|v| v.powi(power)).sum::<f64>() / count);
    let [mean, square] = [mean, square].map(|value| if value.abs() < 1e-9 { 0.0 } else { value });
    format!("{mean:.4e} {square:.4e}")
}

/// The text without the sign of a zero, which is chance.
pub fn without_sign_of_zero(text: &str) -> String {
    text.replace("-0.000", "0.000")
}

/// The first digits of the hash of the results, one a line.
pub fn fingerprint(subject: &str, results: &[String]) -> String {
    for (place, result) in results.iter().enumerate() {
        println!("{subject}, {place}: {result}");
    }
    sha256(results.join("\n").as_bytes())[..8].to_owned()
}
