//! Numbers of tables.

/// From here on a number is written in its short form.
const LARGE: f64 = 1e12;

/// The number with this many decimals, or in the form 1.00e300: a stranger's file may hold any number, and a
/// cell of 300 digits helps nobody.
pub fn fixed(number: f64, decimals: usize) -> String {
    if number.abs() < LARGE || !number.is_finite() {
        format!("{number:.decimals$}")
    } else {
        format!("{number:.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::fixed;

    #[test]
    fn writes_usual_numbers_with_decimals_and_huge_ones_short() {
        assert_eq!([fixed(0.001_573, 5), fixed(-64_764.3, 0)], ["0.00157", "-64764"]);
        assert_eq!([fixed(1e300, 5), fixed(-1e300, 0)], ["1.00e300", "-1.00e300"]);
    }
}
