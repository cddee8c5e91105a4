//! Colours of paint in shifted daylight against sums done here: over every quarter of a nm from
//! 360 to 830, with no logarithm and no lookup.

use relativity_render::colour::sunlit::{
    colour, in_daylight, lit_by_shifted, log2_level, on_screen, share_of_sky, sky_beside_paint,
};
use relativity_render::colour::{luminance, srgb_encoded};
use relativity_render::{Material, Paint};

const MATCHING: &str = include_str!("../assets/cie-1931-2deg.csv");
const SUN: &str = include_str!("../assets/sun.csv");
const MATERIALS: &str = include_str!("../assets/materials.csv");
const SMOOTH: &str = include_str!("../assets/smooth-paint.csv");

/// From rest to bodies that come and go: D of the issue, twenty from 0.5 to 3.4.
fn doppler_factors() -> impl Iterator<Item = f64> {
    (0..20).map(|step| 0.5 * (3.4f64 / 0.5).powf(f64::from(step) / 19.0))
}

/// Wavelengths and one column of a table.
struct Curve(Vec<[f64; 2]>);

impl Curve {
    fn new(csv: &str, column: usize) -> Self {
        let number = |line: &str, at: usize| line.split(',').nth(at).and_then(|of| of.parse().ok());
        let row = |line: &str| Some([number(line, 0)?, number(line, column)?]);
        Self(csv.lines().skip(1).map(|line| row(line).expect("numbers")).collect())
    }

    fn at(&self, nm: f64) -> f64 {
        let next = self.0.partition_point(|[known, _]| *known <= nm);
        if next == 0 || next == self.0.len() {
            return self.0[next.min(self.0.len() - 1)][1];
        }
        let ([a, low], [b, high]) = (self.0[next - 1], self.0[next]);
        low + (high - low) * (nm - a) / (b - a)
    }
}

/// CIE XYZ of light that is received, with the Doppler factor `seen`, of what reflects so much of the
/// daylight that it receives with the Doppler factor `lit`.
fn xyz(reflectance: &dyn Fn(f64) -> f64, seen: f64, lit: f64) -> [f64; 3] {
    let sun = Curve::new(SUN, 1);
    let mut sum = [0.0; 3];
    let matching = [1, 2, 3].map(|column| Curve::new(MATCHING, column));
    for nm in (1440..=3320).map(|quarter| 0.25 * f64::from(quarter)) {
        let (at_body, doppler) = (nm * seen, seen * lit);
        let emitted = nm * doppler;
        let daylight = if emitted < 280.0 { 0.0 } else { sun.at(emitted) };
        let light = doppler.powi(5) * daylight * reflectance(at_body);
        sum = std::array::from_fn(|part| sum[part] + light * matching[part].at(nm));
    }
    sum
}

fn inverse(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let minor = |r: usize, c: usize| {
        let [(a, b), (d, e)] = [((r + 1) % 3, (r + 2) % 3), ((c + 1) % 3, (c + 2) % 3)];
        m[a][d] * m[b][e] - m[a][e] * m[b][d]
    };
    let determinant: f64 = (0..3).map(|c| m[0][c] * minor(0, c)).sum();
    std::array::from_fn(|r| std::array::from_fn(|c| minor(c, r) / determinant))
}

fn times(m: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row.into_iter().zip(v).map(|(a, b)| a * b).sum())
}

/// Linear sRGB of CIE XYZ for eyes that adapt to `white`: the matrices as IEC 61966-2-1 and Bradford have
/// them, their inverses worked out here.
fn balanced(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let bradford = [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];
    let to_xyz = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
    let screen = times(to_xyz, [1.0; 3]);
    let [found, from, to] = [xyz, white, screen].map(|xyz| times(bradford, xyz));
    let adapted = std::array::from_fn(|cone| found[cone] * to[cone] / from[cone]);
    times(inverse(to_xyz), times(inverse(bradford), adapted))
}

/// Luminance of linear sRGB before eyes adapt: Y of what is balanced.
fn unadapted(linear: [f64; 3]) -> f64 {
    let white = xyz(&|_| 1.0, 1.0, 1.0);
    let of = |part: usize| balanced(std::array::from_fn(|i| f64::from(u8::from(i == part))), white);
    let back: [[f64; 3]; 3] = [of(0), of(1), of(2)];
    let columns = std::array::from_fn(|row| std::array::from_fn(|column| back[column][row]));
    times(inverse(columns), linear)[1]
}

fn reflectance(material: Material) -> impl Fn(f64) -> f64 {
    let curve = Curve::new(MATERIALS, material.number() + 1);
    move |nm| curve.at(nm)
}

/// How many of 255 levels apart two colours are on a screen, at most.
fn levels(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [a, b] = [a, b].map(|linear| on_screen(linear).map(srgb_encoded));
    (0..3).map(|part| 255.0 * (a[part] - b[part]).abs()).fold(0.0, f64::max)
}

#[test]
fn columns_are_the_materials() {
    let names: Vec<_> = MATERIALS.lines().next().expect("names").split(',').skip(1).collect();
    assert_eq!(names, Material::ALL.map(Material::name));
    assert!(Material::ALL.into_iter().all(|material| Material::named(material.name()) == Some(material)));
    assert_eq!(Material::named("white paint"), None);
}

#[test]
fn colours_of_materials_are_those_of_finer_sums() {
    let white_at_rest = xyz(&|_| 1.0, 1.0, 1.0);
    let mut worst = [0.0_f64; 2];
    for doppler in doppler_factors() {
        let octaves = doppler.log2();
        let white = xyz(&|_| 1.0, doppler, 1.0);
        let whitest = on_screen(balanced(white, white_at_rest)).into_iter().fold(0.0, f64::max);
        worst[1] = worst[1].max((log2_level(octaves).exp2() / whitest - 1.0).abs());
        for material in Material::ALL {
            let found = colour(Paint::Measured(material), octaves);
            let of = xyz(&reflectance(material), doppler, 1.0);
            let expected = balanced(of, white_at_rest).map(|part| part / whitest);
            let off = levels(found, expected);
            assert!(off < 1.0, "{material:?} at {doppler}: {off} levels, {found:?} for {expected:?}");
            worst[0] = worst[0].max(off);
        }
    }
    println!("at most {:.2} levels and {:.1e} of white's level off", worst[0], worst[1]);
    assert!(worst[1] < 0.01, "{worst:?}");
}

/// Luminances beside white, worked out elsewhere: D = 0.7, 1, 1.3, 1.5, 2.
#[test]
fn luminances_are_those_of_the_derivation() {
    for (name, expected) in [
        ("leaves", [0.0214, 0.0545, 0.2876, 0.5264, 0.4968]),
        ("asphalt_road", [0.060, 0.0777, 0.0885, 0.0925, 0.0987]),
        ("red_paint", [0.079, 0.1333, 0.5281, 0.5407, 0.5567]),
        ("clay_tile", [0.0585, 0.1274, 0.2973, 0.3284, 0.5389]),
    ] {
        let paint = Paint::Measured(Material::named(name).expect("a material"));
        for (doppler, expected) in [0.7, 1.0, 1.3, 1.5, 2.0].into_iter().zip(expected) {
            let [found, white] =
                [paint, Paint::WHITE].map(|paint| unadapted(colour(paint, f64::log2(doppler))));
            assert!((found / white / expected - 1.0).abs() < 0.01, "{name} at {doppler}: {}", found / white);
        }
    }
}

/// White's own luminance beside that at rest, worked out elsewhere by sums over every nanometre.
#[test]
fn what_is_left_behind_goes_out() {
    for (doppler, expected) in [(0.7_f64, 0.096_55), (0.6, 0.019_61), (0.5, 0.000_371_5)] {
        let octaves = doppler.log2();
        let found =
            unadapted(colour(Paint::WHITE, octaves)) * log2_level(octaves).exp2() / unadapted([1.0; 3]);
        assert!((found / expected - 1.0).abs() < 0.01, "{doppler}: {found}");
    }
}

#[test]
fn smooth_paint_at_rest_is_what_it_is_called() {
    for paint in
        [[1.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.7, 0.1], [0.45, 0.03, 0.02]]
    {
        let found = colour(Paint::Smooth(paint), 0.0);
        assert!(levels(found, paint) < 0.5, "{paint:?}: {found:?}");
        assert!(levels(in_daylight(Paint::Smooth(paint), 0.0), paint) < 0.5, "{paint:?}");
    }
    assert_eq!(log2_level(0.0), 0.0);
}

/// By how much the smooth paints of the data are off red, green and blue at rest, by the sums here.
fn rounding_of_smooth_paints() -> f64 {
    let white = xyz(&|_| 1.0, 1.0, 1.0);
    let mut worst: f64 = 0.0;
    for primary in 0..3 {
        let curve = Curve::new(SMOOTH, primary + 1);
        let found = balanced(xyz(&|nm| curve.at(nm), 1.0, 1.0), white);
        for (part, found) in found.into_iter().enumerate() {
            worst = worst.max((found - f64::from(u8::from(part == primary))).abs());
        }
    }
    worst
}

/// Grey paint in daylight is dimmer white at any Doppler factor, and no colour has more light than white.
///
/// The reflectances of the data lie between 0 and 1. By as much as they are off their colours at rest, each
/// is mixed with the others so that it is not: by that share it may be below 0 or above 1, and no more.
#[test]
fn smooth_paints_add_up_to_white() {
    let share = rounding_of_smooth_paints();
    assert!(share < 2e-4, "{share}");
    for step in -150..=600 {
        let octaves = f64::from(step) / 100.0;
        let [grey, white] = [[0.3; 3], [1.0; 3]].map(|paint| colour(Paint::Smooth(paint), octaves));
        assert!(
            grey.into_iter().zip(white).all(|(grey, white)| (grey - 0.3 * white).abs() < 1e-5),
            "{octaves}"
        );
        for primary in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
            let of = luminance(colour(Paint::Smooth(primary), octaves));
            assert!((-share..=luminance(white) + share).contains(&of), "{primary:?} at {octaves}: {of}");
        }
    }
}

/// The sky's light, daylight less that of the sun 11.2 degrees off the normal, as what is left of a colour
/// that is all sky.
#[test]
fn the_sky_shines_with_its_own_spectrum() {
    let white_at_rest = xyz(&|_| 1.0, 1.0, 1.0);
    let [global, direct] = [1, 2].map(|column| Curve::new(SUN, column));
    let cosine = 11.2_f64.to_radians().cos();
    let of_sky = |doppler: f64| {
        let share = |nm: f64| 1.0 - cosine * direct.at(nm) / global.at(nm).max(1e-30);
        balanced(xyz(&share, doppler, 1.0), white_at_rest)
    };
    let at_rest = of_sky(1.0);
    let brightest = at_rest.into_iter().fold(0.0, f64::max);
    for doppler in doppler_factors() {
        let octaves = doppler.log2();
        let white = balanced(xyz(&|_| 1.0, doppler, 1.0), white_at_rest);
        let whitest = on_screen(white).into_iter().fold(0.0, f64::max);
        let expected = of_sky(doppler).map(|part| part / brightest / whitest);
        let [paint, beside] =
            [colour(Paint::Smooth(at_rest.map(|part| part / brightest)), octaves), sky_beside_paint(octaves)];
        let found = std::array::from_fn(|part| paint[part] + beside[part]);
        let off = levels(found, expected);
        assert!(off < 1.0, "at {doppler}: {off} levels, {found:?} for {expected:?}");
    }
    assert!((share_of_sky(at_rest) / brightest - 1.0).abs() < 1e-3);
    assert_eq!([[0.0, 0.5, 0.5], [0.9, 0.8, 0.7]].map(share_of_sky), [0.0; 2]);
}

/// Far above the data daylight is as the light of anything hot: its colour stays, and it rises as D.
#[test]
fn beyond_the_data_white_rises_as_the_doppler_factor() {
    for octaves in [4.0, 6.0, 9.0, 40.0] {
        let step = log2_level(octaves + 1.0) - log2_level(octaves);
        assert!((step - 1.0).abs() < 1e-3, "2^{octaves}: {step}");
    }
}

/// The stand-in of paint that is lit with another Doppler factor than it is seen with.
#[test]
fn paint_in_moving_light_is_off_by_as_much_as_is_stated() {
    let white_at_rest = xyz(&|_| 1.0, 1.0, 1.0);
    for (lit, stated) in [(1.0, 1.0), (0.9, 12.0), (1.1, 35.0), (0.7, 20.0), (1.5, 26.0)] {
        let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        for material in Material::ALL {
            for seen in [0.7, 0.85, 1.0, 1.15, 1.3, 1.5, 1.75, 2.0] {
                let [out, both] = [seen, seen * lit].map(f64::log2);
                let paint = Paint::Measured(material);
                let stand_in = in_daylight(paint, out);
                let [there, smooth] = [both, out].map(|octaves| lit_by_shifted(stand_in, octaves));
                let own = colour(paint, out);
                let found = std::array::from_fn(|part| there[part] + own[part] - smooth[part]);
                let white = balanced(xyz(&|_| 1.0, seen, lit), white_at_rest);
                let whitest = on_screen(white).into_iter().fold(0.0, f64::max);
                let of = xyz(&reflectance(material), seen, lit);
                let expected = balanced(of, white_at_rest).map(|part| part / whitest);
                let off = levels(found, expected);
                (worst, sum, count) = (worst.max(off), sum + off, count + 1.0);
            }
        }
        println!("lit at {lit}: {worst:.1} levels off at most, {:.1} on average", sum / count);
        assert!(worst < stated && sum / count < 2.0, "lit at {lit}: {worst}");
    }
}
