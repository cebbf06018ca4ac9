//! Nouns with a number and lists of names, for messages.

/// A count with its noun: "1 frame", "2 frames". The plural of the noun must end with s.
pub fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// The first three names in quotes, and how many more there are.
pub fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.into_iter().map(|name| format!("{name:?}")).collect();
    match names.len().checked_sub(3) {
        None | Some(0) => names.join(", "),
        Some(more) => format!("{} and {more} more", names[..3].join(", ")),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_list_names_three() {
        let lists = [&["a"][..], &["a", "b", "c"], &["a", "b", "c", "d", "e"]];
        let listed = lists.map(|names| crate::plural::listed(names.iter().copied()));
        assert_eq!(listed, ["\"a\"", "\"a\", \"b\", \"c\"", "\"a\", \"b\", \"c\" and 2 more"]);
    }

    #[test]
    fn one_has_the_singular() {
        assert_eq!(
            [0, 1, 2].map(|count| crate::plural::counted(count, "frame")),
            ["0 frames", "1 frame", "2 frames"]
        );
    }
}
