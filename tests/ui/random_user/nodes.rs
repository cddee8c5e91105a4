//! What the window offers, as its accessibility tree tells it, and which of it the user has used.

use std::collections::BTreeMap;

use eframe::egui::accesskit::{Action, Role};
use eframe::egui::{Pos2, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use gamow::app::shell::App;

use super::dice::Dice;

/// Something in the window.
#[derive(Debug, Clone)]
pub struct Found {
    /// Its number among all nodes.
    pub number: usize,
    pub role: Role,
    /// What it is called; empty if it has no name.
    pub name: String,
    /// What it says or holds.
    pub value: String,
    pub rect: Rect,
    pub is_enabled: bool,
    pub takes_clicks: bool,
    pub takes_values: bool,
}

impl Found {
    /// Whether it does something when it is clicked: text can be selected, and that takes clicks too.
    pub fn is_control(&self) -> bool {
        self.is_enabled && self.takes_clicks && !matches!(self.role, Role::Label | Role::ScrollBar)
    }

    /// What it is counted as: numbers in a name change from frame to frame.
    fn kind(&self) -> String {
        let mut kind = format!("{:?} ", self.role);
        for letter in self.name.chars() {
            let letter = if letter.is_ascii_digit() { '0' } else { letter };
            if !(letter == '0' && kind.ends_with('0')) {
                kind.push(letter);
            }
        }
        kind.chars().take(70).collect()
    }
}

/// All that is in the window.
pub fn all(window: &Harness<'_, App>) -> Vec<Found> {
    let scale = f64::from(window.ctx.pixels_per_point());
    let nodes = window.root().children_recursive();
    let found = nodes.enumerate().map(|(number, node)| {
        let node = node.accesskit_node();
        let place = |x: f64, y: f64| Pos2::new((x / scale) as f32, (y / scale) as f32);
        let rect = node.bounding_box().map_or(Rect::NOTHING, |rect| {
            Rect::from_min_max(place(rect.x0, rect.y0), place(rect.x1, rect.y1))
        });
        Found {
            number,
            role: node.role(),
            name: node.label().unwrap_or_default(),
            value: node.value().unwrap_or_default(),
            rect,
            is_enabled: !node.is_disabled(),
            takes_clicks: node.data().supports_action(Action::Click),
            takes_values: node.data().supports_action(Action::SetValue),
        }
    });
    found.collect()
}

/// How often each kind of control was seen, as one that can be used, and used.
#[derive(Debug, Default)]
pub struct Coverage(BTreeMap<String, [u32; 2]>);

impl Coverage {
    pub fn see(&mut self, found: &[Found]) {
        for control in found.iter().filter(|found| found.is_control()) {
            self.0.entry(control.kind()).or_default()[0] += 1;
        }
    }

    pub fn used(&mut self, control: &Found) {
        if !control.is_control() {
            return;
        }
        self.0.entry(control.kind()).or_default()[1] += 1;
    }

    /// One of `controls`: the less often its kind was used, the likelier. Which it is hardly depends on what
    /// else there is.
    pub fn choose<'a>(
        &self,
        controls: impl Iterator<Item = &'a Found>,
        dice: &mut Dice,
    ) -> Option<&'a Found> {
        let salt = dice.next();
        let turn = |control: &Found| {
            let name = control.kind() + &control.name;
            let key = name.bytes().fold(salt, |key, byte| Dice::of_step(key, byte.into()).next());
            let used = self.0.get(&control.kind()).map_or(0, |[_, used]| *used);
            -Dice::of_step(key, 0).share().ln() * f64::from(1 + used)
        };
        controls
            .map(|control| (turn(control), control))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, best)| best)
    }

    /// How many kinds were seen and how many used, and those that were seen and never used.
    pub fn report(&self) -> ([usize; 2], Vec<&str>) {
        let seen = self.0.values().filter(|[seen, _]| *seen > 0).count();
        let used = self.0.values().filter(|[_, used]| *used > 0).count();
        let unused = self.0.iter().filter(|(_, [_, used])| *used == 0);
        ([seen, used], unused.map(|(kind, _)| kind.as_str()).collect())
    }
}
