//! `eval` and `curve` of points on wheels.

use super::{Table, eval, gamow, run, words};

/// The valve of the front wheel, by a root-finder in 40-digit arithmetic: beta, T, then X from the left eye,
/// t, t', the angle in degrees and D.
const VALVE: [(f64, f64, [&str; 5]); 3] = [
    (0.5, 0.0, ["-3.224919516", "-4.773851210", "-3.621592898", "197.620941", "0.8844761986"]),
    (
        0.9,
        3.605_551_275_463_989,
        ["0.04960746323", "-0.0004361384647", "-0.0001900832636", "0.01867023216", "0.2389794071"],
    ),
    (0.99, 8.0, ["3.158284293", "3.284060801", "1.466387054", "201.5664544", "0.01794733091"]),
];

#[test]
fn the_valve_of_a_rolling_wheel_is_where_another_solution_has_it() {
    for (beta, time, expected) in VALVE {
        // The hub is at -0.525 in the rest frame.
        let x0 = -0.525 * (1.0 - beta * beta).sqrt();
        let input = format!("T,beta,d,x0,y,z,angle,wheel_radius,rho\n{time},{beta},0.1,{x0},3,2,0,0.525,1\n");
        let table = eval(&input).table();
        let columns = ["x_left", "t_left", "tau_left", "angle_left", "doppler_left"];
        for (name, expected) in columns.into_iter().zip(expected) {
            let value = table.column(name)[0];
            let value = if name == "angle_left" { value.to_degrees().rem_euclid(360.0) } else { value };
            let decimals = expected.len() - expected.find('.').expect("decimals") - 1;
            assert_eq!(format!("{value:.decimals$}"), expected, "{name} at {beta}");
        }
    }
}

#[test]
fn a_curve_of_a_point_on_a_wheel_is_input_for_eval() {
    let flags = "--stereo --wheel-radius 0.525 --rho 0.8 --angle=-1.5 --from -2 --to 8 --samples 7";
    let curve = words(&format!("curve {flags}")).text();
    assert!(curve.starts_with("beta,d,wheel_radius,rho,angle,y,z,x0,T,x_left"), "{}", &curve[..60]);
    assert!(curve.lines().next().is_some_and(|names| {
        names.ends_with("tau_right,angle_left,angle_right,stereo_gain,stereo_x,stereo_y,stereo_z,stereo_miss")
    }));
    let inputs: String =
        curve.lines().map(|line| line.split(',').take(9).collect::<Vec<_>>().join(",") + "\n").collect();
    let again = run(gamow().args(["eval", "--stereo"]), inputs.as_bytes()).text();
    assert_eq!(again, curve);
    let table = Table::parsed(&curve);
    let (own, angle) = (table.column("tau_left"), table.column("angle_left"));
    for i in 0..own.len() {
        let turned = -1.5 - 0.9 / 0.525 * own[i];
        let apart = (turned - angle[i]) / std::f64::consts::TAU;
        assert!((apart - apart.round()).abs() < 1e-14 && angle[i].abs() <= std::f64::consts::PI);
    }
}

#[test]
fn a_point_on_the_axle_is_seen_as_one_that_does_not_turn() {
    let plain = words("curve --samples 9").text();
    let hub = words("curve --samples 9 --wheel-radius 0.5 --rho 0 --angle 1").text();
    for (plain, hub) in plain.lines().zip(hub.lines()).skip(1) {
        let [plain, hub] = [plain, hub].map(|line| line.split(',').collect::<Vec<_>>());
        assert_eq!([&plain[..2], &plain[2..]].concat(), [&hub[..2], &hub[5..25]].concat());
    }
}

#[test]
fn what_is_no_wheel_is_one_clear_line() {
    let of_curve = |flags: &str| words(&format!("curve {flags}")).complaint();
    let complaint = of_curve("--wheel-radius 0 --rho 1 --angle 0");
    assert!(complaint.contains("wheel_radius = 0.0 is out of range: it must be above 0"), "{complaint}");
    let complaint = of_curve("--wheel-radius 1 --rho 1.5 --angle 0");
    assert!(complaint.contains("rho = 1.5 is out of range: it must be between 0 and 1"), "{complaint}");
    let of_eval = |input: &str| run(gamow().arg("eval"), input.as_bytes()).complaint();
    let complaint = of_eval("beta,d,y,z,T,rho\n0.9,0.1,3,2,0,1\n");
    let said = "standard input:1: column rho is given, and wheel_radius is not; \
                wheel_radius, rho and angle go together";
    assert!(complaint.contains(said), "{complaint}");
    let complaint = of_eval("beta,d,y,z,T,wheel_radius,rho,angle\n0.9,0.1,3,2,0,-1,1,0\n");
    let said =
        "standard input:2: column wheel_radius: wheel_radius = -1.0 is out of range: it must be above 0";
    assert!(complaint.contains(said), "{complaint}");
    let complaint = of_eval("beta,d,y,z,T,wheel_radius,rho,angle,angle_left\n0.9,0.1,3,2,0,1,1,0,0\n");
    assert!(complaint.contains("column angle_left is there already"), "{complaint}");
}
