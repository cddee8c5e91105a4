//! Elements of the page that nobody sees, inside `#mirror`: assistive technology reads the window off them,
//! and acts on them. Each has a number.

use wasm_bindgen::JsCast as _;
use wasm_bindgen::prelude::Closure;
use web_sys::{
    Document, Element, Event, HtmlInputElement, HtmlTextAreaElement, KeyboardEvent, KeyboardEventInit,
};

use super::{page, tasks};

/// The beginning of an element's name in the document, before its number.
const PREFIX: &str = "gamow-";
/// Keys that are only held while another is pressed, or that have a screen reader stop speaking.
const HELD: [&str; 4] = ["Alt", "Control", "Meta", "Shift"];

/// An act of assistive technology on an element.
#[derive(Debug, Clone, PartialEq)]
pub enum Deed {
    /// A click, as on the widget.
    Click,
    /// Moving the focus of the keyboard to it.
    Focus,
    /// Setting a slider to this number.
    Number(f64),
    /// Writing this text into a field.
    Text(String),
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}

fn mirror() -> Option<Element> {
    document()?.get_element_by_id("mirror")
}

fn name(id: u64) -> String {
    format!("{PREFIX}{id}")
}

fn element(id: u64) -> Option<Element> {
    document()?.get_element_by_id(&name(id))
}

/// Makes an element with this `tag`, at the end of the others until it is placed.
pub fn create(id: u64, tag: &str) {
    let Some(mirror) = mirror() else { return };
    if let Some(made) = document().and_then(|document| document.create_element(tag).ok()) {
        made.set_id(&name(id));
        let _ = mirror.append_child(&made);
    }
}

/// Gives an element this attribute, or takes it away.
pub fn set_attribute(id: u64, attribute: &str, value: Option<&str>) {
    let Some(element) = element(id) else { return };
    let _ = match value {
        Some(value) => element.set_attribute(attribute, value),
        None => element.remove_attribute(attribute),
    };
}

/// Writes the text of an element.
pub fn set_text(id: u64, text: &str) {
    if let Some(element) = element(id) {
        element.set_text_content(Some(text));
    }
}

/// Sets the value of a slider or a field.
pub fn set_value(id: u64, value: &str) {
    let Some(element) = element(id) else { return };
    if let Some(input) = element.dyn_ref::<HtmlInputElement>() {
        input.set_value(value);
    } else if let Some(lines) = element.dyn_ref::<HtmlTextAreaElement>() {
        lines.set_value(value);
    }
}

/// Puts these `children` into an element, or into the place for all, in this order.
pub fn set_children(parent: Option<u64>, children: &[u64]) {
    let Some(parent) = parent.map_or_else(mirror, element) else { return };
    let mut next = parent.first_element_child();
    for child in children.iter().filter_map(|id| element(*id)) {
        if next.as_ref() == Some(&child) {
            next = child.next_element_sibling();
        } else {
            let _ = parent.insert_before(&child, next.as_deref());
        }
    }
}

/// Removes an element; what is in it stays. A focus that it has goes to the window.
pub fn remove(id: u64) {
    let (Some(mirror), Some(element)) = (mirror(), element(id)) else { return };
    while let Some(child) = element.first_element_child() {
        let _ = mirror.append_child(&child);
    }
    let has_focus = document().and_then(|document| document.active_element()).as_ref() == Some(&element);
    element.remove();
    if has_focus {
        // Not before this frame has ended: the window would not notice.
        tasks::spawn(async { focus_window() });
    }
}

/// Whether an element has the browser's focus.
#[must_use]
pub fn have_focus() -> bool {
    let focused = document().and_then(|document| document.active_element());
    focused.is_some_and(|element| element.id().starts_with(PREFIX))
}

fn focus_window() {
    if let Some(canvas) = page::canvas() {
        let _ = canvas.focus();
    }
}

/// Says which element has the focus of the keyboard in the window.
///
/// The browser's focus stays with the window, which takes all keys; while text is typed, with a field of the
/// toolkit's behind the window, which has no name of its own.
pub fn set_focus(id: Option<u64>) {
    let Some(canvas) = page::canvas() else { return };
    let focused = id.and_then(element);
    let _ = match &focused {
        Some(focused) => canvas.set_attribute("aria-activedescendant", &focused.id()),
        None => canvas.remove_attribute("aria-activedescendant"),
    };
    let typing = canvas.next_element_sibling().filter(|next| next.has_type::<HtmlInputElement>());
    let Some(typing) = typing else { return };
    let is_field = |element: &Element| {
        element.has_type::<HtmlTextAreaElement>() || element.get_attribute("type").as_deref() == Some("text")
    };
    let field = focused.filter(is_field).and_then(|field| field.get_attribute("aria-label"));
    let _ = match field {
        Some(field) => {
            typing.remove_attribute("aria-hidden").and_then(|()| typing.set_attribute("aria-label", &field))
        }
        None => typing.set_attribute("aria-hidden", "true"),
    };
}

/// Calls `then` with the number of an element and what somebody has done to it, for as long as the page is
/// there.
pub fn listen(then: impl FnMut(u64, Deed) + Clone + 'static) {
    on("click", then.clone(), |target| (!is_input(target)).then_some(Deed::Click));
    on("focusin", then.clone(), |_| Some(Deed::Focus));
    on("input", then, |target| {
        if let Some(input) = target.dyn_ref::<HtmlInputElement>() {
            if input.type_() == "text" {
                return Some(Deed::Text(input.value()));
            }
            return input.value().parse().ok().filter(|number: &f64| number.is_finite()).map(Deed::Number);
        }
        target.dyn_ref::<HtmlTextAreaElement>().map(|lines| Deed::Text(lines.value()))
    });
    hand_keys_on();
}

fn is_input(target: &Element) -> bool {
    target.has_type::<HtmlInputElement>() || target.has_type::<HtmlTextAreaElement>()
}

fn on(
    event: &str,
    mut then: impl FnMut(u64, Deed) + 'static,
    deed: impl Fn(&Element) -> Option<Deed> + 'static,
) {
    let closure = Closure::<dyn FnMut(Event)>::new(move |event: Event| {
        let mut target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        while let Some(element) = target {
            if let Some(id) = element.id().strip_prefix(PREFIX).and_then(|id| id.parse().ok()) {
                if let Some(deed) = deed(&element) {
                    then(id, deed);
                }
                return;
            }
            target = element.parent_element();
        }
    });
    if let Some(mirror) = mirror() {
        let _ = mirror.add_event_listener_with_callback(event, closure.as_ref().unchecked_ref());
    }
    // It lasts as long as the page.
    closure.forget();
}

/// Has the window take the keys, and with the first of them the focus, that an element gets.
fn hand_keys_on() {
    let closure = Closure::<dyn FnMut(KeyboardEvent)>::new(move |event: KeyboardEvent| {
        let Some(canvas) = page::canvas().filter(|_| !HELD.contains(&event.key().as_str())) else { return };
        focus_window();
        // An event has all that describes another.
        let same = event.unchecked_ref::<KeyboardEventInit>();
        let Ok(copy) = KeyboardEvent::new_with_keyboard_event_init_dict("keydown", same) else { return };
        if !canvas.dispatch_event(&copy).unwrap_or(true) {
            event.prevent_default();
        }
        event.stop_propagation();
    });
    if let Some(mirror) = mirror() {
        let _ = mirror.add_event_listener_with_callback("keydown", closure.as_ref().unchecked_ref());
    }
    closure.forget();
}
