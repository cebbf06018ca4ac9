//! Words of messages that depend on a number.

/// A number with what it counts: "1 frame", "2 frames". The plural of the noun must be formed with s.
pub fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    #[test]
    fn one_is_not_many() {
        assert_eq!(
            [0, 1, 2].map(|count| crate::words::counted(count, "frame")),
            ["0 frames", "1 frame", "2 frames"]
        );
    }
}
