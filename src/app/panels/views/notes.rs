//! Notes on a picture: where it is not what an eye would see, drawn exactly, and why a part of it is dark.

use eframe::egui::Ui;
use relativity_render::{Camera, Colour, Geometry, Method, Projection, StreetColours};

use crate::app::panels::BETWEEN_NOTES;
use crate::app::state::State;
use crate::app::state::document::Document;
use crate::app::views::eyes::ShownPicture;
use crate::app::views::panes::EyePane;
use crate::caption;
use crate::eye::Eye;
use crate::number_text;
use crate::settings::LightSettings;

/// Returns a note on the picture, where it is not what an eye would see, drawn exactly.
pub fn note(state: &State, eye: Eye, picture: Option<ShownPicture>, with_heat_map: bool) -> String {
    let [geometry, model, colour, street] = notes_on_light(state, eye);
    let projection = projection_note(&state.view(eye, state.frame.picture.size).camera);
    let method = picture.and_then(|picture| drawn_by(state, eye, picture.method));
    let heat_map = with_heat_map.then(|| "difference to the reference".to_owned());
    let coarseness = picture.and_then(coarseness);
    joined([readiness(state), geometry, model, projection, colour, street, method, coarseness, heat_map])
}

/// Returns the notes on the picture in `pane` for an audience, which are not about how it was drawn.
pub fn note_for_audience(ui: &Ui, state: &State, pane: EyePane) -> String {
    let notes = [readiness(state)].into_iter().chain(notes_on_light(state, pane.eye));
    joined(notes.chain([unseen(ui, state, pane)]))
}

/// Says how coarse a picture is that no frame has the time for: one by the packets only while it moves.
fn coarseness(picture: ShownPicture) -> Option<String> {
    let side = picture.coarseness;
    let when = if picture.method == Method::Packets { " while it moves" } else { ", without a fast GPU" };
    (side > 1).then(|| format!("coarse{when}: {side} x {side} pixels as one"))
}

/// Says while it is so that T waits for what draws the picture.
fn readiness(state: &State) -> Option<String> {
    state.frame.is_getting_ready.then(|| "getting ready".to_owned())
}

fn joined(notes: impl IntoIterator<Item = Option<String>>) -> String {
    notes.into_iter().flatten().collect::<Vec<_>>().join(BETWEEN_NOTES)
}

/// Notes on the geometry, the model, the bodies' light and the street's, where they are not what an eye would
/// see.
fn notes_on_light(state: &State, eye: Eye) -> [Option<String>; 4] {
    let geometry = match state.document.settings.geometry() {
        Geometry::Seen | Geometry::Published => None,
        Geometry::OneCone => Some("one light cone for both eyes".to_owned()),
        Geometry::Contracted => Some("contracted only".to_owned()),
        Geometry::Rest => Some("at rest".to_owned()),
    };
    let model = state.sees_as_published(eye).then(|| "as published".to_owned());
    let colour = colour_note(state).map(str::to_owned);
    let street = street_note(state).map(str::to_owned);
    [geometry, model, colour, street]
}

/// Whether a picture has bodies beside the street and the rider's own bicycle: on a ride those that move.
fn has_lit_bodies(state: &State) -> bool {
    let Document { scene, settings, .. } = &state.document;
    !settings.ride.is_on() || scene.passing().any(|group| settings.velocity(group.motion).speed.beta() > 0.0)
}

/// Names the light where it is not that of the bodies alone.
fn colour_note(state: &State) -> Option<&'static str> {
    let (light, geometry) = (&state.document.settings.light, state.document.settings.geometry());
    let on_street = light.doppler_shift && geometry.has_doppler_effect();
    match light.colour {
        Colour::OneWavelength | Colour::Glowing => None,
        Colour::False => Some("false colour"),
        _ if !has_lit_bodies(state) => None,
        Colour::StreetDaylight if on_street => Some("lit by the street's daylight"),
        Colour::White | Colour::StreetDaylight => Some("lit by a lamp that rides along"),
    }
}

/// Names the street's colours where they are not those that are received.
fn street_note(state: &State) -> Option<&'static str> {
    let settings = &state.document.settings;
    let LightSettings { colour, street_colours, doppler_shift, .. } = settings.light;
    let is_seen = settings.ride.is_on() && settings.geometry().has_doppler_effect();
    match street_colours {
        _ if !is_seen || colour == Colour::False => None,
        StreetColours::Received => None,
        StreetColours::Shifted if doppler_shift => Some("street brightness evened out"),
        StreetColours::Shifted | StreetColours::Painted => Some("street as painted"),
    }
}

/// Names the projection where a picture of another one would look different.
fn projection_note(camera: &Camera) -> Option<String> {
    let stretch = camera.stretch();
    let times = number_text::trimmed(stretch, 1);
    let note = match camera.projection {
        Projection::Mercator { .. } => "conformal".to_owned(),
        Projection::Gaze => format!("camera: corners stretched {times} times"),
        Projection::Parallel { .. } => format!("flat screens: corners stretched {times} times"),
        Projection::Vr180 { .. } => return None,
    };
    (stretch > NOTICEABLE_STRETCH).then_some(note)
}

/// The least stretch at which pictures of two projections look different.
const NOTICEABLE_STRETCH: f64 = 1.15;

/// Returns the method that has drawn the picture, where that was set or is further off than can be seen.
fn drawn_by(state: &State, eye: Eye, drawn: Method) -> Option<String> {
    let view = state.view(eye, state.frame.picture.size);
    let Some(set) = state.document.settings.quality.method() else {
        let choice = state.choice(view.geometry)?;
        return (choice.error_px > UNSEEN_PX || !choice.holds).then(|| format!("automatic: {choice}"));
    };
    match drawn {
        Method::Rays if set == Method::Rays => None,
        Method::Rays => Some("rays, until the reference is done".to_owned()),
        Method::Packets => Some("packets".to_owned()),
        Method::Mesh => {
            Some(format!("mesh within {} px", number_text::trimmed(Method::mesh_error_px(&view), 3)))
        }
        Method::Reference => Some("reference".to_owned()),
    }
}

/// Greatest error that is not mentioned in the picture, pixels.
const UNSEEN_PX: f64 = 0.1;

/// Returns the note on light that eyes do not see.
pub fn unseen(ui: &Ui, state: &State, pane: EyePane) -> Option<String> {
    let appearance = state.appearance(!ui.visuals().dark_mode);
    let shares = state.document.prepared.received_shares(&state.view(pane.eye, pane.size), &appearance);
    caption::notice(&shares, state.document.settings.light.invisible)
}

#[cfg(test)]
mod tests {

    use super::*;
    use crate::accuracy::Choice;
    use crate::flags::Goal;
    use crate::flags::choices::RendererChoice;
    use crate::scene::Scene;
    use crate::settings::{Preset, Settings};

    /// The note appears where an error can be seen, and where a goal is not kept.
    #[test]
    fn a_view_says_what_automatic_quality_costs_it() {
        let mut state = State::new(Settings::default(), Scene::default());
        let (goal, is_measured) = (Goal::Budget(16.0), true);
        let choice = Choice { method: Method::Mesh, error_px: 0.5, ms: 4.0, is_measured, goal, holds: true };
        let said = |state: &mut State, choice: Choice| {
            state.frame.choices = vec![(Geometry::Seen, choice)];
            drawn_by(state, Eye::Left, choice.method)
        };
        assert_eq!(said(&mut state, choice).as_deref(), Some("automatic: mesh, 4.0 ms of 16, within 0.5 px"));
        let exact = Choice { method: Method::Packets, error_px: 0.002, ..choice };
        assert_eq!(said(&mut state, exact), None);
        let late = Choice { ms: 40.0, holds: false, ..exact };
        let expected = "automatic: packets, 40 ms, within 0.002 px; no method keeps 16 ms";
        assert_eq!(said(&mut state, late).as_deref(), Some(expected));
        // What is set is said unless it is the rays.
        state.document.settings.quality.renderer = RendererChoice::Packets;
        assert_eq!(drawn_by(&state, Eye::Left, Method::Packets).as_deref(), Some("packets"));
        state.document.settings.quality.renderer = RendererChoice::Rays;
        assert_eq!(drawn_by(&state, Eye::Left, Method::Rays), None);
        // The packets stand in for the rays where a device has no room for a scene's models.
        assert_eq!(drawn_by(&state, Eye::Left, Method::Packets).as_deref(), Some("packets"));
    }

    /// In most rides nothing moves but the rider, and so nothing is lit otherwise than it; in one of them
    /// a cyclist is overtaken.
    #[test]
    fn the_light_of_moving_bodies_is_named_where_some_move() {
        let cases = [
            ("ride-seasons", None),
            ("ride-lamps", None),
            ("ride-post-office", None),
            ("ride-overtaking", Some("lit by a lamp that rides along")),
            ("real-light", Some("lit by the street's daylight")),
        ];
        for (name, note) in cases {
            let settings = Preset::named(name).expect("a preset").settings.clone();
            let state = State::open(settings).expect("it opens");
            assert_eq!(colour_note(&state), note, "{name}");
        }
    }
}
