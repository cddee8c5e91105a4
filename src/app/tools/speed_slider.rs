//! The speed on screen: as text, and by a slider that is finer towards 1.

use relativity_core::math;

use crate::flags::{SpeedParameter, SpeedSetting};
use crate::number_text;

/// Rapidity at the right end of the slider: beta = 0.999 995.
const SLIDER_MAX_RAPIDITY: f64 = 6.5;
/// Rapidity grows as this power of the slider's position. With it 0.5, 0.9, 0.99, 0.999 and 0.9999 lie at
/// 0.19, 0.37, 0.55, 0.70 and 0.83 of the way: evenly, with room for slow speeds.
const SLIDER_POWER: f64 = 1.5;

impl SpeedSetting {
    /// `parameter` of this speed: digit for digit if it was given so, else to six digits.
    #[must_use]
    pub fn text(&self, parameter: SpeedParameter) -> String {
        let (given, value) = self.given();
        match parameter {
            _ if parameter == given => number_text::shortest(value),
            SpeedParameter::Beta => number_text::beta(&self.speed()),
            SpeedParameter::Gamma => number_text::significant(self.speed().gamma(), 6),
            SpeedParameter::Rapidity => number_text::significant(self.speed().rapidity(), 6),
        }
    }

    /// The speed at `position` (0 to 1) of the slider, rounded to a beta that is easy to read.
    #[must_use]
    pub fn at_slider_position(position: f64) -> Self {
        let rapidity = SLIDER_MAX_RAPIDITY * math::powf(position.clamp(0.0, 1.0), SLIDER_POWER);
        let beta = readable_beta(math::tanh(rapidity));
        // The slider ends below the speed of light.
        Self::new(SpeedParameter::Beta, beta).unwrap_or(Self::REST)
    }

    /// Returns the position (0 to 1) of this speed on the slider.
    #[must_use]
    pub fn slider_position(&self) -> f64 {
        math::powf((self.speed().rapidity() / SLIDER_MAX_RAPIDITY).min(1.0), 1.0 / SLIDER_POWER)
    }

    /// The speed `steps` hundredths of the slider further on.
    #[must_use]
    pub fn nudged(&self, steps: i32) -> Self {
        let position = self.slider_position() + f64::from(steps) / 100.0;
        let next = Self::at_slider_position(position);
        // Beyond the slider's end only a step down leads back.
        let beyond = self.speed().rapidity() > SLIDER_MAX_RAPIDITY && steps > 0;
        if beyond { *self } else { next }
    }
}

/// `beta` rounded to a hundredth of the decade that 1 - beta has reached: 0.37, 0.904, 0.9904.
fn readable_beta(beta: f64) -> f64 {
    let inverse_unit = math::powf(10.0, 2.0 - math::log10(1.0 - beta).ceil());
    let rounded = (beta * inverse_unit).round() / inverse_unit;
    if rounded < 1.0 { rounded } else { beta }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beta(value: f64) -> SpeedSetting {
        SpeedSetting::new(SpeedParameter::Beta, value).expect("in range")
    }

    #[test]
    fn slider_reaches_the_usual_speeds_exactly() {
        for value in [0.0, 0.1, 0.5, 0.6, 0.9, 0.99, 0.999, 0.9999] {
            let there = SpeedSetting::at_slider_position(beta(value).slider_position());
            assert_eq!(there.speed().beta(), value);
        }
    }

    #[test]
    fn slider_never_reaches_light_and_never_turns_back() {
        let mut last = -1.0;
        for step in 0..=1000 {
            let beta = SpeedSetting::at_slider_position(f64::from(step) / 1000.0).speed().beta();
            assert!(beta >= last && beta < 1.0);
            last = beta;
        }
    }

    #[test]
    fn a_nudge_always_moves_inside_the_slider() {
        let mut setting = beta(0.0);
        for _ in 0..95 {
            let next = setting.nudged(1);
            assert!(next.speed().beta() > setting.speed().beta());
            setting = next;
        }
        let fast = SpeedSetting::new(SpeedParameter::Gamma, 1e12).expect("in range");
        assert_eq!(fast.nudged(1), fast);
        assert!(fast.nudged(-1).speed().gamma() < 1e12);
    }
}
