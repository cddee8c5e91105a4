//! The names of the models and the curves in flags and files.
#![cfg(all(feature = "clap", feature = "serde"))]

use clap::ValueEnum;
use relativity_core::{Curves, Model};
use serde::Deserialize;
use serde::de::IntoDeserializer as _;
use serde::de::value::Error;

fn read<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Error> {
    T::deserialize(text.into_deserializer())
}

#[test]
fn a_name_is_the_flags_value_and_the_files() {
    for model in Model::ALL {
        assert_eq!(Model::from_str(model.name(), false), Ok(model));
        assert_eq!(read(model.name()), Ok(model));
    }
    for &curves in Curves::value_variants() {
        assert_eq!(Curves::from_str(curves.name(), false), Ok(curves));
        assert_eq!(read(curves.name()), Ok(curves));
    }
}
