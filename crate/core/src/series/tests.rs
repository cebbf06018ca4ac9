use super::*;

fn refusal(text: &str) -> String {
    read("trial.csv", text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn a_table_is_read_with_names_values_and_frame_time() {
    let text = "\u{feff}frame,Time,\"left, knee\",hip\r\n0,1.0,2,-3e-1\r\n1,1.25,4,0\r\n2,1.5,6,.5\r\n\r\n";
    let table = read("trial.csv", text.as_bytes()).unwrap();
    assert_eq!(table.columns, ["left, knee", "hip"]);
    assert_eq!(table.values.shape(), (3, 2));
    assert_eq!((table.values[(1, 0)], table.values[(0, 1)], table.frame_time), (4.0, -0.3, Some(0.25)));
    assert_eq!(table.sha256.len(), 64);
    let german = read("trial.csv", b"x;y\n1;2\n3;4\n").unwrap();
    assert_eq!((german.columns.join(" "), german.frame_time), ("x y".to_owned(), None));
}

#[test]
fn a_written_table_is_read_as_the_same_table() {
    let names = ["left, knee".to_owned(), "say \"x\"".to_owned()];
    let values = nalgebra::DMatrix::from_fn(4, 2, |i, j| 0.1 * i as f64 - j as f64 / 3.0);
    let table = read("again.csv", write(&names, &values, 0.25).as_bytes()).unwrap();
    assert_eq!((&table.columns[..], table.values, table.frame_time), (&names[..], values, Some(0.25)));
    for name in ["=1+1", "＝1+1", "-1", "\n=1"] {
        let text = write(&[name.to_owned()], &nalgebra::DMatrix::zeros(1, 1), 0.1);
        assert!(text.contains(&format!("'{name}")), "{text:?}");
    }
}

#[test]
fn columns_can_be_left_out_by_name() {
    let table =
        read("trial.csv", b"time,hand.x,hand.visibility,foot.x,foot.visibility\n0,1,2,3,4\n1,5,6,7,8\n");
    let table = table.unwrap();
    let left = table.without(&["*.visibility"]).unwrap();
    assert_eq!(left.columns, ["hand.x", "foot.x"]);
    assert_eq!(left.values, nalgebra::dmatrix![1.0, 3.0; 5.0, 7.0]);
    assert_eq!((&left.sha256, left.frame_time), (&table.sha256, Some(1.0)));
    assert_eq!(table.without(&["hand.x", "foot*"]).unwrap().columns, ["hand.visibility"]);
    assert_eq!(table.without(&[]).unwrap(), table);
    let refusal = |names: &[&str]| table.without(names).unwrap_err().to_string();
    let found = refusal(&["hand.x", "head"]);
    assert!(found.starts_with("trial.csv: expected some of the columns hand.x, "), "{found}");
    assert!(found.ends_with(" to leave out, found \"head\""), "{found}");
    assert_eq!(refusal(&["*"]), "trial.csv: expected at least one column that is not left out, found none");
}

/// A table whose first column has this name and goes from `start` by `step` in each of 12 rows.
fn with_first(name: &str, start: f64, step: f64) -> Table {
    let row = |k: usize| format!("{},{}\n", start + step * k as f64, (k * k) % 7);
    read("t.csv", (format!("{name},x\n") + &(0..12).map(row).collect::<String>()).as_bytes()).unwrap()
}

#[test]
fn clocks_of_other_programs_are_found_by_their_names() {
    for (name, start, step, seconds) in [
        ("Time (Seconds)", 0.0, 0.01, 0.01),
        ("timestamp", 1.7e9, 0.03125, 0.03125),
        ("time", 1.7e12, 31.25, 0.03125),
        ("%time", 1_700_000_000_000_000_000.0, 31_250_048.0, 0.031250048),
        ("header.stamp", 1.7e9, 0.03125, 0.03125),
        ("time_ms", 0.0, 20.0, 0.02),
        ("elapsedMs", 5.0, 20.0, 0.02),
        ("t [s]", 0.0, 0.02, 0.02),
        ("Zeit (µs)", 0.0, 20_000.0, 0.02),
    ] {
        let table = with_first(name, start, step);
        let found = table.frame_time.unwrap();
        assert!((found / seconds - 1.0).abs() < 1e-6, "{name}: {found}");
        assert_eq!((table.columns.join(" "), table.warnings.len()), ("x".to_owned(), 0), "{name}");
    }
    // Whole milliseconds of 120 rows a second.
    let rounded = (0..40).map(|k| format!("{},{}\n", (k as f64 / 0.12).round(), k % 3)).collect::<String>();
    let table = read("t.csv", format!("time_ms,x\n{rounded}").as_bytes()).unwrap();
    assert!((table.frame_time.unwrap() - 1.0 / 120.0).abs() < 1e-4);
    // A column of another quantity stays.
    assert_eq!(with_first("time", 0.0, 0.1).columns, ["x"]);
    assert_eq!(read("t.csv", b"elapsed,x\n3,1\n2,5\n4,6\n").unwrap().columns, ["elapsed", "x"]);
}

#[test]
fn columns_that_count_rows_are_left_out() {
    for name in ["Frame#", "frame_number", "FrameNo", "index", "Unnamed: 0", ""] {
        let table = with_first(name, 1.0, 1.0);
        assert_eq!((table.columns.len(), table.frame_time), (1, None), "{name}");
        // The rate is not known; only the index of pandas means nothing.
        let says = table.warnings.iter().any(|warning| warning.contains("no column holds times"));
        assert_eq!((says, table.warnings.len() < 2), (!name.is_empty(), true), "{name}");
    }
    assert_eq!(with_first("frame error", 1.0, 1.0).columns, ["frame error", "x"]);
    assert_eq!(read("t.csv", b",x,\n0,3,\n1,5,\n").unwrap().columns, ["x"]);
    let jump = read("t.csv", b"Frame#,x\n1,3\n2,5\n9,4\n").unwrap();
    let warning = "line 4: the column \"Frame#\" goes from 2 to 9, not to 3: rows are missing there";
    assert!(jump.warnings[0].starts_with(warning), "{:?}", jump.warnings);
    assert_eq!(read("t.csv", b"sample,x\n2,3\n1,5\n").unwrap().columns, ["sample", "x"]);
}

#[test]
fn doubtful_times_are_named() {
    let milliseconds = with_first("t", 0.0, 8.0);
    let taken =
        "the column \"t\" is taken for seconds, so a row lasts 8 s: name the column after what it holds";
    assert!(milliseconds.warnings[0].starts_with(taken));
    assert!(with_first("time", 0.0, 1.0).warnings[0].contains("taken for seconds, so a row lasts 1 s"));
    assert!(
        with_first("time_ms", 0.0, 0.03).warnings[0]
            .contains("taken for milliseconds, so a row lasts 0.00003 s")
    );
    let unknown = with_first("Bildzeit", 0.0, 0.04);
    assert_eq!((unknown.columns.len(), unknown.frame_time), (2, None));
    assert_eq!(with_first("s_ms", 0.0, 0.04).frame_time, None, "two units");
    assert!(unknown.warnings[0].starts_with("the column \"Bildzeit\" grows by 0.04 in each row"));
    assert!(with_first("x0", 0.0, -1.0).warnings.is_empty());
    // In few rows, equal steps may be chance.
    let grows = |rows: usize| {
        let text: String = (0..rows).map(|row| format!("{row},{}\n", row * row)).collect();
        read("trial.csv", format!("height,y\n{text}").as_bytes()).unwrap().warnings.len()
    };
    assert_eq!([9, 10].map(grows), [0, 1]);
    let seconds = read("trial.csv", b"sec,nanosec,y\n7,500,1\n7,900,2\n8,300,3\n").unwrap();
    assert!(seconds.warnings[0].starts_with("the column \"sec\" has the name of a clock, but does not grow"));
}

#[test]
fn some_names_of_columns_may_be_numbers() {
    assert_eq!(read("t.csv", b"x,2\n1,5\n3,4\n").unwrap().columns, ["x", "2"]);
    assert!(refusal("1,2\n1,5\n3,4\n").contains("found numbers"));
}

#[test]
fn german_tables_have_decimal_commas() {
    let table = read("t.csv", b"Zeit;x;y\n0,0;1,5;2\n0,1;-2,5;3\n0,2;0;1\n").unwrap();
    assert_eq!((table.values[(1, 0)], table.frame_time), (-2.5, Some(0.1)));
    let tabs = read("t.tsv", b"t\t\"a, b\"\tc\n0\t1,5\t2\n0,5\t1\t3\n").unwrap();
    assert_eq!((tabs.columns.join("|"), tabs.values[(0, 0)]), ("a, b|c".to_owned(), 1.5));
}

#[test]
fn errors_name_file_line_and_column() {
    assert_eq!(
        refusal("x,knee\n1,2\n3,n/a\n"),
        "trial.csv, line 3, column 2 (knee): expected a number, found \"n/a\""
    );
    for (text, expected) in [
        ("", "line 1: expected a row with the names of the columns, found nothing"),
        ("1,2\n3,4\n", "line 1: expected a row with the names of the columns, found numbers"),
        ("x,x\n1,2\n3,4\n", "line 1: expected a name of its own for column 2, found \"x\", as column 1 has"),
        ("x,\n1,2\n3,4\n", "line 1: expected a name for column 2, found none"),
        ("x,y\n1,2\n3\n", "line 3: expected 2 fields, as in the first row, found 1"),
        ("x,y\n1,2\n", "line 2: expected at least two rows of numbers, found 1"),
        ("x,y\n1,\n3,4\n", "line 2, column 2 (y): expected a number (fill gaps before), found \"\""),
        ("x,y\n\"1,5\",2\n3,4\n", "line 2, column 1 (x): expected a number with a point, such as 1.5, found"),
        ("x;y\n1,5;2\n1.234;4\n", "line 3, column 1 (x): expected a number with a comma, as others"),
        ("x\n1 2\n", "line 2, column 1 (x): expected a number (commas, semicolons or tabs"),
        ("at,x\n12:01:05,2\n", "line 2, column 1 (at): expected a number (times as seconds"),
        (
            "NO_OF_FRAMES\t2\nMARKER_NAMES\ta\n",
            "line 1: expected a row with the names of the columns, found a table of Q",
        ),
        (
            "Coordinates\nnRows=2\nendheader\ntime\tx\n0\t1\n",
            "line 1: expected a row with the names of the columns, found a .mot",
        ),
        (
            "t,y\n0,1\n33,2\n66,3\n",
            "line 4, column 1 (t): expected seconds that grow by 0.00001 to 10 a row, not by 33",
        ),
        ("x,y\n1,inf\n3,4\n", "line 2, column 2 (y): expected a number from -1e9 to 1e9, found \"inf\""),
        ("time,y\n0,1\n1,2\n3,3\n4,4\n", "line 4, column 1 (time): expected seconds that grow by as much"),
        ("time,y\n3,1\n2,2\n1,3\n", "line 4, column 1 (time): expected seconds that grow by"),
        (
            "time,y\n\n0,1\n1,2\n\n3,3\n4,4\n",
            "line 6, column 1 (time): expected seconds that grow by as much",
        ),
        ("time\n0\n1\n", "line 1: expected a column of numbers other than times"),
        ("x,\"y\n1,2\n", "line 1: expected a closing quote"),
    ] {
        assert!(refusal(text).starts_with(&format!("trial.csv, {expected}")), "{}", refusal(text));
    }
    assert!(read("trial.csv", b"\xffx,y").unwrap_err().to_string().contains("UTF-8 or UTF-16"));
}

#[test]
fn numbers_of_other_programs_follow_the_rules_for_files() {
    let values = nalgebra::DMatrix::from_row_slice(3, 2, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let checked = |names: [&str; 2], values: &nalgebra::DMatrix<f64>| {
        Table::checked("trial 0", names.map(str::to_owned).to_vec(), values.clone(), 0.5)
    };
    let table = checked(["x", "y"], &values).unwrap();
    assert_eq!(table, read("trial 0", write(&table.columns, &values, 0.5).as_bytes()).unwrap());
    let refusal = |names, values: &_| checked(names, values).unwrap_err().to_string();
    let mut gap = values.clone();
    gap[(1, 1)] = f64::NAN;
    let expected = "trial 0: row 1, column 1 (y): expected a number from -1e9 to 1e9, found NaN";
    assert_eq!(refusal(["x", "y"], &gap), expected);
    let expected = "trial 0: expected a name of its own for column 2, found \"x\", as column 1 has";
    assert_eq!(refusal(["x", "x"], &values), expected);
    assert!(checked(["x", "y"], &values.rows(0, 2).into_owned()).is_ok());
    let one = values.rows(0, 1).into_owned();
    assert_eq!(refusal(["x", "y"], &one), "trial 0: expected at least two rows of numbers, found 1");
    let narrow = values.columns(0, 1).into_owned();
    let expected = "trial 0: expected one name for each column, found 2 for 1";
    assert_eq!(refusal(["x", "y"], &narrow), expected);
}

#[test]
fn columns_are_put_into_the_order_of_the_first_table() {
    let first = read("a.csv", b"x,y\n1,2\n3,4\n").unwrap();
    let turned = read("b.csv", b"y,x\n2,1\n4,3\n").unwrap().like(&first).unwrap();
    assert_eq!((turned.values, turned.columns), (first.values.clone(), first.columns.clone()));
    let refusal = |text: &str| read("b.csv", text.as_bytes()).unwrap().like(&first).unwrap_err().to_string();
    assert!(
        refusal("x,z\n1,2\n3,4\n")
            .contains("b.csv cannot be trained together with a.csv: expected a column \"y\"")
    );
    assert!(refusal("x,y,z\n1,2,3\n3,4,5\n").contains("expected no column \"z\""));
    assert!(refusal("t,x,y\n0,2,3\n1,4,5\n").contains("expected no column of times, found rows 1 s apart"));
}

#[test]
fn parts_are_named_by_their_columns() {
    let columns = ["arm_x", "arm_y", "leg"].map(str::to_owned);
    let parts = parse_parts("arm=arm_*;leg=leg", &columns).unwrap();
    assert_eq!((&parts[0].joints[..], &parts[1].joints[..]), (&[0, 1][..], &[2][..]));
    let json = r#"[{"name": "arm", "columns": ["arm_x", "arm_y"]}, {"name": "leg", "columns": ["leg"]}]"#;
    assert_eq!(parts_from_json(json, &columns).unwrap(), parts);
    for (split, expected) in [
        ("arm", "expected parts such as"),
        ("arm=hip;leg=leg", "part \"arm\": expected some of the columns arm_x, arm_y, leg, found \"hip\""),
        ("arm=arm_x;leg=leg", "found no part for arm_y"),
        ("arm=arm_*,leg;leg=leg", "found leg more than once"),
        ("a=arm_*;a=leg", "part 2: expected a name of its own"),
        ("", "expected at least one part"),
    ] {
        let error = parse_parts(split, &columns).unwrap_err().to_string();
        assert!(error.contains(expected), "{split}: {error}");
    }
}

#[test]
fn files_with_returns_alone_and_files_in_utf_16_are_read() {
    let text = "time\tx\tö\n0\t1\t2\n1\t3\t4\n";
    let expected = read("trial.csv", text.as_bytes()).unwrap();
    let little = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let big = |text: &str| text.encode_utf16().flat_map(u16::to_be_bytes).collect::<Vec<u8>>();
    let marked = format!("\u{feff}{text}");
    for bytes in [
        text.replace('\n', "\r").into_bytes(),
        text.replace('\n', "\r\n").into_bytes(),
        little(text),
        big(text),
        little(&marked),
        big(&marked),
    ] {
        let table = read("trial.csv", &bytes).unwrap();
        assert_eq!((&table.columns, &table.values), (&expected.columns, &expected.values));
    }
    // Each kind of line end counts one line, in blank lines and in quoted names as well.
    for end in ["\r", "\n", "\r\n"] {
        let text = "x,\"y\nz\"\n\n1,2\n\n\n3,n/a\n".replace('\n', end);
        assert!(refusal(&text).starts_with("trial.csv, line 7, column 2"), "{}", refusal(&text));
    }
}

#[test]
fn blanks_around_quoted_fields_do_not_matter() {
    let table = read("trial.csv", b"\"x\", \"y\" , z\n1, 2, \"3\"\n4 ,5, 6\n").unwrap();
    assert_eq!(table.columns, ["x", "y", "z"]);
    assert_eq!(table.values.row(0).iter().copied().collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
}

proptest::proptest! {
    #[test]
    fn no_text_crashes_the_reader(text in "[a1,\"\r\n ;\t]{0,40}") {
        let _ = read("trial.csv", text.as_bytes());
    }
}
