//! Names of pinned curves, and of the present ones beside them: by their differences.

use relativity_core::Model;

use crate::app::state::State;
use crate::app::state::plots::curves::SeenPoint;
use crate::app::state::points::Point;
use crate::number_text;

/// The traits that may distinguish curves, in words.
struct Traits {
    point: String,
    speed: String,
    /// The rest, in order.
    others: [String; 8],
}

impl Traits {
    fn new(state: &State, point: &Point, seen: &SeenPoint) -> Self {
        let number = |name: &str, value: f64| format!("{name} {}", number_text::trimmed(value, 3));
        let [x, y, z] = seen.point.rest.to_array();
        let baseline = seen.baseline;
        let beta = number_text::beta(&seen.velocity.speed);
        // As many digits as there are: no zeros behind the point.
        let beta = if beta.contains('e') { &beta } else { beta.trim_end_matches('0').trim_end_matches('.') };
        Self {
            point: state.name_of(point),
            speed: format!("β {beta}"),
            others: [
                number("x", x),
                number("y", y),
                number("z", z),
                number("d", baseline.separation),
                number("roll", baseline.roll.to_degrees()) + "°",
                number("turn", baseline.turn.to_degrees()) + "°",
                if seen.point.spin.is_some() { "turning" } else { "not turning" }.to_owned(),
                match seen.model {
                    Model::Exact => "two light cones",
                    Model::OneCone => "one light cone",
                    Model::Published(_) => "published",
                }
                .to_owned(),
            ],
        }
    }

    fn all(&self) -> impl Iterator<Item = &String> {
        [&self.point, &self.speed].into_iter().chain(&self.others)
    }

    /// Returns those that are not the same in `all`.
    fn that_differ(&self, all: &[Self], names_point: bool) -> String {
        let mut words: Vec<&str> = Vec::new();
        for (index, own) in self.all().enumerate() {
            let differs = all.iter().any(|other| other.all().nth(index) != Some(own));
            if differs || (index == 0 && names_point) {
                words.push(own);
            }
        }
        if words.is_empty() || words == [self.point.as_str()] {
            words.push(&self.speed);
        }
        words.join(", ")
    }
}

/// Returns the traits of all pinned curves, and last those of the selected point.
fn compared(state: &State) -> Vec<Traits> {
    let selected = state.document.points.selected();
    let pins = state.scratch.plotting.pins.iter().map(|pin| Traits::new(state, &pin.point, &pin.seen));
    pins.chain([Traits::new(state, selected, &state.seen_point(selected))]).collect()
}

/// The names of the pinned curves, in order.
pub(super) fn names(state: &State) -> Vec<String> {
    let all = compared(state);
    let several = state.document.points.all().len() > 1;
    let count = state.scratch.plotting.pins.len();
    all.iter().take(count).map(|traits| traits.that_differ(&all, several)).collect()
}

/// Returns the name of `point` in a plot: where curves are pinned, the selected one's also has its
/// differences from those.
pub(super) fn name_beside(state: &State, point: &Point) -> String {
    let is_compared =
        !state.scratch.plotting.pins.is_empty() && point.number == state.document.points.selected().number;
    let all = if is_compared { compared(state) } else { Vec::new() };
    all.last().map_or_else(|| state.name_of(point), |own| own.that_differ(&all, true))
}
