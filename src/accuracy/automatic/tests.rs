//! The choice, by tables that are made up.

use proptest::prelude::*;
use relativity_core::Speed;
use relativity_render::{Body, RawModel};

use super::best::GAIN;
use super::*;
use crate::accuracy::{TrackedPlace, view_at};
use crate::scene::Scene;

fn offer(method: Method, error_px: f64, ms: f64) -> Offer {
    Offer { method, error_px, ms }
}

fn methods() -> impl Strategy<Value = Vec<Offer>> {
    let all = [Method::Reference, Method::Rays, Method::Packets, Method::Mesh];
    let numbers = (0..5usize, 0..5usize).prop_map(|(error, ms)| {
        // Few values, so that there are ties.
        ([0.0, 0.002, 0.05, 0.5, f64::INFINITY][error], [1.0, 4.0, 5.0, 16.0, 100.0][ms])
    });
    proptest::collection::vec(numbers, 4).prop_map(move |numbers| {
        all.into_iter().zip(numbers).map(|(method, (error_px, ms))| offer(method, error_px, ms)).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    /// The choice does not depend on the method before.
    #[test]
    fn an_error_is_never_exceeded_where_something_keeps_it(
        offers in methods(), px in prop_oneof![Just(0.001), Just(0.002), Just(0.1), Just(1.0)],
        kept in proptest::option::of(0..4usize),
    ) {
        let kept = kept.map(|kept| offers[kept].method);
        let found = best(Goal::Error(px), &offers, kept).expect("there are some");
        let keeps = |offer: &&Offer| offer.error_px <= px;
        let cheapest = offers.iter().filter(keeps).map(|offer| offer.ms).fold(f64::INFINITY, f64::min);
        if cheapest.is_finite() {
            prop_assert!(found.error_px <= px);
            prop_assert!(GAIN * found.ms < cheapest || found.ms == cheapest);
            let is_tie = |offer: &&Offer| offer.ms == found.ms && offer.error_px < found.error_px;
            prop_assert!(Some(found.method) == kept || !offers.iter().any(|offer| is_tie(&offer)));
        } else {
            prop_assert!(offers.iter().all(|offer| found.error_px <= offer.error_px));
        }
    }

    #[test]
    fn a_budget_is_kept_where_something_keeps_it(
        offers in methods(), ms in prop_oneof![Just(0.5), Just(5.0), Just(20.0), Just(1000.0)],
        kept in proptest::option::of(0..4usize),
    ) {
        let kept = kept.map(|kept| offers[kept].method);
        let found = best(Goal::Budget(ms), &offers, kept).expect("there are some");
        let cheapest = offers.iter().map(|offer| offer.ms).fold(f64::INFINITY, f64::min);
        if cheapest <= GAIN * ms {
            prop_assert!(found.ms <= ms);
            let is_better = |offer: &Offer| offer.ms <= GAIN * ms && offer.error_px < found.error_px;
            prop_assert!(!offers.iter().any(is_better));
        } else if cheapest > ms {
            prop_assert!(GAIN * found.ms < cheapest || found.ms == cheapest);
        }
    }

    /// Costs that go up and down by a tenth about the same change nothing once something draws.
    #[test]
    fn nothing_flaps(
        offers in methods(), jitter in proptest::collection::vec(proptest::collection::vec(0.9..1.1, 4), 20),
        is_budget in any::<bool>(),
    ) {
        let goal = if is_budget { Goal::Budget(10.0) } else { Goal::Error(0.1) };
        let mut kept = None;
        let mut switches = 0;
        for factors in jitter {
            let measured: Vec<_> =
                offers.iter().zip(factors).map(|(offer, by)| Offer { ms: offer.ms * by, ..*offer }).collect();
            let found = best(goal, &measured, kept).expect("there are some").method;
            switches += usize::from(kept.is_some_and(|kept| kept != found));
            kept = Some(found);
        }
        // At first what is a little slower may have drawn.
        prop_assert!(switches <= 1, "{switches} switches");
    }
}

#[test]
fn ties_go_to_the_more_exact() {
    let offers = [offer(Method::Rays, 0.002, 5.0), offer(Method::Reference, 0.0, 5.0)];
    for goal in [Goal::Error(0.1), Goal::Budget(5.0), Goal::Budget(1.0)] {
        assert_eq!(best(goal, &offers, None).map(|offer| offer.method), Some(Method::Reference), "{goal:?}");
    }
    assert_eq!(best(Goal::Error(1.0), &[], None), None);
}

#[test]
fn a_budget_has_the_most_accurate_that_keeps_it() {
    let offers = [
        offer(Method::Reference, 0.0, 60.0),
        offer(Method::Rays, 0.002, 17.0),
        offer(Method::Packets, 0.002, 10.0),
        offer(Method::Mesh, 2.0, 3.0),
    ];
    let at = |ms| best(Goal::Budget(ms), &offers, None).map(|offer| offer.method);
    assert_eq!(at(100.0), Some(Method::Reference));
    assert_eq!(at(20.0), Some(Method::Packets));
    assert_eq!(at(5.0), Some(Method::Mesh));
    assert_eq!(at(1.0), Some(Method::Mesh));
    // What draws gives way to what is more accurate only where that has room to spare.
    let kept = |ms| best(Goal::Budget(ms), &offers, Some(Method::Packets)).map(|offer| offer.method);
    assert_eq!([kept(61.0), kept(80.0)], [Some(Method::Packets), Some(Method::Reference)]);
}

#[test]
fn one_hiccup_does_not_count() {
    let mut costs = Costs::new(Machine::Gpu, 2);
    let mut now_ms = 0.0;
    let pixels = 2e6;
    let mut draw = |ms: f64| {
        now_ms += 20.0;
        costs.note(Method::Rays, Geometry::Seen, Some((ms, pixels)), now_ms);
        costs.measured_ms(Method::Rays, Geometry::Seen, pixels).expect("it was measured")
    };
    assert_eq!([4.0, 4.0, 400.0, 4.0].map(&mut draw)[3], 4.0);
    // What stays is learnt.
    assert_eq!([8.0, 8.0, 8.0, 8.0].map(&mut draw)[3], 8.0);
    assert_eq!(costs.measured_ms(Method::Rays, Geometry::Seen, 1e6), Some(4.0));
    assert_eq!(costs.measured_ms(Method::Rays, Geometry::Rest, 1e6), None);
}

#[test]
fn the_first_drawing_is_not_measured_nor_each_of_the_others() {
    let (mut costs, rays) = (Costs::new(Machine::Gpu, 2), Method::Rays);
    assert!(!costs.is_due(rays, Geometry::Seen, 0.0));
    costs.note(rays, Geometry::Seen, None, 0.0);
    let mut measured = 0;
    for frame in 0..1000 {
        let now_ms = f64::from(frame) * 20.0;
        if costs.is_due(rays, Geometry::Seen, now_ms) {
            costs.note(rays, Geometry::Seen, Some((2.0, 1e6)), now_ms);
            measured += 1;
        }
    }
    assert!((40..=45).contains(&measured), "{measured} in 20 s");
}

/// The start view, and the view of it.
fn start(gamma: f64) -> (PreparedScene, View) {
    let scene = Scene::preset("street").expect("a preset");
    let speed = Speed::from_gamma(gamma).expect("a speed");
    let view =
        view_at(TrackedPlace::Abreast, speed, scene.tracked, 0.1, 1.0, [480, 540]).expect("in the domain");
    (scene.prepared(), view)
}

#[test]
fn before_anything_is_measured_the_machine_decides() {
    let (scene, view) = start(2.0);
    let sight = MethodViews { scene: &scene, view: &view, pixels: 518_400.0 };
    for (machine, method) in [
        (Machine::Gpu, Method::Rays),
        (Machine::SoftwareGpu, Method::Packets),
        (Machine::Cpu, Method::Packets),
    ] {
        let choice = Automatic::new(machine).choose(Goal::default(), sight).expect("something draws");
        assert_eq!((choice.method, choice.is_measured, choice.holds), (method, false, true), "{machine:?}");
        assert!(choice.to_string().ends_with(", within 0.002 px"), "{choice}");
        let exact = Automatic::new(machine).choose(Goal::Error(0.001), sight).expect("something draws");
        assert_eq!((exact.method, exact.holds), (Method::Reference, true), "{machine:?}");
    }
}

/// Groups that fly apart: fast bodies are mistaken for each other in 32-bit floats.
#[test]
fn beyond_what_is_stated_the_reference_draws() {
    for (gamma, expected) in [(900.0, 0.002), (2000.0, 0.05), (1e6, 0.0)] {
        let (scene, view) = start(gamma);
        let sight = MethodViews { scene: &scene, view: &view, pixels: 1e6 };
        let choice = Automatic::new(Machine::Gpu).choose(Goal::default(), sight).expect("something draws");
        assert_eq!((choice.error_px, choice.holds), (expected, true), "{gamma}: {choice}");
    }
}

#[test]
fn what_draws_a_geometry_alone_is_chosen_for_it() {
    let (scene, view) = start(2.0);
    let chosen = |geometry, goal| {
        let view = View { geometry, ..view };
        let sight = MethodViews { scene: &scene, view: &view, pixels: 1e6 };
        Automatic::new(Machine::Gpu).choose(goal, sight).map(|choice| choice.method)
    };
    let mesh = Some(Method::Mesh);
    assert_eq!(chosen(Geometry::Published, Goal::Error(1.0)), mesh);
    assert_eq!(chosen(Geometry::OneCone, Goal::Error(1.0)), mesh);
    assert_ne!(chosen(Geometry::Seen, Goal::Error(100.0)), mesh);
    // Nothing draws it nearer.
    assert_eq!(chosen(Geometry::Published, Goal::Error(1e-4)), mesh);
    assert_eq!(chosen(Geometry::OneCone, Goal::Error(1e-4)), Some(Method::Reference));
}

/// A bumpy sheet of this many squares each way.
fn sheet(squares: u32) -> RawModel {
    let row = squares + 1;
    let place = |i: u32| [f64::from(i % row), 3.0 + f64::from(i % 2), f64::from(i / row)];
    let lows = (0..squares).flat_map(|j| (0..squares).map(move |i| j * row + i));
    RawModel {
        corners: (0..row * row).map(place).collect(),
        triangles: lows
            .flat_map(|low| [[low, low + 1, low + row], [low + row, low + 1, low + row + 1]])
            .collect(),
        ..RawModel::default()
    }
}

/// Only where a picture may be as far off, and only on a device.
#[test]
fn a_large_model_may_be_drawn_as_a_mesh() {
    let (_, view) = start(2.0);
    for (squares, is_large) in [(20, false), (500, true)] {
        let body = Body::of_triangles(sheet(squares).prepared().expect("a model"));
        let scene = PreparedScene::moving(&[body]);
        let offered = |has_gpu| {
            let methods = candidates(has_gpu, &scene, &view);
            methods.into_iter().find(|stated| stated.method == Method::Mesh).map(|stated| stated.error_px)
        };
        assert_eq!(offered(true), is_large.then_some(Method::MESH_ERROR_PX));
        assert_eq!(offered(false), None);
    }
}

/// A simulated minute of 60 frames a second: the method of each frame, each measured as it costs.
fn play(machine: Machine, goal: Goal, cost: impl Fn(Method) -> f64) -> (Vec<Method>, f64) {
    let (scene, view) = start(2.0);
    let sight = MethodViews { scene: &scene, view: &view, pixels: 1e6 };
    let mut automatic = Automatic::new(machine);
    let (mut now_ms, mut tried_ms, mut drawn) = (0.0, 0.0, Vec::new());
    while now_ms < 60_000.0 {
        let choice = automatic.choose(goal, sight).expect("something draws");
        let trial = automatic.trial(&choice, sight, now_ms);
        let method = trial.unwrap_or(choice.method);
        let measured = automatic.costs.is_due(method, view.geometry, now_ms);
        let ms = cost(method);
        automatic.costs.note(method, view.geometry, measured.then_some((ms, 1e6)), now_ms);
        tried_ms += trial.map_or(0.0, |_| ms);
        drawn.push(choice.method);
        now_ms += ms.max(1000.0 / 60.0);
    }
    (drawn, tried_ms)
}

#[test]
fn what_turns_out_cheaper_is_found_and_the_search_costs_little() {
    // A GPU that is slower than it should be, and one that is software but fast.
    let slow = |method| match method {
        Method::Rays => 30.0,
        Method::Packets => 8.0,
        Method::Reference => 100.0,
        Method::Mesh => 20.0,
    };
    let (drawn, tried_ms) = play(Machine::SoftwareGpu, Goal::Error(2.0), |method| match method {
        Method::Rays => 5.0,
        other => slow(other),
    });
    assert_eq!(drawn.last(), Some(&Method::Rays));
    assert!(tried_ms < 0.04 * 60_000.0, "{tried_ms} ms");
    let switches = drawn.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(switches <= 2, "{switches} switches");
    let (drawn, tried_ms) = play(Machine::SoftwareGpu, Goal::default(), slow);
    assert!(drawn.iter().all(|method| *method == Method::Packets));
    assert!(tried_ms < 0.02 * 60_000.0, "{tried_ms} ms");
    // A real one is not made to wait for what is far worse.
    let (drawn, tried_ms) = play(Machine::Gpu, Goal::default(), |method| match method {
        Method::Rays => 0.5,
        other => slow(other),
    });
    assert!(drawn.iter().all(|method| *method == Method::Rays));
    assert_eq!(tried_ms, 0.0);
}

#[test]
fn a_budget_is_kept_by_what_is_measured() {
    let (drawn, _) = play(Machine::SoftwareGpu, Goal::Budget(50.0), |method| match method {
        Method::Reference => 300.0,
        Method::Packets => 20.0,
        _ => 80.0,
    });
    let exceeded = drawn.iter().filter(|method| **method == Method::Reference).count();
    assert_eq!((drawn.last(), exceeded), (Some(&Method::Packets), 0), "it was expected to take 170 ms");
    let (drawn, _) = play(Machine::SoftwareGpu, Goal::Budget(500.0), |method| match method {
        Method::Reference => 300.0,
        Method::Packets => 20.0,
        _ => 80.0,
    });
    assert_eq!(drawn.last(), Some(&Method::Reference));
}
