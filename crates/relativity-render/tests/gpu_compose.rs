//! Both eyes' pictures composed by the GPU, against the same on the CPU.

use relativity_render::picture::compose::Top;
use relativity_render::{Composed, Composer, Composition, EyeTarget, Picture, Renderers};

use crate::gpu_support::Test;

pub const TESTS: &[Test] = &[("compositions_are_those_of_the_cpu", compositions_are_those_of_the_cpu)];

/// Each, and by how many levels of 255 it may be off: none where the eyes' levels are shown again.
const COMPOSITIONS: [(Composition, i32); 7] = [
    (Composition::Anaglyph, 0),
    (Composition::Rows { top: Top::First }, 0),
    (Composition::Rows { top: Top::Second }, 0),
    (Composition::Dubois, 1),
    (Composition::Overlay([[0x56, 0xB4, 0xE9], [0xE6, 0x9F, 0x00]]), 1),
    (Composition::HalfSideBySide, 1),
    (Composition::HalfOverUnder, 1),
];

/// Colours of all sorts, from this seed.
fn picture(size: [u32; 2], seed: u32) -> Picture {
    let mut state = seed;
    let mut level = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    let pixels = size.iter().product::<u32>();
    Picture { size, rgba: (0..pixels).map(|_| [level(), level(), level(), u8::MAX]).collect() }
}

fn compositions_are_those_of_the_cpu(renderers: &mut Renderers) {
    let gpu = renderers.gpu().expect("there is one");
    let composer = Composer::new(gpu);
    for size in [[1, 1], [64, 48], [257, 131]] {
        let pictures = [picture(size, 1), picture(size, 2)];
        let targets = [0, 1].map(|eye: usize| {
            let mut target = EyeTarget::new(gpu, size);
            target.write(gpu, &pictures[eye]);
            target
        });
        for (composition, levels) in COMPOSITIONS {
            let expected = composition.picture([&pictures[0], &pictures[1]]);
            let target = Composed::new(gpu, composition.size(size));
            composer.compose(gpu, composition, [&targets[0], &targets[1]], &target);
            let found = target.rgba8(gpu).expect("the device works");
            assert_eq!((expected.size, expected.rgba.len() * 4), (target.size(), found.len()));
            let off = found.iter().zip(expected.rgba.as_flattened());
            let off = off.map(|(a, b)| (i32::from(*a) - i32::from(*b)).abs()).max().unwrap_or(0);
            assert!(off <= levels, "{composition:?} of {size:?}: {off} levels off");
        }
    }
}
