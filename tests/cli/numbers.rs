//! The numbers that `eval` and `curve` write, against the paper, closed forms, and a second method.

use relativity_core::{Aperture, SourcePoint, Speed, disparity};

use super::{Table, eval, gamow, run, words};

/// The pair of points at which the paper's section 3 shows its models: y = z = 0.5, d = 0.3, beta = 0.9.
fn section_3_curve(model: &str) -> Table {
    words(&format!(
        "curve --beta 0.9 --d 0.3 --y 0.5 --z 0.5 --from -2 --to 6 --samples 16001 --model {model}"
    ))
    .table()
}

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn greatest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Where `values` change sign, by linear interpolation.
fn zeros(times: &[f64], values: &[f64]) -> Vec<f64> {
    times
        .windows(2)
        .zip(values.windows(2))
        .filter(|(_, v)| (v[0] < 0.0) != (v[1] < 0.0))
        .map(|(t, v)| t[0] + (t[1] - t[0]) * v[0] / (v[0] - v[1]))
        .collect()
}

#[track_caller]
pub fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} within {tolerance}");
}

/// Half of the last digit of a number printed with `digits` decimals.
fn printed(digits: i32) -> f64 {
    0.5 * 10.0_f64.powi(-digits)
}

#[track_caller]
fn assert_extremes(values: &[f64], [low, high]: [f64; 2]) {
    assert_near(least(values), low, printed(4));
    assert_near(greatest(values), high, printed(4));
}

#[track_caller]
fn assert_zeros(times: &[f64], values: &[f64], expected: &[f64]) {
    let found = zeros(times, values);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    found.iter().zip(expected).for_each(|(&found, &expected)| assert_near(found, expected, printed(3)));
}

#[test]
fn published_model_has_the_extremes_and_zeros_of_appendix_a() {
    let table = section_3_curve("published");
    let (times, dphi, dtheta) = (table.column("T"), table.column("dphi"), table.column("dtheta"));
    assert_extremes(&dphi, [-0.3295, 0.0712]);
    assert_extremes(&dtheta, [-0.0032, 0.2240]);
    assert_zeros(&times, &dphi, &[0.723]);
    assert_zeros(&times, &dtheta, &[0.567, 0.723]);
}

#[test]
fn published_text_model_has_the_extremes_and_zeros_of_the_texts_sign() {
    let table = section_3_curve("published-text");
    let (times, dphi, dtheta) = (table.column("T"), table.column("dphi"), table.column("dtheta"));
    assert_extremes(&dphi, [-0.0858, 0.4394]);
    assert_extremes(&dtheta, [-0.2694, 0.0045]);
    assert_zeros(&times, &dphi, &[0.723]);
    assert_zeros(&times, &dtheta, &[0.504, 0.723]);
}

#[test]
fn exact_model_keeps_its_parallax_negative_and_crosses_zero_elevation_at_equidistance() {
    let table = section_3_curve("exact");
    let (times, dphi, dtheta) = (table.column("T"), table.column("dphi"), table.column("dtheta"));
    assert_near(least(&dphi), -0.6678, printed(4));
    assert!(greatest(&dphi) < 0.0);
    assert_extremes(&dtheta, [-0.0973, 0.3219]);
    let crossings = zeros(&times, &dtheta);
    assert_eq!(crossings.len(), 1);
    assert_near(crossings[0], 0.7228, printed(4));
}

#[test]
fn with_one_cone_both_eyes_receive_one_event_and_differ_by_its_parallax_alone() {
    let table = section_3_curve("one-cone");
    for name in ["t", "doppler", "tau"] {
        let [left, right] = ["left", "right"].map(|eye| table.column(&format!("{name}_{eye}")));
        assert_eq!(left, right, "{name}");
    }
    let columns = ["x_left", "x_right", "dphi", "dtheta"].map(|name| table.column(name));
    let [left, right, dphi, dtheta] = &columns;
    let point = |x: f64| (0.5f64.atan2(x), 0.5f64.atan2(x.hypot(0.5)));
    for i in 0..left.len() {
        assert!((left[i] - right[i] - 0.3).abs() < 1e-12);
        let ((left_phi, left_theta), (right_phi, right_theta)) = (point(left[i]), point(right[i]));
        assert!((dphi[i] - (left_phi - right_phi)).abs() < 1e-12);
        assert!((dtheta[i] - (left_theta - right_theta)).abs() < 1e-12);
    }
    // The most that eyes d apart see of a point at rest beside them, at the distance 0.5: 2 atan(d/2 / 0.5).
    assert_near(least(dphi), -2.0 * 0.3f64.atan(), printed(4));
}

#[test]
fn cyclists_point_is_equidistant_at_its_t0() {
    let table = words("curve --from 3.6 --to 3.61 --samples 101").table();
    let crossings = zeros(&table.column("T"), &table.column("dtheta"));
    assert_eq!(crossings.len(), 1);
    assert_near(crossings[0], 3.60590, printed(5));
    assert_near(crossings[0], 13.0025_f64.sqrt(), 1e-7);

    let at_t0 = eval(format!("beta,d,y,z,T\n0.9,0.1,3,2,{}\n", 13.0025_f64.sqrt())).table();
    assert_near(at_t0.column("t_left")[0], at_t0.column("t_right")[0], 1e-15);
    assert_near(at_t0.column("dtheta")[0], 0.0, 1e-15);
}

#[test]
fn doppler_factor_is_head_on_far_away_and_inverse_gamma_abeam() {
    let gamma = 1.0 / 0.19_f64.sqrt();
    let time_abeam = 0.5_f64.sqrt() - 0.15 / 0.9; // S = beta rho
    let table = eval(format!("T,beta,d,y,z\n-1e6,0.9,0.3,0.5,0.5\n{time_abeam},0.9,0.3,0.5,0.5\n")).table();
    let doppler = table.column("doppler_left");
    assert_near(doppler[0], 4.3589, printed(4));
    assert_near(doppler[1], 1.0 / gamma, 1e-15);
    assert_near(table.column("x_left")[1], 0.0, 1e-15);
    assert_near(table.column("phi_left")[1], std::f64::consts::FRAC_PI_2, 1e-14);
}

#[test]
fn apparent_speed_is_nine_c_approaching_and_under_half_c_receding() {
    let table = eval("beta,d,y,z,T\n.9,0,3,2,-1e7\n.9,0,3,2,-9e6\n.9,0,3,2,9e6\n.9,0,3,2,1e7\n").table();
    let x = table.column("x_left");
    assert_near((x[1] - x[0]) / 1e6, 0.9 / (1.0 - 0.9), 1e-9);
    assert_near((x[3] - x[2]) / 1e6, 0.9 / (1.0 + 0.9), 1e-9);
}

#[test]
fn rod_far_ahead_looks_longer_and_far_past_looks_shorter_by_the_head_on_doppler_factor() {
    let contracted = 0.19_f64.sqrt(); // a rod of rest length 1
    let rows = [-1e6, 1e6].map(|time| format!("0,.9,0,3,2,{time}\n{contracted},.9,0,3,2,{time}\n"));
    let x = eval(format!("x0,beta,d,y,z,T\n{}{}", rows[0], rows[1])).table().column("x_left");
    let stretch = (1.9_f64 / 0.1).sqrt();
    assert_near(x[1] - x[0], stretch, 1e-6);
    assert_near(x[3] - x[2], 1.0 / stretch, 1e-6);
}

#[test]
fn beta_gamma_and_rapidity_agree() {
    let tables = [
        "--beta 0.9".to_owned(),
        format!("--gamma {}", 1.0 / 0.19_f64.sqrt()),
        format!("--rapidity {}", 0.9_f64.atanh()),
    ]
    .map(|speed| words(&format!("curve {speed} --from -3 --to 12 --samples 31")).table());
    assert_eq!(
        [&tables[0].names[0], &tables[1].names[0], &tables[2].names[0]],
        ["beta", "gamma", "rapidity"]
    );
    for other in &tables[1..] {
        for (row, other) in tables[0].rows.iter().zip(&other.rows) {
            for (value, other) in row.iter().zip(other).skip(1) {
                assert_near(*other, *value, 1e-13 * value.abs().max(1.0));
            }
        }
    }
}

/// One eye's [x, t, doppler, phi, theta, own], by bisection for the time of emission.
fn sighting_by_bisection(beta: f64, [x0, y, z]: [f64; 3], aperture: f64, time: f64) -> [f64; 6] {
    let place = |t: f64| x0 + beta * t - aperture;
    let distance = |t: f64| (place(t).powi(2) + y * y + z * z).sqrt();
    let (mut early, mut late) = (time - 1e4, time);
    for _ in 0..200 {
        let middle = f64::midpoint(early, late);
        if middle + distance(middle) < time { early = middle } else { late = middle }
    }
    let (x, r) = (place(late), distance(late));
    let doppler = (1.0 - beta * beta).sqrt() / (1.0 + beta * x / r);
    // The Lorentz transformation of the event.
    let own = (late - beta * (x + aperture)) / (1.0 - beta * beta).sqrt();
    [x, late, doppler, y.atan2(x), (z / r).asin(), own]
}

#[test]
fn every_column_agrees_with_bisection_on_the_light_cone() {
    let cases = [
        (0.9, 0.3, [0.0, 0.5, 0.5], -1.0),
        (0.5, 0.1, [2.0, 3.0, -2.0], 4.0),
        (0.99, 0.2, [-1.0, -0.7, 0.1], 0.5),
        (0.0, 0.065, [0.3, 1.0, 0.2], -7.0),
    ];
    for (beta, d, point, time) in cases {
        let [x0, y, z] = point;
        let input = format!("T,z,y,x0,d,beta\n{time},{z},{y},{x0},{d},{beta}\n");
        let table = eval(input).table();
        let left = sighting_by_bisection(beta, point, -d / 2.0, time);
        let right = sighting_by_bisection(beta, point, d / 2.0, time);
        for (index, name) in ["x", "t", "doppler", "phi", "theta", "tau"].into_iter().enumerate() {
            assert_near(table.column(&format!("{name}_left"))[0], left[index], 1e-10);
            assert_near(table.column(&format!("{name}_right"))[0], right[index], 1e-10);
        }
        assert_near(table.column("intensity_left")[0], left[2].powi(4), 1e-9);
        assert_near(table.column("intensity_right")[0], right[2].powi(4), 1e-9);
        assert_near(table.column("dphi")[0], left[3] - right[3], 1e-10);
        assert_near(table.column("dtheta")[0], left[4] - right[4], 1e-10);
    }
}

#[test]
fn the_points_own_clock_is_seen_to_run_at_the_doppler_factor() {
    for model in ["exact", "one-cone"] {
        for flags in ["--beta 0.9 --x0 2", "--beta 0.5 --d 1", "--beta 0.99 --x0 -1 --z -0.5"] {
            let flags = format!("--from -2 --to 8 --samples 20001 --model {model} {flags}");
            let table = words(&format!("curve {flags}")).table();
            let time = table.column("T");
            for eye in ["left", "right"] {
                let [own, doppler] = ["tau", "doppler"].map(|name| table.column(&format!("{name}_{eye}")));
                for i in 1..time.len() - 1 {
                    let speed = (own[i + 1] - own[i - 1]) / (time[i + 1] - time[i - 1]);
                    assert_near(speed, doppler[i], 1e-6 * doppler[i].max(1.0));
                }
            }
        }
    }
}

#[test]
fn stereo_columns_are_where_both_lines_of_sight_meet() {
    for flags in ["", "--d 2 --x0 1", "--beta 0.99 --y -0.7", "--beta 0 --from 0 --to 3"] {
        let table = words(&format!("curve --samples 41 --stereo {flags}")).table();
        let columns = ["stereo_gain", "stereo_x", "stereo_y", "stereo_z", "x_left", "x_right", "d", "y", "z"];
        let [gain, x, y, z, left, right, d, depth, height] = columns.map(|name| table.column(name));
        for i in 0..gain.len() {
            assert_near(gain[i], (left[i] - right[i]) / d[i], 1e-11 * gain[i]);
            for (seen, eye) in [(left[i], -d[i] / 2.0), (right[i], d[i] / 2.0)] {
                // As far along the line of sight in x as in y and z.
                let along = y[i] / depth[i];
                assert_near(along * gain[i], 1.0, 1e-14);
                assert_near(eye + along * seen, x[i], 1e-12 * (1.0 + x[i].abs()));
                assert_near(along * height[i], z[i], 1e-14 * z[i].abs());
            }
        }
    }
}

#[test]
fn a_tilted_head_has_columns_of_its_own_which_eval_reads() {
    let straight = words("curve --samples 5 --stereo").text();
    assert_eq!(words("curve --samples 5 --stereo --roll 0 --turn=0").text(), straight);
    let curve = words("curve --samples 5 --stereo --roll 90").text();
    let table = Table::parsed(&curve);
    assert!(table.column("roll").iter().all(|&roll| roll == 90.0));
    let (speed, point) = (Speed::from_beta(0.9).expect("a speed"), SourcePoint { x0: 0.0, y: 3.0, z: 2.0 });
    let [low, high] = [-0.05, 0.05].map(|z| Aperture { x: 0.0, y: 0.0, z });
    for (index, time) in table.column("T").into_iter().enumerate() {
        let both = disparity(&speed, point, low, high, time).expect("it is in the domain");
        assert_eq!(table.column("dtheta")[index].to_bits(), both.dtheta.to_bits());
        assert_eq!(table.column("dphi")[index].to_bits(), both.dphi.to_bits());
    }
    let inputs: String =
        curve.lines().map(|line| line.split(',').take(8).collect::<Vec<_>>().join(",") + "\n").collect();
    let again = run(gamow().args(["eval", "--stereo"]), inputs.as_bytes()).text();
    assert_eq!(again, curve);
}

#[test]
fn where_lines_of_sight_diverge_the_stereo_columns_are_empty() {
    let text = words("curve --stereo --turn 90 --z 0.2 --from 0.3 --to 0.9 --samples 3").text();
    for line in text.lines().skip(1) {
        assert!(line.ends_with(",,,,,"), "{line}");
        assert!(line.split(',').take(24).all(|field| !field.is_empty()), "{line}");
    }
    assert!(!text.contains("NaN"));
}

#[test]
fn stereo_columns_of_eyes_in_one_place_are_the_seen_place_over_gamma_d() {
    let table = words("curve --beta 0.9 --d 0 --samples 21 --stereo").table();
    let gamma = 1.0 / 0.19_f64.sqrt();
    let columns = ["doppler_left", "stereo_gain", "x_left", "stereo_x"].map(|name| table.column(name));
    let [doppler, gain, seen, x] = columns;
    for i in 0..gain.len() {
        assert_near(gain[i], gamma * doppler[i], 1e-13 * gain[i]);
        assert_near(x[i], seen[i] / (gamma * doppler[i]), 1e-13 * seen[i].abs());
    }
}

#[test]
fn stereo_columns_of_one_light_cone_are_what_the_middle_sees() {
    let seen = words("curve --d 0 --from -3 --to 9 --samples 21").table();
    let table = words("curve --d 0.3 --from -3 --to 9 --samples 21 --stereo --model one-cone").table();
    assert!(table.column("stereo_gain").iter().all(|&gain| gain == 1.0));
    assert_eq!(table.column("stereo_x"), seen.column("x_left"));
    assert!(table.column("stereo_y").iter().all(|&y| y == 3.0));
}

/// The point is seen the rapidity behind where it would be seen at rest, at any speed; other columns stay as
/// they are.
#[test]
fn conformal_columns_are_the_resting_ones_slid_by_the_rapidity() {
    for flags in
        ["", "--beta 0.99 --y -0.7 --x0 2", "--gamma 1e6 --from -3 --to 9", "--rapidity 0 --from 0 --to 3"]
    {
        let plain = words(&format!("curve --samples 41 {flags}")).text();
        let text = words(&format!("curve --samples 41 --conformal {flags}")).text();
        for (plain, line) in plain.lines().zip(text.lines()) {
            assert!(line.starts_with(&format!("{plain},")), "{line}");
        }
        let table = Table::parsed(&text);
        let names = ["u_left", "u_right", "v_left", "v_right", "y", "z", "x0", "d", "T"];
        let [left, right, v_left, v_right, y, z, x0, d, time] = names.map(|name| table.column(name));
        let [speed] = ["beta", "gamma", "rapidity"]
            .into_iter()
            .filter(|name| {
                text.lines().next().is_some_and(|head| head.split(',').any(|column| column == *name))
            })
            .map(|name| match (name, table.column(name)[0]) {
                ("beta", beta) => Speed::from_beta(beta).expect("a speed"),
                ("gamma", gamma) => Speed::from_gamma(gamma).expect("a speed"),
                (_, rapidity) => Speed::from_rapidity(rapidity).expect("a speed"),
            })
            .collect::<Vec<_>>()[..]
        else {
            panic!("{text}")
        };
        for i in 0..left.len() {
            let rho = y[i].hypot(z[i]);
            for (u, v, eye) in [(left[i], v_left[i], -0.5), (right[i], v_right[i], 0.5)] {
                let xi = speed.gamma() * (x0[i] + speed.beta() * time[i] - eye * d[i]);
                let expected = (xi / rho).asinh() - speed.rapidity();
                // xi is a difference, of which gamma makes what it lacks larger.
                let tolerance = 1e-13 + 1e-15 * speed.gamma() * time[i].abs() / xi.hypot(rho);
                assert_near(u, expected, tolerance);
                assert_near(v, z[i].atan2(y[i]), 1e-15);
            }
        }
    }
}

/// Told by hand: at T = 0 the point at x = 0 is seen at X = -gamma beta rho, the rapidity behind.
#[test]
fn what_is_abreast_is_seen_behind_by_the_rapidity() {
    for (beta, slide) in [("0.5", 0.5493), ("0.9", 1.4722), ("0.99", 2.6467)] {
        let input = format!("beta,d,y,z,T\n{beta},0,3,2,0\n");
        let table = run(gamow().args(["eval", "--conformal"]), input.as_bytes()).table();
        assert_near(table.column("u_left")[0], -slide, 5e-5);
        assert_near(table.column("v_left")[0], 0.5880, 5e-5);
    }
}

#[test]
fn conformal_columns_are_along_the_baseline_of_a_tilted_head_and_of_wheels_too() {
    let curve = words("curve --samples 5 --stereo --conformal --roll 90").text();
    let table = Table::parsed(&curve);
    let names = ["u_left", "u_right", "v_left", "v_right", "x_left", "x_right"];
    let [left, right, v_left, v_right, x_left, x_right] = names.map(|name| table.column(name));
    for i in 0..left.len() {
        // The head lies on its left side: its right is up, and its crown points to -x.
        for (u, v, x, z) in [(left[i], v_left[i], x_left[i], 2.05), (right[i], v_right[i], x_right[i], 1.95)]
        {
            assert_near(u, (z / x.hypot(3.0)).asinh(), 1e-14);
            assert_near(v, (-x).atan2(3.0), 1e-14);
        }
    }
    let inputs: String =
        curve.lines().map(|line| line.split(',').take(8).collect::<Vec<_>>().join(",") + "\n").collect();
    assert_eq!(run(gamow().args(["eval", "--stereo", "--conformal"]), inputs.as_bytes()).text(), curve);

    let wheel = "--wheel-radius 0.525 --rho 0.8 --angle=-1.5 --from -2 --to 8 --samples 7";
    for model in ["exact", "one-cone", "published"] {
        let table = words(&format!("curve --conformal {wheel} --model {model}")).table();
        let names = ["u_left", "v_left", "x_left", "phi_left", "theta_left"];
        let [u, v, x, phi, theta] = names.map(|name| table.column(name));
        for i in 0..u.len() {
            assert_near(u[i].tanh(), phi[i].cos() * theta[i].cos(), 1e-13);
            assert_near(v[i], theta[i].sin().atan2(phi[i].sin() * theta[i].cos()), 1e-13);
            assert!(x[i].signum() == u[i].signum());
        }
    }
}

#[test]
fn what_is_on_the_baseline_has_empty_conformal_columns_and_extremes_are_numbers() {
    let input = "gamma,d,y,z,T\n2,0.1,0,0,3\n1e30,0.1,3,2,-1e12\n1e30,0.1,3,2,1e12\n1e30,0,1e-300,0,0\n";
    let text = run(gamow().args(["eval", "--conformal"]), input.as_bytes()).text();
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert!(lines[0].ends_with(",,,,") && !text.contains("NaN") && !text.contains("inf"), "{text}");
    for line in &lines[1..] {
        assert!(line.split(',').all(|field| field.parse().is_ok_and(f64::is_finite)), "{line}");
    }
    let table =
        Table::parsed(&words("curve --gamma 1e30 --conformal --from -1e12 --to 1e12 --samples 3").text());
    // u = arsinh(xi/rho) - eta, with ln(2 gamma T/rho) for the arsinh of what is far.
    let (rho, eta) = (13.0_f64.sqrt(), 2.0_f64.ln() + 30.0 * 10.0_f64.ln());
    let far = 2.0_f64.ln() + 42.0 * 10.0_f64.ln() - rho.ln();
    let u = table.column("u_left");
    assert_near(u[0], -far - eta, 1e-11);
    assert_near(u[2], far - eta, 1e-11);
}

#[test]
fn intensity_follows_its_exponent() {
    let flag = "--intensity-exponent";
    for (flag, exponent) in [
        (String::new(), 4),
        (format!("{flag} surface"), 4),
        (format!("{flag} photons"), 3),
        (format!("{flag} paper"), 2),
        (format!("{flag} 2"), 2),
        (format!("{flag} -4"), -4),
    ] {
        let table = words(&format!("curve --samples 9 {flag}")).table();
        for (doppler, intensity) in table.column("doppler_right").iter().zip(table.column("intensity_right"))
        {
            assert_near(intensity / doppler.powi(exponent), 1.0, 1e-14);
        }
    }
}

#[test]
fn numbers_are_the_libraries_own_in_the_shortest_decimals_that_read_back() {
    let text = words("curve --gamma 1e9 --x0 -1e-7 --samples 101").text();
    let speed = Speed::from_gamma(1e9).expect("it is a speed");
    let [left, right] = Aperture::pair(0.1);
    let table = Table::parsed(&text);
    for (index, time) in table.column("T").into_iter().enumerate() {
        let point = SourcePoint { x0: -1e-7, y: 3.0, z: 2.0 };
        let disparity = disparity(&speed, point, left, right, time).expect("it is in the domain");
        assert_eq!(table.column("x_left")[index].to_bits(), disparity.primary.position[0].to_bits());
        assert_eq!(table.column("dphi")[index].to_bits(), disparity.dphi.to_bits());
        assert_eq!(table.column("dtheta")[index].to_bits(), disparity.dtheta.to_bits());
    }
    for field in text.lines().skip(1).flat_map(|line| line.split(',')) {
        let value: f64 = field.parse().expect("it is a number");
        let shortest = format!("{value:e}"); // the standard library's own shortest digits
        assert_eq!(significant_digits(field), significant_digits(&shortest), "{field}");
    }
}

fn significant_digits(decimal: &str) -> String {
    let mantissa = decimal.split('e').next().expect("split gives at least one part");
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_matches('0').to_owned()
}

#[test]
fn eyes_in_one_place_see_the_same_in_every_model() {
    for model in ["exact", "one-cone", "published", "published-text"] {
        for speed in ["--beta 0", "--beta 1e-14", "--beta 0.9", "--gamma 1e9"] {
            // T = -5 is among the times: for a slow point minus the time that its light travels.
            let flags =
                format!("--d 0 --x0 3 --y 4 --z 0 --from -5 --to 5 --samples 21 --model {model} {speed}");
            let table = words(&format!("curve {flags}")).table();
            assert!(table.column("dphi").iter().chain(&table.column("dtheta")).all(|&value| value == 0.0));
            for name in ["x", "t", "doppler"] {
                let [left, right] = ["left", "right"].map(|eye| table.column(&format!("{name}_{eye}")));
                for (left, right) in left.iter().zip(right) {
                    assert_near(right, *left, 4.0 * f64::EPSILON * left.abs());
                }
            }
        }
    }
}

#[test]
fn point_passing_through_an_eye_has_finite_columns() {
    let table = eval("beta,d,y,z,T\n0.9,0,0,0,0\n0.9,0.2,0,0,-0.1111111111111111\n0,0,0,0,3\n").table();
    assert!(table.rows.iter().flatten().all(|value| value.is_finite()));
}

#[test]
fn curve_ends_exactly_where_it_is_told() {
    let times = words("curve --from -0.1 --to 1e-3 --samples 7").table().column("T");
    assert_eq!((times.len(), times[0], times[6]), (7, -0.1, 1e-3));
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
}

#[test]
fn curve_shows_the_passage_at_any_speed_when_not_told_where() {
    for speed in ["--beta 1e-12", "--beta 0.9", "--gamma 1e12"] {
        let table = words(&format!("curve {speed} --d 0 --x0 5 --samples 3")).table();
        let x = table.column("x_left");
        let distance = 13.0_f64.sqrt();
        assert_near(x[0], -2.0 * distance, 1e-3);
        assert_near(x[2], 2.0 * distance, 1e-3);
    }
}

#[test]
fn curve_written_by_one_model_is_input_for_another() {
    let curve = words("curve --samples 5 --model published").text();
    let inputs: String =
        curve.lines().map(|line| line.splitn(7, ',').take(6).collect::<Vec<_>>().join(",") + "\n").collect();
    assert_eq!(eval(inputs).text(), words("curve --samples 5").text());
}
