//! Requests of accessibility aids to the window, as far as they can be fulfilled.

use eframe::egui::accesskit::ActionData;
use eframe::egui::{Event, RawInput};

/// Drops requests for values that are no numbers: no control can have them.
pub fn drop_what_is_no_number(input: &mut RawInput) {
    input.events.retain(|event| match event {
        Event::AccessKitActionRequest(request) => match request.data {
            Some(ActionData::NumericValue(value)) => value.is_finite(),
            _ => true,
        },
        _ => true,
    });
}

#[cfg(test)]
mod tests {
    use eframe::egui::accesskit::{Action, ActionRequest, NodeId, TreeId};

    use super::*;

    #[test]
    fn numbers_are_let_through_and_nothing_else() {
        let request = |value| {
            Event::AccessKitActionRequest(ActionRequest {
                action: Action::SetValue,
                target_node: NodeId(1),
                target_tree: TreeId::ROOT,
                data: Some(ActionData::NumericValue(value)),
            })
        };
        let numbers = [f64::NAN, 1.5, f64::INFINITY, -1e300, f64::NEG_INFINITY].map(request);
        let mut input = RawInput { events: numbers.into(), ..RawInput::default() };
        input.events.push(Event::Copy);
        drop_what_is_no_number(&mut input);
        assert_eq!(input.events, [request(1.5), request(-1e300), Event::Copy]);
    }
}
