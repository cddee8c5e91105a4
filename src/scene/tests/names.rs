//! The names of bodies, which mean one each.

use super::{EXAMPLE, error};
use crate::scene::Scene;

/// A scene of a group of its own and of others, each with this `text` for its objects.
fn riders(own: &str, others: &[(&str, &str)]) -> String {
    let group = |(name, text): &(&str, &str)| format!("[[group]]\nname = \"{name}\"\n{text}");
    format!("name = \"x\"\nrider = \"bicycle\"\n{own}{}", others.iter().map(group).collect::<String>())
}

const CYCLIST: &str = "[[include]]\nscene = \"cyclist\"\n";
const CYCLIST_OF_GROUP: &str = "[[group.include]]\nscene = \"cyclist\"\n";

#[test]
fn a_body_that_there_is_not_is_told_by_those_most_like_it() {
    let street = Scene::preset("street").expect("a preset");
    let told = |name: &str| street.body_called(name).expect_err("there is none");
    assert!(told("fornt tire").contains("the nearest are front tyre, ") && told("fornt tire").len() < 300);
    assert_eq!(told("fornt tire").matches(", ").count(), 2);
    assert!(told("fornt tire").ends_with("`gamow --list --scene` with the scene lists all"));
    assert!(told(&"x".repeat(1_000_000)).len() < 400);
    let balls = Scene::parse(EXAMPLE, "balls.toml").expect("it is right");
    let of_balls = |name: &str| balls.body_called(name);
    let none = |name: &str| {
        Err(format!("Two balls has no body called `{name}`: there are ring 2, tube 1, sphere 0"))
    };
    assert_eq!([of_balls("x"), of_balls("3")], [none("x"), none("3")]);
    assert_eq!([of_balls("2"), of_balls("ring 2"), of_balls("Tube 1")], [Ok(2), Ok(2), Ok(1)]);
}

#[test]
fn two_riders_have_a_front_hub_each_and_a_name_that_both_have_is_refused_with_the_choices() {
    let text = riders(CYCLIST, &[("oncoming", CYCLIST_OF_GROUP)]);
    let scene = Scene::parse(&text, "x").expect("it is right");
    let hub = Scene::preset("cyclist").expect("a preset").body_called("front hub").expect("it has one");
    assert_eq!(scene.body_called("front hub (bicycle)"), Ok(hub));
    assert_eq!(scene.body_called("Front hub (oncoming)"), Ok(scene.groups[1].first + hub));
    assert_eq!(
        scene.body_called("front hub"),
        Err("`front hub` could be any of 2 bodies: write `front hub (bicycle)` or `front hub (oncoming)`"
            .to_owned())
    );
}

#[test]
fn riders_of_one_group_are_told_apart_by_number() {
    let scene = Scene::parse(&riders(&CYCLIST.repeat(2), &[]), "x").expect("it is right");
    let half = scene.bodies.len() / 2;
    let hub = scene.body_called("front hub (cyclist 1)").expect("there is one");
    assert_eq!(scene.body_called("front hub (cyclist 2)"), Ok(half + hub));
    // One name that only one body has stays as it is.
    let post = "[[object]]\nshape = \"sphere\"\ncentre = [0, 3, 0]\nradius = 1\nname = \"post\"\n";
    let scene = Scene::parse(&riders(&format!("{CYCLIST}{post}"), &[]), "x").expect("it is right");
    assert_eq!([scene.name_of(hub), scene.name_of(half)], ["front hub", "post"]);
}

#[test]
fn an_author_hears_of_two_bodies_of_one_name() {
    let ball = "shape = \"sphere\"\ncentre = [0, 3, 0]\nradius = 1\nname = \"ball\"\n";
    let refused = ": `ball` is the name of another body too: give each, or its group, a `name` of its own";
    let own = format!("[[object]]\n{ball}");
    let of_group = format!("[[group.object]]\n{ball}");
    for (text, line) in [
        (riders(&own.repeat(2), &[]), 8),
        (riders(&own, &[("a", &of_group.repeat(2))]), 15),
        // Of two groups of one name too.
        (riders("", &[("a", &of_group), ("a", &of_group)]), 12),
    ] {
        assert_eq!(error(&text), format!("balls.toml:{line}{refused}"), "{text}");
    }
    for (count, is_refused) in [(1, false), (2, true)] {
        let wheel = "[[wheel]]\nhub = [0, 4, -2]\nradius = 0.5\ntyre = 0.03\nrim = 0.01\naxle = 0.1\nhub_radius = 0.02\n\
            spokes = 2\nspoke_radius = 0.01\n";
        assert_eq!(Scene::parse(&riders(&wheel.repeat(count), &[]), "x").is_err(), is_refused);
    }
}
