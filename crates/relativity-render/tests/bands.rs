//! A picture that is drawn band by band: the same pixels as all at once.

use relativity_core::Speed;
use relativity_render::{Appearance, PreparedScene};

use crate::scenes::{crowd, view_following};

#[test]
fn the_bands_of_a_picture_are_the_picture() {
    let mut view = view_following([0.0, 3.0, 0.5], Speed::from_beta(0.6).expect("below 1"), 0.3, 90.0);
    // The last band has five rows.
    view.camera.size = [40, 37];
    let (scene, appearance) = (PreparedScene::moving(&crowd(64)), Appearance::default());
    for samples in [1, 2] {
        let bands: Vec<_> =
            [0, 16, 32, 48].map(|first| scene.picture_band(&view, &appearance, samples, first)).into();
        assert_eq!(bands.iter().map(Vec::len).collect::<Vec<_>>(), [640, 640, 200, 0]);
        assert!(bands[1].iter().any(|pixel| *pixel != bands[1][0]), "it shows something");
        assert_eq!(bands.concat(), scene.picture(&view, &appearance, samples).rgba);
    }
}
