//! What is no path data, and where.

use aquatint::{
    SvgError, SvgPath,
    SvgProblem::{self, FlagExpected, MoveExpected, NumberExpected, OutOfRange, UnexpectedCharacter},
};
use proptest::{collection::vec, prelude::*, sample::select};

use super::{coarse, fine, path};

const WRONG: [(&str, usize, SvgProblem); 44] = [
    ("L 1 1", 0, MoveExpected),
    (" 1 1", 1, MoveExpected),
    ("\n,M 1 1", 1, MoveExpected),
    ("ä", 0, MoveExpected),
    ("z", 0, MoveExpected),
    ("M", 1, NumberExpected),
    ("M ", 2, NumberExpected),
    ("M,1 1", 1, NumberExpected),
    ("M 1", 3, NumberExpected),
    ("M 1,", 4, NumberExpected),
    ("M 1,,1", 4, NumberExpected),
    ("M 1 L 1", 4, NumberExpected),
    ("M 1 1,", 6, NumberExpected),
    ("M 1 1, L 2 2", 7, NumberExpected),
    ("M 1 1 2", 7, NumberExpected),
    ("M 1 1.", 6, NumberExpected),
    ("M 1 1.L2 2", 6, NumberExpected),
    ("M 1 - 1", 5, NumberExpected),
    ("M 1 +", 5, NumberExpected),
    ("M 1 1e", 6, NumberExpected),
    ("M 1 1em", 6, NumberExpected),
    ("M 1 1e-", 7, NumberExpected),
    ("M 1 --1", 5, NumberExpected),
    ("M 1 1 x", 6, UnexpectedCharacter),
    ("M 1 1 ü", 6, UnexpectedCharacter),
    ("M 1 1\u{a0}2 2", 5, UnexpectedCharacter),
    ("M 1 1 z 1", 8, UnexpectedCharacter),
    ("M 1 1 z, L 1 1", 7, UnexpectedCharacter),
    ("M 1 1 zB", 7, UnexpectedCharacter),
    ("M 1 1 h", 7, NumberExpected),
    ("M 1 1 v ,", 8, NumberExpected),
    ("M 1 1 c 1 1 1 1 1", 17, NumberExpected),
    ("M 1 1 c 1 1 1 1 1z", 17, NumberExpected),
    ("M 1 1 t 1 1 1z", 13, NumberExpected),
    ("M 1 1 a 1 1 0 2 0 3 3", 14, FlagExpected),
    ("M 1 1 a 1 1 0 1 -0 3 3", 16, FlagExpected),
    ("M 1 1 a 1 1 0", 13, FlagExpected),
    ("M 1 1 a 1 1 0 1 1", 17, NumberExpected),
    ("M 32768 1", 2, OutOfRange),
    ("M 1 -1e9", 4, OutOfRange),
    ("m 30000 0 l 1 1 9999.5 30000", 16, OutOfRange),
    ("m -30000 0 h -3000", 13, OutOfRange),
    ("M 0 0 Q 0 -30000 0 20000 T 1 1", 27, OutOfRange),
    ("M 0 0 v 40000", 8, OutOfRange),
];

#[test]
fn what_is_wrong_is_said_with_its_place() {
    for (data, offset, problem) in WRONG {
        assert_eq!(SvgPath::new(data), Err(SvgError { offset, problem }), "{data}");
    }
    let error = SvgPath::new("M 1 1 a 1 1 0 2 0 3 3").expect_err("no flag");
    assert_eq!(error.to_string(), "a flag, 0 or 1, is missing at byte 14");
}

#[test]
fn an_error_stops_the_compiler() {
    const { assert!(SvgPath::new("M 1 1 L 2").is_err() && SvgPath::new("M 1 1 a1 1 0 01.5.5z").is_ok()) };
}

#[test]
fn empty_paths_are_paths() {
    for data in ["", " \t\r\n\u{c}", "M1 1", "M1 1m2 2zzM3 3"] {
        assert!(coarse(&path(data)).contours.is_empty() && fine(&path(data)).contours.is_empty(), "{data}");
    }
}

/// Pieces of path data, in any order.
fn pieces() -> impl Strategy<Value = String> {
    let piece = select(vec![
        "M", "m", "L", "l", "H", "h", "V", "v", "C", "c", "S", "s", "Q", "q", "T", "t", "A", "a", "Z", "z", " ", ",",
        "-", "+", ".", "e", "E", "\n", "0", "1", "7", "32767", "-.5", ".25", "1e1", "1e-3", "é", "x",
    ]);
    vec(piece, 0..40).prop_map(|pieces| "M1 1".to_owned() + &pieces.concat())
}

/// Arguments of any number for any command.
fn hostile() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        4 => select(vec!["0", "1", "-1", "32767.99999", "-32767.99999", "0.00002", "-0.00002", ".5"]).prop_map(str::to_owned),
        3 => (-32_767.0..32_767.0_f64).prop_map(|number| number.to_string()),
        1 => (-1.0..1.0_f64).prop_map(|number| number.to_string()),
    ];
    let arc = (vec(number.clone(), 3), select(vec!["0 0", "0 1", "1 0", "1 1"]), vec(number.clone(), 2))
        .prop_map(|(start, flags, to)| format!("A{} {flags} {}", start.join(" "), to.join(" ")));
    let other = |letter, count: usize| vec(number.clone(), count).prop_map(move |n| format!("{letter}{}", n.join(" ")));
    let command = prop_oneof![
        arc,
        other("L", 2),
        other("C", 6),
        other("Q", 4),
        other("T", 2),
        other("S", 4),
        Just("z".to_owned())
    ];
    vec(command, 0..6).prop_map(|commands| "M0 0".to_owned() + &commands.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn no_text_panics(data in prop_oneof![pieces(), hostile(), any::<String>()], scale in prop_oneof![any::<i32>(), -100_000..100_000]) {
        match SvgPath::new(&data) {
            Ok(path) => {
                let path = path.scaled(aquatint::Scalar::from_bits(scale));
                let (coarse, fine) = (coarse(&path), fine(&path));
                prop_assert_eq!((coarse.contours.len(), coarse.closed), (fine.contours.len(), fine.closed));
            }
            Err(error) => prop_assert!(data.is_char_boundary(error.offset)),
        }
    }
}
