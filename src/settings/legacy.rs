//! Settings as the window saved them up to version 0.1: in RON, with other names, and angles in radians.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::all::Settings;

/// Settings of before. Values are words, numbers, or groups of them.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum Legacy {
    /// Yes or no.
    Switch(bool),
    /// A number.
    Number(f64),
    /// One of several choices.
    Word(String),
    /// First and last.
    List(Vec<f64>),
    /// Several by their names.
    Group(BTreeMap<String, Legacy>),
    /// One that may be missing.
    Optional(Option<Plain>),
}

/// What may be missing. (No [`Legacy`]: what is none would be looked for in itself without end.)
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum Plain {
    /// A number.
    Number(f64),
    /// First and last.
    List(Vec<f64>),
}

impl Plain {
    /// As a flag has it.
    fn text(&self) -> String {
        match self {
            Self::Number(number) => number.to_string(),
            Self::List(items) => items.iter().map(f64::to_string).collect::<Vec<_>>().join(","),
        }
    }
}

/// Where each setting was, and what it is called now. Those of speed and gaze were in groups of their own.
const NAMES: [([&str; 2], &str); 32] = [
    (["motion", "separation"], "d"),
    (["motion", "depth_shift"], "depth-shift"),
    (["motion", "height_shift"], "height-shift"),
    (["look", "geometry"], "geometry"),
    (["look", "fov_degrees"], "fov"),
    (["light", "colour"], "colour"),
    (["light", "doppler_shift"], "doppler-shift"),
    (["light", "intensity_exponent"], "intensity-exponent"),
    (["light", "exposure_ev"], "exposure"),
    (["light", "shading"], "shading"),
    (["light", "ground"], "ground"),
    (["light", "sky"], "sky"),
    (["quality", "bound_px"], "bound-px"),
    (["quality", "heat_map"], "heat-map"),
    (["playback", "rate"], "rate"),
    (["playback", "looping"], "looping"),
    (["playback", "range"], "range"),
    (["plots", "tab"], "plot"),
    (["plots", "published"], "published"),
    (["fit", "samples"], "fit-samples"),
    (["fit", "range"], "fit-range"),
    (["fit", "noise_percent"], "noise-percent"),
    (["fit", "seed"], "seed"),
    (["fit", "curves"], "curves"),
    (["fit", "model"], "model"),
    (["fit", "fit_x0"], "fit-x0"),
    (["window", "views"], "views"),
    (["window", "corrected"], "corrected"),
    (["window", "plots"], "plots"),
    (["window", "controls"], "controls"),
    (["window", "readout"], "readout"),
    (["window", "theme"], "theme"),
];

impl Legacy {
    /// The settings as they are now, as usual where they cannot be; and what cannot, a line each.
    #[must_use]
    pub fn settings(&self) -> (Settings, Vec<String>) {
        let mut settings = Settings::default();
        let set = |flag| settings.set(vec![flag]).err().map(|problem| problem.text);
        let problems = self.flags().into_iter().filter_map(set).collect();
        (settings, problems)
    }

    fn flags(&self) -> Vec<String> {
        let mut flags: Vec<String> = NAMES
            .iter()
            .filter_map(|(path, name)| Some(format!("--{name}={}", self.at(path)?.text_of(name)?)))
            .collect();
        let more = [self.speed(), self.gaze(), self.renderer(), self.published_right_eye()];
        flags.extend(more.into_iter().flatten());
        flags
    }

    fn speed(&self) -> Option<String> {
        let text = |key| self.at(&["motion", "speed", key])?.text();
        Some(format!("--{}={}", text("parameter")?, text("value")?))
    }

    fn gaze(&self) -> Option<String> {
        if self.at(&["look", "gaze"])? == &Self::Word("Track".to_owned()) {
            return Some("--gaze=point".to_owned());
        }
        let degrees = |key| match self.at(&["look", "gaze", "Fixed", key])? {
            Self::Number(radians) => Some(radians.to_degrees()),
            _ => None,
        };
        Some(format!("--gaze={},{}", degrees("azimuth")?, degrees("elevation")?))
    }

    /// The rays were what is automatic now.
    fn renderer(&self) -> Option<String> {
        let renderer = self.at(&["quality", "renderer"])?.text()?;
        (renderer != "exact").then(|| format!("--renderer={renderer}"))
    }

    fn published_right_eye(&self) -> Option<String> {
        let is_seen = self.at(&["look", "geometry"]).and_then(Self::text).is_none_or(|word| word == "seen");
        let is_published = self.at(&["look", "right_as_published"]) == Some(&Self::Switch(true));
        (is_seen && is_published).then(|| "--geometry=published".to_owned())
    }

    fn at(&self, path: &[&str]) -> Option<&Self> {
        match (path, self) {
            ([], _) => Some(self),
            ([key, rest @ ..], Self::Group(group)) => group.get(*key)?.at(rest),
            _ => None,
        }
    }

    /// As the flag of this name has it.
    fn text_of(&self, name: &str) -> Option<String> {
        let is_fitted = self == &Self::Optional(None) && name.ends_with("range");
        if is_fitted { Some("auto".to_owned()) } else { self.text() }
    }

    /// As a flag has it.
    fn text(&self) -> Option<String> {
        match self {
            Self::Switch(is_on) => Some(if *is_on { "on" } else { "off" }.to_owned()),
            Self::Number(number) => Some(number.to_string()),
            Self::Word(word) => Some(match word.as_str() {
                "Azimuth" => "dphi".to_owned(),
                "Polar" => "dtheta".to_owned(),
                _ => word.to_lowercase(),
            }),
            Self::List(items) => Some(Plain::List(items.clone()).text()),
            Self::Optional(value) => Some(value.as_ref().map_or_else(|| "off".to_owned(), Plain::text)),
            Self::Group(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use relativity_core::{Curves, Model, PublishedVariant};
    use relativity_render::{Colour, Geometry, Shading};

    use super::*;
    use crate::flags::choices::{GazeChoice, RendererChoice};
    use crate::flags::{Exposure, FieldOfView, IntensityExponent, SpeedParameter, TimeRange};
    use crate::settings::{PlotTab, Theme};

    /// As the window saved it.
    const SAVED: &str = "(motion:(speed:(parameter:Gamma,value:1000000000000.0),separation:0.25,depth_shift:-1.5,\
        height_shift:0.5),look:(geometry:Contracted,right_as_published:true,gaze:Fixed(azimuth:1.5707963267948966,\
        elevation:-0.5),fov_degrees:45.0),light:(colour:False,doppler_shift:false,intensity_exponent:Some(4.0),\
        exposure_ev:1.5,shading:Emission,sky:false,ground:true),quality:(renderer:Mesh,bound_px:2.0,heat_map:true),\
        playback:(rate:0.5,looping:false,range:Some((-1.0,2.5))),plots:(tab:Angles,published:true),fit:(samples:100,\
        range:None,noise_percent:2.0,seed:7,curves:Azimuth,model:Published,fit_x0:true),window:(views:true,\
        corrected:true,plots:true,controls:false,readout:true,theme:System))";

    struct Storage(HashMap<String, String>);

    impl eframe::Storage for Storage {
        fn get_string(&self, key: &str) -> Option<String> {
            self.0.get(key).cloned()
        }
        fn set_string(&mut self, _: &str, _: String) {}
        fn remove_string(&mut self, _: &str) {}
        fn flush(&mut self) {}
    }

    fn settings(saved: &str) -> Settings {
        let storage = Storage(HashMap::from([(eframe::APP_KEY.to_owned(), saved.to_owned())]));
        let (settings, problems) =
            eframe::get_value::<Legacy>(&storage, eframe::APP_KEY).expect("it can be read").settings();
        assert!(problems.is_empty(), "{problems:?}");
        settings
    }

    #[test]
    fn settings_saved_before_still_open() {
        let Settings { motion, look, light, quality, playback, plots, fit, window, .. } = settings(SAVED);
        assert_eq!(motion.speed.given(), (SpeedParameter::Gamma, 1e12));
        assert_eq!((motion.d, motion.depth_shift, motion.height_shift), (0.25, -1.5, 0.5));
        assert_eq!((look.geometry, look.fov), (Geometry::Contracted, FieldOfView(Some(45.0))));
        assert_eq!(look.gaze, GazeChoice::Fixed([90.0, (-0.5f64).to_degrees()]));
        assert_eq!(
            (light.colour, light.shading, light.exposure),
            (Colour::False, Shading::Emission, Exposure(Some(1.5)))
        );
        assert_eq!(light.intensity_exponent, IntensityExponent(Some(4.0)));
        assert_eq!((light.doppler_shift, light.sky, light.ground), (false, false, true));
        assert_eq!((quality.renderer, quality.bound_px, plots.heat_map), (RendererChoice::Mesh, 2.0, true));
        assert_eq!(
            (playback.rate, playback.looping, playback.range),
            (0.5, false, TimeRange(Some([-1.0, 2.5])))
        );
        assert_eq!((plots.plot, plots.published), (PlotTab::Angles, true));
        assert_eq!(
            (fit.fit_samples, fit.fit_range, fit.noise_percent, fit.seed),
            (100, TimeRange(None), 2.0, 7)
        );
        assert_eq!(
            (fit.curves, fit.model, fit.fit_x0),
            (Curves::Azimuth, Model::Published(PublishedVariant::AppendixA), true)
        );
        assert_eq!((window.corrected, window.controls, window.theme), (true, false, Theme::System));
    }

    #[test]
    fn what_is_no_setting_is_refused() {
        for text in
            ["(motion:[true])", "[(1.0, \"x\")]", "(fit:(samples:Some(\"x\")))", "[[[[[]]]]]", "('x')"]
        {
            let read = ron::from_str::<Legacy>(text);
            assert!(
                read.is_err() || read.is_ok_and(|legacy| legacy.settings().0 == Settings::default()),
                "{text}"
            );
        }
    }

    #[test]
    fn a_gaze_that_tracked_the_point_still_does() {
        let fixed = "Fixed(azimuth:1.5707963267948966,elevation:-0.5)";
        assert!(SAVED.contains(fixed));
        assert_eq!(settings(&SAVED.replace(fixed, "Track")).look.gaze, GazeChoice::Point);
    }

    #[test]
    fn the_published_right_eye_was_a_switch_beside_the_geometry() {
        let seen = SAVED.replace("Contracted", "Seen").replace("Some(4.0)", "None").replace("Mesh", "Exact");
        let settings = settings(&seen);
        assert_eq!(settings.look.geometry, Geometry::Published);
        assert_eq!(settings.light.intensity_exponent, IntensityExponent(None));
        assert_eq!(settings.quality.renderer, RendererChoice::Auto);
    }
}
