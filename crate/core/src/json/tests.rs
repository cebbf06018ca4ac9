//! Comparisons with serde_json, and error messages.

use super::*;
use proptest::prelude::*;

fn value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::Bool),
        any::<f64>().prop_filter("finite", |v| v.is_finite()).prop_map(Value::Number),
        any::<i32>().prop_map(|v| Value::Number(v.into())),
        any::<String>().prop_map(Value::Text),
        "[\\x00-\\x1f\"\\\\/é𝄞]{0,6}".prop_map(Value::Text),
    ];
    leaf.prop_recursive(4, 40, 6, |inner| {
        let names = prop::collection::vec((any::<String>(), inner.clone()), 0..6);
        prop_oneof![prop::collection::vec(inner, 0..6).prop_map(Value::List), names.prop_map(Value::Object)]
    })
}

/// The same tree from serde_json, which keeps the last of several fields with one name.
fn from_serde(value: &serde_json::Value) -> Value {
    match value {
        serde_json::Value::Null => Value::Null,
        serde_json::Value::Bool(v) => Value::Bool(*v),
        serde_json::Value::Number(v) => Value::Number(v.as_f64().unwrap()),
        serde_json::Value::String(v) => Value::Text(v.clone()),
        serde_json::Value::Array(items) => Value::list(items, from_serde),
        serde_json::Value::Object(fields) => {
            Value::Object(fields.iter().map(|(name, v)| (name.clone(), from_serde(v))).collect())
        }
    }
}

/// Fields by name, the last of each.
fn sorted(value: Value) -> Value {
    match value {
        Value::List(items) => Value::list(items, sorted),
        Value::Object(fields) => {
            let fields: std::collections::BTreeMap<String, Value> = fields.into_iter().collect();
            Value::Object(fields.into_iter().map(|(name, v)| (name, sorted(v))).collect())
        }
        other => other,
    }
}

/// Equality that distinguishes 0 from -0.
fn same(a: &Value, b: &Value) -> bool {
    write(a) == write(b) && a == b
}

proptest! {
    #[test]
    fn what_is_written_reads_back_here_and_in_serde_json(value in value()) {
        let text = write(&value).unwrap();
        prop_assert!(same(&parse(&text).unwrap(), &value), "{text}");
        let serde: serde_json::Value = serde_json::from_str(&text).unwrap();
        prop_assert!(same(&sorted(from_serde(&serde)), &sorted(value)), "{text}");
    }

    #[test]
    fn what_serde_json_writes_is_read(value in value()) {
        let serde: serde_json::Value = serde_json::from_str(&write(&value).unwrap()).unwrap();
        for text in [serde.to_string(), serde_json::to_string_pretty(&serde).unwrap()] {
            prop_assert!(same(&sorted(parse(&text).unwrap()), &sorted(value.clone())), "{text}");
        }
    }

    #[test]
    fn damaged_texts_are_accepted_and_refused_as_by_serde_json(
        value in value(),
        at in any::<prop::sample::Index>(),
        byte in prop::sample::select(b"{}[],:\"\\0-+.eE1u tn\n\x01".to_vec()),
        cut in any::<bool>(),
    ) {
        let mut text = write(&value).unwrap().into_bytes();
        let at = at.index(text.len());
        if cut { text.truncate(at) } else { text[at] = byte }
        if let Ok(text) = String::from_utf8(text) {
            let serde = serde_json::from_str::<serde_json::Value>(&text);
            prop_assert_eq!(parse(&text).is_ok(), serde.is_ok(), "{}", text);
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        prop_assert_eq!(parse(&text).is_ok(), serde_json::from_str::<serde_json::Value>(&text).is_ok());
        let _ = outline(&text);
    }

    #[test]
    fn an_outline_names_the_fields_that_are_read(value in value()) {
        let text = write(&value).unwrap();
        let names = |fields: Vec<(String, Value)>| fields.into_iter().map(|(name, _)| name).collect();
        let found: Option<Vec<String>> = outline(&text).ok().map(names);
        let expected = match value {
            Value::Object(fields) => Some(names(fields)),
            _ => None,
        };
        prop_assert_eq!(found, expected, "{}", text);
    }
}

#[test]
fn errors_say_line_column_expected_and_found() {
    let deep = "[".repeat(200_000);
    for (text, wanted) in [
        ("", "line 1, column 1: expected a value, found the end of the text"),
        ("HIERARCHY", "line 1, column 1: expected a value, found \"H\""),
        ("{\"a\": 1,\n  \"é\" 2}", "line 2, column 7: expected \":\", found \"2\""),
        ("[1, 2", "line 1, column 6: expected \",\" or \"]\", found the end of the text"),
        ("[1] 2", "line 1, column 5: expected the end of the text, found \"2\""),
        ("[NaN]", "line 1, column 2: expected a value, found \"N\""),
        ("{a: 1}", "line 1, column 2: expected the name of a field in quotes, found \"a\""),
        ("[1.]", "line 1, column 4: expected a digit, found \"]\""),
        ("[-]", "line 1, column 3: expected a digit, found \"]\""),
        ("[01]", "line 1, column 3: expected \",\" or \"]\", found \"1\""),
        (
            "[\"a\tb\"]",
            "line 1, column 4: expected the closing quote of a string, found the control character 9",
        ),
        (r#"["\x"]"#, "found \"x\""),
        (r#"["\ud800"]"#, "expected a second \\u escape"),
        (r#"["\udc00"]"#, "expected a \\u escape that is a character"),
        (r#"["\u12é4"]"#, "four hexadecimal digits"),
        (
            "[1e999]",
            "line 1, column 2: expected a number of at most 1.8e308 in size, found 1e999 (out of range)",
        ),
        (&deep, "line 1, column 102: expected at most 100 arrays and objects inside each other"),
    ] {
        let message = parse(text).unwrap_err().to_string();
        assert!(message.contains(wanted), "expected {wanted:?}, found {message:?}");
    }
}

#[test]
fn a_byte_order_mark_is_skipped() {
    assert_eq!(parse("\u{feff} [1]"), parse("[1]"));
    assert!(parse("[\u{feff}1]").is_err());
}

#[test]
fn an_outline_has_the_texts_of_the_outermost_fields_alone() {
    let text = r#"{"a": [{"kind": "x]}"}, "\"}"], "format": "b\n", "c": -1.5e3, "d": {"kind": []}}"#;
    let field = |name: &str, value| (name.to_owned(), value);
    let expected = [
        field("a", Value::Null),
        field("format", Value::text("b\n")),
        field("c", Value::Null),
        field("d", Value::Null),
    ];
    assert_eq!(outline(text).unwrap(), expected);
    for text in ["", "[]", "{\"a\": [1, 2", "{\"a\": {\"b\": \"", "{\"a\": 1]"] {
        assert!(outline(text).is_err(), "{text}");
    }
}

#[test]
fn numbers_are_written_with_the_fewest_digits() {
    let text = |v: f64| write(&Value::Number(v)).unwrap();
    let numbers = [0.0, -0.0, 3.0, 0.1, 1e-6, 1e16, -2.5e-300, f64::MAX, 5e-324];
    let expected = ["0", "-0", "3", "0.1", "1e-6", "1e16", "-2.5e-300", "1.7976931348623157e308", "5e-324"];
    for (number, expected) in numbers.into_iter().zip(expected) {
        assert_eq!(text(number), expected);
        assert_eq!(expected.parse::<f64>().unwrap().to_bits(), number.to_bits());
    }
    assert_eq!(write(&Value::Number(f64::INFINITY)), Err(NotFinite(f64::INFINITY)));
}

#[test]
fn a_matrix_has_rows_as_wide_as_the_first() {
    let error = crate::json::rows::matrix_from_rows(&[vec![1.0, 2.0], vec![3.0]]).unwrap_err();
    assert_eq!(error, "expected rows of 2 numbers, found 1 in row 1");
}

#[test]
fn values_at_the_limits_are_read() {
    let list = |count| Value::list(&vec![0.0; count], |v| Value::Number(*v));
    assert_eq!(Field::root(&list(100_000)).items().unwrap().len(), 100_000);
    assert!(Field::root(&list(100_001)).items().is_err());
    let field = Field::root(&Value::Null);
    assert!(checks::bounded(&field, &[1e12, -1e12]).is_ok() && checks::bounded(&field, &[-1.1e12]).is_err());
    assert!(checks::positive(&field, &[1e-12, 1e12]).is_ok() && checks::positive(&field, &[1e-13]).is_err());
}

#[test]
fn two_escapes_are_one_character_beyond_u_ffff() {
    assert_eq!(parse(r#""\ud834\udd1e \ud83d\uDE00""#), Ok(Value::text("𝄞 😀")));
    assert!(parse(r#""\ud834\n""#).is_err() && parse(r#""\ud834u0041""#).is_err());
}
