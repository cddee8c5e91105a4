//! Contact shadows: a soft darkening of a road around the places where bodies touch it.
//!
//! It is a drawn sign of where a body stands, not light that is carried from a lamp: a stain that rides along
//! with the body, at rest in its frame. Each point of the road is darkened by what lay there when the light
//! left it that arrives now. Where body and road touch, that is one event for both: there the shadow is
//! exact, for every eye, whatever is chosen for its size.
//!
//! With the touching place seen at p from the eye and a point of the road at f, e = f - p, the event on the
//! road is gamma (`e_x` + v (|f| - |p|)) along the motion from the touching place in the body's frame,
//! and |f| - |p| = e.(f + p)/(|f| + |p|). So nothing is left of the distance, which can be great there. In a
//! picture without delay v is 0, and gamma contracts the stain. `shaders/backdrop.wgsl` and
//! `cpu/packets/street/contact.rs` draw the same, with the same constants.

use std::array;

use glam::{DVec2, DVec3};

use crate::geometry::shape::Shape;
use crate::geometry::shape::questions::Foot;
use crate::scene::prepared_scene::PreparedScene;
use crate::view::group_view::GroupView;
use crate::view::{Appearance, Geometry};

/// Share of the road's light that a shadow takes where bodies touch the road.
pub(crate) const DARKEST: f64 = 0.85;
/// No shadow is drawn farther away, where haze leaves less than a level of it.
pub(crate) const FARTHEST: f64 = 2000.0;
/// Greatest number of shadows that are drawn: those of the nearest places.
pub(crate) const MOST: usize = 8;
/// A body touches the ground if its lowest point is this near to it, in parts of its radius.
const TOUCH: f64 = 0.02;
/// A body of a greater gamma has none: f32 would overflow in the squares.
const MOST_RAPID: f64 = 1e9;

/// The contacts of bodies with the road in one picture.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Contacts {
    /// From the middle between the eyes to the eye, where both have one light cone, else 0.
    off_middle: DVec3,
    places: [Contact; MOST],
    count: usize,
}

/// The contact of one body with the road.
#[derive(Debug, Clone, Copy, Default)]
struct Contact {
    /// From the eye to where it is seen, on the ground.
    place: DVec2,
    /// Distance by which its light is late.
    distance: f64,
    /// Half the length and the width of the shadow in the body's frame.
    half: DVec2,
    gamma: f64,
    /// gamma times the speed along x at which it moves on while light is on its way.
    rapid: f64,
}

impl Contacts {
    /// Returns those of `scene` as its `views` show them; none without a road.
    pub fn new(scene: &PreparedScene, views: &[GroupView], appearance: &Appearance) -> Self {
        let (Some(ground), Some(_), Some(first)) = (appearance.ground_z, appearance.road, views.first())
        else {
            return Self::default();
        };
        let height = ground - first.camera.aperture.z;
        if height >= 0.0 {
            return Self::default();
        }
        // What rides along elsewhere than along the street leaves none.
        let are_aside: Vec<_> = views.iter().map(GroupView::rides_aside).collect();
        // On the ground, as an eye at rest sees them at the camera's event.
        let Some(views) = views.iter().map(GroupView::seen_from_street).collect::<Option<Vec<_>>>() else {
            return Self::default();
        };
        let is_one_cone = views[0].geometry == Geometry::OneCone;
        let off_middle = if is_one_cone { first.camera.off_middle } else { DVec3::ZERO };
        let feet = scene.bodies().iter().filter_map(|body| {
            let shape = match scene.turning(body.number).filter(|_| body.triangles.is_some()) {
                Some(wheel) => wheel.tyre(),
                None if body.is_turned => return None,
                None => body.shape,
            };
            if are_aside[body.group] {
                return None;
            }
            Some((&views[body.group], foot(&shape, ground)?))
        });
        let mut found: Vec<_> =
            feet.filter_map(|(view, foot)| Contact::new(view, &foot, height, off_middle)).collect();
        found.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let places = array::from_fn(|number| found.get(number).copied().unwrap_or_default());
        Self { off_middle, places, count: found.len().min(MOST) }
    }

    /// Returns the share of a road's light that they leave at `foot` from the eye, of a pixel that is so wide
    /// and deep there.
    pub fn leave(&self, foot: DVec3, pixel: DVec2) -> f64 {
        let from_middle = foot + self.off_middle;
        let distance = from_middle.length();
        if self.count == 0 || distance > FARTHEST {
            return 1.0;
        }
        let [width, depth] = pixel.to_array();
        self.places[..self.count].iter().fold(1.0, |left, contact| {
            let &Contact { place, half, gamma, rapid, .. } = contact;
            let off = foot.truncate() - place;
            let wide = half.y * half.y + depth * depth;
            let mean = (2.0 * from_middle.truncate() - off) / (distance + contact.distance);
            let stretch = DVec2::new(gamma + rapid * mean.x, rapid * mean.y);
            let along = stretch.dot(off);
            let long = half.x * half.x + (stretch * DVec2::new(width, depth)).length_squared();
            let inside = 1.0 - along * along / long - off.y * off.y / wide;
            if inside <= 0.0 {
                return left;
            }
            // What is smaller than a pixel is as wide as that, and as much fainter.
            let thin = half.x * half.y / (long * wide).sqrt();
            left * (1.0 - DARKEST * thin * inside * inside)
        })
    }

    /// Returns `off_middle` and the count, for the shaders.
    pub fn packed_eye(&self) -> [f32; 4] {
        let [x, y, z] = self.off_middle.to_array();
        [x, y, z, self.count as f64].map(|v| v as f32)
    }

    /// Returns the places for the shaders: of each the place, the distance and gamma v; then half the length
    /// and the width, both squared, and gamma.
    pub fn packed(&self) -> [[[f32; 4]; 2]; MOST] {
        self.places.map(|Contact { place, distance, half, gamma, rapid }| {
            [[place.x, place.y, distance, rapid], [half.x * half.x, half.y * half.y, gamma, 0.0]]
                .map(|four| four.map(|v| v as f32))
        })
    }
}

impl Contact {
    /// Returns that of `foot`, where `view` shows it on the ground at this `height` from the eye, if it is
    /// seen there.
    fn new(view: &GroupView, foot: &Foot, height: f64, off_middle: DVec3) -> Option<Self> {
        let place = view.apparent_position(foot.place)?.truncate();
        let distance = (place.extend(height) + off_middle).length();
        let velocity = view.velocity.along_x()?;
        let (gamma, beta) = (velocity.speed.gamma(), velocity.beta());
        let [gamma, rapid] = match view.geometry {
            Geometry::Seen | Geometry::OneCone | Geometry::Published => [gamma, gamma * beta],
            Geometry::Contracted => [gamma, 0.0],
            Geometry::Rest => [1.0, 0.0],
        };
        (distance <= FARTHEST && gamma <= MOST_RAPID).then_some(Self {
            place,
            distance,
            half: foot.half,
            gamma,
            rapid,
        })
    }
}

/// Returns where `shape` touches the ground at this height: a wheel that does not lie flat, a ball or a box.
fn foot(shape: &Shape, ground: f64) -> Option<Foot> {
    shape.foot().filter(|foot| (foot.place.z - ground).abs() <= TOUCH * foot.radius)
}

#[cfg(test)]
mod tests {
    use relativity_core::{Aperture, Speed};

    use super::*;
    use crate::camera::{Camera, Gaze};
    use crate::geometry::shape::ring::SHADOW as WHEEL;
    use crate::kinematics::velocity::{Motion, Velocity};
    use crate::scene::body::Body;
    use crate::scene::prepared_scene::Group;
    use crate::view::View;

    const GROUND: f64 = -2.0;
    const EYE: Aperture = Aperture { x: 0.05, y: 0.0, z: 0.0 };
    const TIME: f64 = 3.0;

    fn wheel(centre: [f64; 3]) -> Shape {
        Shape::Ring { centre, axis: [0.0, 1.0, 0.0], radius: 0.45, tube_radius: 0.05 }
    }

    fn on_road() -> Appearance {
        Appearance { ground_z: Some(GROUND), road: Some([-50.0, 50.0]), ..Appearance::default() }
    }

    fn contacts(
        shapes: &[Shape],
        velocity: Velocity,
        geometry: Geometry,
        appearance: &Appearance,
    ) -> Contacts {
        let bodies: Vec<_> = shapes.iter().map(|shape| Body::new(*shape, 600.0)).collect();
        let scene = PreparedScene::new([Group { motion: Motion::Own(velocity), bodies: &bodies }]);
        let camera = Camera::new(EYE, Gaze::STRAIGHT_AHEAD, 1.0, [8, 8]);
        let view = View { camera, speed: Speed::REST, observation_time: TIME, geometry };
        Contacts::new(&scene, &scene.group_views(&view), appearance)
    }

    /// The road's event, brought into the wheel's frame by the Lorentz transformation as it is written in
    /// every textbook, lies where the shadow says; there it is a resting ellipse.
    #[test]
    fn a_shadow_rests_in_its_bodys_frame() {
        for beta in [-0.95, -0.3, 0.0, 0.6, 0.9, 0.99] {
            let velocity = Velocity::from_beta(beta).expect("below 1");
            for geometry in [Geometry::Seen, Geometry::Contracted] {
                let [x, y] = [-1.5, 4.0];
                let contacts = contacts(&[wheel([x, y, GROUND + 0.5])], velocity, geometry, &on_road());
                for number in 0..400 {
                    let off = DVec2::new(f64::from(number % 20) - 9.5, f64::from(number / 20) - 9.5) * 0.05;
                    let seen = contacts.places[0].place;
                    let foot = (seen + DVec2::new(off.x / velocity.speed.gamma(), off.y)).extend(GROUND);
                    let late = if geometry == Geometry::Seen { foot.length() } else { 0.0 };
                    let at_rest = velocity.speed.gamma() * (foot.x + EYE.x - beta * (TIME - late));
                    let inside = 1.0
                        - ((at_rest - x) / (0.5 * WHEEL[0])).powi(2)
                        - ((foot.y - y) / (0.5 * WHEEL[1])).powi(2);
                    let expected = 1.0 - DARKEST * inside.max(0.0).powi(2);
                    let found = contacts.leave(foot, DVec2::ZERO);
                    assert!(
                        (found - expected).abs() < 1e-12,
                        "{beta} {geometry:?} {off}: {found}, {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn only_what_touches_a_road_darkens_it() {
        let velocity = Velocity::from_beta(0.5).expect("below 1");
        let touching = [
            wheel([0.0, 4.0, GROUND + 0.5]),
            Shape::Sphere { centre: [1.0, 4.0, GROUND + 0.3], radius: 0.3 },
            Shape::Box {
                centre: [2.0, 4.0, GROUND + 0.4],
                half: [0.5, 0.3, 0.4],
                turn: [0.0, 0.0, 0.0, 1.0],
            },
        ];
        let count = |shapes: &[Shape], appearance: &Appearance| {
            contacts(shapes, velocity, Geometry::Seen, appearance).count
        };
        for shape in touching {
            assert_eq!(count(&[shape], &on_road()), 1, "{shape:?}");
            let others = [
                Appearance { road: None, ..on_road() },
                Appearance { ground_z: None, ..on_road() },
                Appearance { ground_z: Some(1.0), ..on_road() },
            ];
            assert!(others.iter().all(|appearance| count(&[shape], appearance) == 0), "{shape:?}");
            let off = [0.1, -0.1, 50.0].map(|up| shape.moved([0.0, 0.0, up]));
            assert_eq!(count(&off, &on_road()), 0, "{shape:?}");
        }
        let lying = Shape::Ring {
            centre: [0.0, 4.0, GROUND + 0.05],
            axis: [0.0, 0.0, 1.0],
            radius: 0.45,
            tube_radius: 0.05,
        };
        let far = wheel([1e6, 4.0, GROUND + 0.5]);
        assert_eq!(count(&[lying, far], &on_road()), 0);
    }

    #[test]
    fn of_many_the_nearest_are_drawn() {
        let wheels: Vec<_> =
            (0..40).map(|number| wheel([f64::from(20 - number), 4.0, GROUND + 0.5])).collect();
        let contacts = contacts(&wheels, Velocity::REST, Geometry::Seen, &on_road());
        assert_eq!(contacts.count, MOST);
        let farthest = contacts.places.iter().fold(0.0_f64, |most, contact| most.max(contact.place.x.abs()));
        assert!(farthest < 5.0, "{farthest}");
    }

    #[test]
    fn every_speed_and_place_leaves_a_share() {
        for rapidity in [0.0, 1.0, 5.0, 12.0, 20.0, 27.0] {
            let velocity = Velocity::forward(Speed::from_rapidity(rapidity).expect("a speed"));
            for geometry in [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest] {
                let contacts = contacts(&[wheel([0.0, 4.0, GROUND + 0.5])], velocity, geometry, &on_road());
                for size in [0.0, 1e-3, 1.0, 1e6] {
                    for x in [-1e9, -10.0, -0.1, 0.0, 3.0, 1e3] {
                        let left = contacts.leave(DVec3::new(x, 4.0, GROUND), DVec2::splat(size));
                        assert!((1.0 - DARKEST..=1.0).contains(&left), "{rapidity} {geometry:?} {x}: {left}");
                    }
                }
            }
        }
    }
}
