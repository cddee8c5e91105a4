//! Costs of effects: the same view with one after the other left out.

use relativity_render::{Appearance, Geometry, GpuError, Method, PreparedScene, Renderers, Shading, View};

use super::report::{Circumstances, EffectRow, EffectsReport};
use crate::accuracy::{frame_ms, methods};

/// Number of times that each picture is timed; in turns, so that all meet the same disturbances.
const TURNS: u32 = 6;

/// Name of an effect, and how it is left out.
type Effect = (&'static str, fn(&mut View, &mut Appearance));

const EFFECTS: [Effect; 7] = [
    ("Doppler shift of colour", |_, appearance| appearance.doppler_shift = false),
    ("intensity D^n", |_, appearance| appearance.intensity_exponent = None),
    ("shading of form", |_, appearance| appearance.shading = Shading::Emission),
    ("ground grid", |_, appearance| appearance.ground_z = None),
    ("sky gradient", |_, appearance| appearance.sky = false),
    ("delay of light (contracted only)", |view, _| view.geometry = Geometry::Contracted),
    ("all of these", |view, appearance| {
        view.geometry = Geometry::Contracted;
        *appearance = Appearance {
            doppler_shift: false,
            intensity_exponent: None,
            shading: Shading::Emission,
            ground_z: None,
            sky: false,
            ..*appearance
        };
    }),
];

/// Times `view` of `scene` with everything on and with effects left out, by rays if there is a GPU.
pub fn report(
    renderers: &mut Renderers,
    scene: &PreparedScene,
    circumstances: Circumstances,
    view: &View,
    appearance: &Appearance,
    rounds: u32,
) -> anyhow::Result<EffectsReport> {
    let has_rays = methods(renderers).contains(&Method::Rays);
    let method = if has_rays { Method::Rays } else { Method::Reference };
    let mut pictures = vec![(*view, *appearance)];
    for (_, leave_out) in EFFECTS {
        let (mut view, mut appearance) = (*view, *appearance);
        leave_out(&mut view, &mut appearance);
        pictures.push((view, appearance));
    }
    // Once more, to tell what the machine's other work does to the figures.
    pictures.push((*view, *appearance));
    let mut fastest = vec![f64::INFINITY; pictures.len()];
    for _ in 0..TURNS {
        for (fastest, (view, appearance)) in fastest.iter_mut().zip(&pictures) {
            let frame_ms: Result<_, GpuError> = frame_ms(renderers, method, scene, view, appearance, rounds);
            *fastest = fastest.min(frame_ms?);
        }
    }
    let all_on_ms = fastest[0];
    let row = |(i, (effect, _)): (usize, &Effect)| EffectRow {
        effect,
        same_geometry: pictures[i + 1].0.geometry == view.geometry,
        frame_ms: fastest[i + 1],
        ratio: fastest[i + 1] / all_on_ms,
    };
    Ok(EffectsReport {
        method: method.to_string(),
        view: circumstances,
        all_on_ms,
        repeatability: (fastest[fastest.len() - 1] / all_on_ms - 1.0).abs(),
        without: EFFECTS.iter().enumerate().map(row).collect(),
    })
}
