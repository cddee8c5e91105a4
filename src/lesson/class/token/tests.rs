//! A token gives the answers back, or is refused.

use proptest::prelude::*;

use super::*;

fn given(outcome: Option<Outcome>, observed: Option<usize>) -> StepAnswers {
    StepAnswers { asked: 0xa5c3, record: Record { outcome, observed } }
}

fn answer() -> impl Strategy<Value = Answer> {
    let number = -1e300..1e300_f64;
    prop_oneof![
        (0..30_usize).prop_map(Answer::Choice),
        prop::collection::vec(any::<u32>(), 0..8).prop_map(Answer::Votes),
        number.clone().prop_map(Answer::Number),
        [number.clone(), number]
            .prop_map(|[azimuth, elevation]| Answer::Direction(Gaze { azimuth, elevation })),
    ]
}

fn step() -> impl Strategy<Value = Option<StepAnswers>> {
    let confidence = prop::option::of(prop::sample::select(Confidence::ALL.to_vec()));
    let made = (answer(), confidence).prop_map(|(answer, confidence)| Outcome::Made { answer, confidence });
    let outcome = prop_oneof![Just(None), Just(Some(Outcome::Skipped)), made.prop_map(Some)];
    let record = (outcome, prop::option::of(0..20_usize), any::<u16>());
    prop::option::of(
        record.prop_map(|(outcome, observed, asked)| StepAnswers {
            asked,
            record: Record { outcome, observed },
        }),
    )
}

fn pupil() -> impl Strategy<Value = PupilAnswers> {
    let name = any::<String>().prop_map(|name| pupils_name(&name));
    ("[a-z-]{0,30}", name, prop::collection::vec(step(), 0..12))
        .prop_map(|(lesson, name, steps)| PupilAnswers { lesson, name, steps })
}

proptest! {
    #[test]
    fn what_is_written_is_read_again(pupil in pupil()) {
        let token = pupil.token();
        prop_assert!(token.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_'));
        prop_assert_eq!(PupilAnswers::from_token(&token), Ok(pupil));
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[A-Za-z0-9_-]{0,200}") {
        let _ = PupilAnswers::from_token(&text);
    }

    /// Behind a right checksum, any bytes: what somebody could make on purpose.
    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = PupilAnswers::from_token(&sealed(&bytes));
    }
}

/// The token of these bytes behind the version.
fn sealed(bytes: &[u8]) -> String {
    let mut all = vec![VERSION];
    all.extend(bytes);
    let sum = crc32fast::hash(&all);
    all.extend(sum.to_le_bytes());
    BASE64_URL_SAFE_NO_PAD.encode(all)
}

fn one() -> PupilAnswers {
    let made = |answer| Some(Outcome::Made { answer, confidence: Some(Confidence::Sure) });
    let steps = vec![
        Some(given(made(Answer::Choice(2)), Some(0))),
        None,
        Some(given(made(Answer::Number(2.5)), None)),
        Some(given(Some(Outcome::Skipped), Some(1))),
    ];
    PupilAnswers { lesson: "rods".to_owned(), name: "Ada".to_owned(), steps }
}

#[test]
fn every_letter_that_is_changed_and_every_cut_is_noticed() {
    let token = one().token();
    for place in 0..token.len() {
        let letters: Vec<char> = token.chars().collect();
        for other in "AZaz09-_".chars().filter(|other| *other != letters[place]) {
            let mut changed = letters.clone();
            changed[place] = other;
            let changed: String = changed.into_iter().collect();
            assert_eq!(PupilAnswers::from_token(&changed), Err(TokenError::Damaged), "{place} {other}");
        }
        assert_eq!(PupilAnswers::from_token(&token[..place]), Err(TokenError::Damaged), "{place}");
    }
    assert_eq!(PupilAnswers::from_token(&format!("{token}A")), Err(TokenError::Damaged));
}

#[test]
fn another_version_and_a_text_without_end_are_named() {
    let mut bytes = BASE64_URL_SAFE_NO_PAD.decode(one().token()).expect("it is base64");
    bytes.truncate(bytes.len() - SUM);
    bytes[0] = VERSION + 1;
    let sum = crc32fast::hash(&bytes);
    bytes.extend(sum.to_le_bytes());
    let newer = BASE64_URL_SAFE_NO_PAD.encode(bytes);
    assert_eq!(PupilAnswers::from_token(&newer), Err(TokenError::OtherVersion));
    assert_eq!(PupilAnswers::from_token(&"A".repeat(MOST_LETTERS + 1)), Err(TokenError::TooLong));
}

/// Lists that claim more than they hold, numbers that are none, letters behind the end.
#[test]
fn a_text_made_to_harm_is_refused() {
    let huge = [0xff, 0xff, 0xff, 0xff, 0x7f];
    let claims = [&[0, 0][..], &huge].concat();
    assert_eq!(PupilAnswers::from_token(&sealed(&claims)), Err(TokenError::Damaged));
    let votes = [&[0, 0, 1, 1, 0, 0, 3][..], &huge].concat();
    assert_eq!(PupilAnswers::from_token(&sealed(&votes)), Err(TokenError::Damaged));
    let none = [&[0, 0, 1, 1, 0, 0, 4][..], &f64::NAN.to_le_bytes(), &[0, 0]].concat();
    assert_eq!(PupilAnswers::from_token(&sealed(&none)), Err(TokenError::Damaged));
    let number = [&[0, 0, 1, 1, 0, 0, 4][..], &2.0_f64.to_le_bytes(), &[0, 0]].concat();
    assert!(PupilAnswers::from_token(&sealed(&number)).is_ok());
    let behind = [&number[..], &[0]].concat();
    assert_eq!(PupilAnswers::from_token(&sealed(&behind)), Err(TokenError::Damaged));
}

#[test]
fn a_name_is_one_short_line() {
    assert_eq!(pupils_name("  Ada\n\tLovelace\u{7} "), "Ada Lovelace");
    assert_eq!(pupils_name(&"ab ".repeat(1000)).chars().count(), 40);
    assert_eq!(pupils_name("\u{7}"), "");
}
