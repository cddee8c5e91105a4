//! Text for the clipboard: commands that give the same picture or the same numbers, and the numbers.

use relativity_core::{Model, Source, Speed, SpeedError, Turning, WheelPoint};
use relativity_render::Motion;

use crate::app::state::State;
use crate::columns::{GivenInputs, ModelArgs, Observation, ROLL, TURN, WHEEL, degrees};
use crate::flags::words::Shell;
use crate::flags::{SpeedParameter, SpeedSetting};

/// Number of T in the copied command of a curve.
const SAMPLES: u32 = 201;

/// Why there are no numbers of a point by a command.
const BACKWARD: &str = "`gamow curve` and `gamow eval` need a point that moves towards +x, and the selected one moves the \
        other way.";

/// Why there are none of a point on a wheel that does not roll.
const SLIPS: &str = "`gamow curve` and `gamow eval` know only wheels that roll, and that of the selected \
    point turns at a speed of its own.";

/// Returns `speed` as beta, or as rapidity where beta does not express all of it.
fn speed_setting(speed: Speed) -> Result<SpeedSetting, SpeedError> {
    let as_beta = SpeedSetting::new(SpeedParameter::Beta, speed.beta()).ok();
    let exact = as_beta.filter(|setting| setting.speed() == speed);
    exact.map_or_else(|| SpeedSetting::new(SpeedParameter::Rapidity, speed.rapidity()), Ok)
}

impl State {
    /// Returns the selected point at T for `gamow curve` and `gamow eval`: the speed as it was given, and the
    /// rest.
    fn observation_for_command(&self) -> Result<(SpeedSetting, Observation), String> {
        let point = self.document.points.selected();
        if self.velocity(point).is_backward {
            return Err(BACKWARD.to_owned());
        }
        let speed = match point.track.motion {
            Motion::Scene => self.document.settings.motion.speed,
            Motion::WithEyes => SpeedSetting::REST,
            Motion::Own(own) => speed_setting(own.speed).map_err(|error| error.to_string())?,
        };
        let baseline = self.document.settings.baseline();
        let observation =
            Observation::at_rest(speed.speed(), self.selected_source(), baseline, self.document.time);
        match observation.source {
            Source::Wheel(WheelPoint { turning: Turning::RimSpeed(_), .. }) => Err(SLIPS.to_owned()),
            _ => Ok((speed, observation)),
        }
    }

    fn model_args(&self) -> ModelArgs {
        let intensity_exponent = self.document.settings.light.intensity_exponent.0.unwrap_or_default();
        let model = self.document.settings.shown_model();
        // The paper's lines of sight meet nowhere.
        let (stereo, conformal) =
            (!matches!(model, Model::Published(_)), self.document.settings.plots.is_conformal());
        ModelArgs { model, intensity_exponent, stereo, conformal }
    }

    /// The `gamow curve` command that gives the numbers of the selected point's curves over the range of T.
    ///
    /// # Errors
    ///
    /// Why there is none.
    pub fn curve_command(&self) -> Result<String, String> {
        let (speed, observation) = self.observation_for_command()?;
        let ModelArgs { model, intensity_exponent, stereo, conformal } = self.model_args();
        let stereo = if stereo { " --stereo" } else { "" };
        let conformal = if conformal { " --conformal" } else { "" };
        let motion = self.document.settings.motion;
        let [from, to] = self.time_range();
        let point = observation.source.place();
        let (parameter, value) = speed.given();
        let numbers = [
            (parameter.name(), value),
            ("d", motion.d),
            ("roll", motion.roll),
            ("turn", motion.turn),
            ("y", point.y),
            ("z", point.z),
            ("x0", point.x0),
            ("from", from),
            ("to", to),
            ("intensity-exponent", intensity_exponent),
        ];
        let wheel = on_wheel(observation.source);
        let flag = |(name, value): (&str, f64)| {
            format!(" --{}={}", name.replace('_', "-"), Shell::here().quoted(&value.to_string()))
        };
        let flags: String = numbers.into_iter().chain(wheel).map(flag).collect();
        Ok(format!("gamow curve{flags} --model={}{stereo}{conformal} --samples={SAMPLES}", model.name()))
    }

    /// Returns the values of `gamow eval --stereo` for the selected point at T: the names and the numbers, a
    /// line each, between tabs.
    ///
    /// # Errors
    ///
    /// Why there are none.
    pub fn values_as_table(&self) -> Result<String, String> {
        let (speed, observation) = self.observation_for_command()?;
        let model = self.model_args();
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let wheel = on_wheel(observation.source);
        let given = GivenInputs { is_turned: true, on_wheel: !wheel.is_empty(), is_riding: false };
        let columns = model.columns(given).map_err(|error| told(&error))?;
        let values = model.values(&observation, given).map_err(|error| told(&error))?;
        let (point, baseline) = (observation.source.place(), observation.baseline);
        let (parameter, value) = speed.given();
        let inputs = [
            (parameter.name(), value),
            ("d", baseline.separation),
            (ROLL, degrees(baseline.roll)),
            (TURN, degrees(baseline.turn)),
            ("y", point.y),
            ("z", point.z),
            ("x0", point.x0),
            ("T", self.document.time),
        ];
        let inputs = || inputs.into_iter().chain(wheel.iter().copied());
        let all = || inputs().chain(columns.iter().copied().zip(values.iter().copied()));
        let names: Vec<&str> = all().map(|(name, _)| name).collect();
        // Where lines of sight do not meet there is no number.
        let number = |value: f64| if value.is_nan() { String::new() } else { value.to_string() };
        let numbers: Vec<String> = all().map(|(_, value)| number(value)).collect();
        Ok(format!("{}\n{}\n", names.join("\t"), numbers.join("\t")))
    }
}

/// Returns the place of a point on its wheel, by the names of the columns; nothing for a point on none.
fn on_wheel(source: Source) -> Vec<(&'static str, f64)> {
    match source {
        Source::Point(_) => Vec::new(),
        Source::Wheel(WheelPoint { radius, rho, angle, .. }) => {
            WHEEL.into_iter().zip([radius, rho, angle]).collect()
        }
    }
}
