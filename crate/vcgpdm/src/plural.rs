//! Nouns with a number, for messages.

/// A count with its noun: "1 frame", "2 frames". The plural of the noun must end with s.
pub fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    #[test]
    fn one_has_the_singular() {
        assert_eq!(
            [0, 1, 2].map(|count| crate::plural::counted(count, "frame")),
            ["0 frames", "1 frame", "2 frames"]
        );
    }
}
