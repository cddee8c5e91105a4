//! A game controller in the hands of whoever rides: the left stick pedals, brakes and looks aside, the right one looks around.

use crate::app::state::riding::saddle::PushDirection;
use gamow_platform::sticks::Sticks;

/// A stick that is held nearer to its middle than this rests: springs wear out.
const RESTS: f64 = 0.2;
/// The stick pushes from here on.
const PUSHES: f64 = 0.5;
/// Speed at which a stick at its end turns the gaze, widths of the picture per second.
const PACE: f64 = 0.5;

/// The direction in which the sticks push, if they do.
#[must_use]
pub fn pushed(sticks: &Sticks) -> Option<PushDirection> {
    let [_, ahead] = sticks.left;
    match ahead {
        ahead if ahead > PUSHES => Some(PushDirection::Forwards),
        ahead if ahead < -PUSHES => Some(PushDirection::Backwards),
        _ => None,
    }
}

/// Returns the turn of the gaze in this many `seconds`, in widths of the picture to the right and up; `None` if both sticks rest.
#[must_use]
pub fn looked(sticks: &Sticks, seconds: f64) -> Option<[f64; 2]> {
    let turned = |stick: f64| if stick.abs() < RESTS { 0.0 } else { stick };
    let ([aside, _], [right, up]) = (sticks.left, sticks.right);
    let turned =
        [turned(aside) + turned(right), turned(up)].map(|stick| PACE * seconds * stick.clamp(-1.0, 1.0));
    (turned != [0.0; 2]).then_some(turned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sticks_pedal_brake_and_look() {
        let held = |left, right| Sticks { left, right };
        assert_eq!(pushed(&held([0.0, 0.9], [0.0; 2])), Some(PushDirection::Forwards));
        assert_eq!(pushed(&held([0.9, -0.6], [0.0, 1.0])), Some(PushDirection::Backwards));
        assert_eq!(pushed(&held([1.0, 0.3], [0.0, 1.0])), None);
        assert_eq!(looked(&held([0.1, 1.0], [-0.1, 0.1]), 0.1), None, "worn springs");
        assert_eq!(looked(&held([0.0; 2], [-1.0, 0.5]), 0.1), Some([-0.05, 0.025]));
        assert_eq!(looked(&held([1.0, 0.0], [1.0, 0.0]), 0.1), Some([0.05, 0.0]));
    }
}
