//! Nodes of the accessibility tree as elements of a page.

use std::collections::HashMap;

use eframe::egui::accesskit::{Action, Live, Node, NodeId, Role, Toggled};

use super::change::Change;

/// An element of the page.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Element {
    /// The tag: `div` but for sliders and fields, whose values a browser lets assistive technology set.
    pub tag: &'static str,
    /// The children, in their order.
    pub children: Vec<NodeId>,
    attributes: Vec<(&'static str, String)>,
    text: Option<String>,
    value: Option<String>,
    /// Whether there is anything in it but text.
    pub holds_children: bool,
}

impl Element {
    /// Adds what changes an element that is as `before` into this one. The page's value is not what it was
    /// where somebody has `touched` it.
    pub fn add_changes(&self, id: NodeId, before: &Self, touched: bool, changes: &mut Vec<Change>) {
        for (name, value) in &self.attributes {
            if before.attribute(name) != Some(value) {
                changes.push(Change::Attribute(id, name, Some(value.clone())));
            }
        }
        let is_gone = |name: &&'static str| self.attribute(name).is_none();
        let gone = before.attributes.iter().map(|(name, _)| *name).filter(is_gone);
        changes.extend(gone.map(|name| Change::Attribute(id, name, None)));
        if self.text != before.text {
            changes.push(Change::Text(id, self.text.clone().unwrap_or_default()));
        }
        if let Some(value) = &self.value
            && (touched || before.value.as_ref() != Some(value))
        {
            changes.push(Change::Value(id, value.clone()));
        }
    }

    fn attribute(&self, name: &str) -> Option<&String> {
        self.attributes.iter().find(|(known, _)| *known == name).map(|(_, value)| value)
    }
}

/// The form that a node takes in the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Text to be read.
    Text,
    /// A part with a name and this role, in which nothing else is.
    Part(&'static str),
    /// A part with this role, in which there are others.
    Group(&'static str),
    /// A field or a slider of this type.
    Input(&'static str),
    /// A field of several lines.
    Lines,
}

impl Form {
    fn of(node: &Node) -> Self {
        match node.role() {
            Role::Button
            | Role::DefaultButton
            | Role::ColorWell
            | Role::DisclosureTriangle
            | Role::ListBoxOption
            | Role::MenuItem
            | Role::MenuListOption
            | Role::Tab
            | Role::TreeItem => Self::Part("button"),
            // Something to be reached that has not said what it is.
            Role::Unknown if node.supports_action(Action::Focus) => Self::Part("button"),
            Role::CheckBox | Role::MenuItemCheckBox => Self::Part("checkbox"),
            Role::RadioButton | Role::MenuItemRadio => Self::Part("radio"),
            Role::Switch => Self::Part("switch"),
            Role::ComboBox => Self::Part("combobox"),
            Role::Link => Self::Part("link"),
            Role::ProgressIndicator => Self::Part("progressbar"),
            Role::Splitter => Self::Part("separator"),
            Role::Image
            | Role::Canvas
            | Role::GraphicsDocument
            | Role::GraphicsObject
            | Role::GraphicsSymbol => Self::Part("img"),
            Role::Slider => Self::Input("range"),
            Role::SpinButton | Role::NumberInput => Self::Input("number"),
            Role::TextInput | Role::SearchInput | Role::EditableComboBox => Self::Input("text"),
            Role::MultilineTextInput => Self::Lines,
            Role::Label | Role::Heading | Role::TitleBar | Role::Paragraph => Self::Text,
            Role::Dialog | Role::AlertDialog => Self::Group("dialog"),
            Role::Tooltip => Self::Group("tooltip"),
            Role::Alert => Self::Group("alert"),
            Role::Status => Self::Group("status"),
            _ => Self::Group("group"),
        }
    }
}

/// The nodes of a tree.
pub struct Nodes {
    nodes: HashMap<NodeId, Node>,
    zoom: f64,
}

impl Nodes {
    /// Takes these `nodes`, in points of which `zoom` make a point of the page.
    pub fn new(nodes: Vec<(NodeId, Node)>, zoom: f64) -> Self {
        Self { nodes: nodes.into_iter().collect(), zoom }
    }

    /// The children of a node.
    pub fn children(&self, id: NodeId) -> &[NodeId] {
        self.nodes.get(&id).map_or(&[], Node::children)
    }

    /// Whether the page has neither this node nor what is below it. A run of text is that of its parent.
    pub fn is_left_out(&self, id: NodeId) -> bool {
        self.nodes.get(&id).is_none_or(|node| node.is_hidden() || node.role() == Role::TextRun)
    }

    /// The element of a node, without its children; `None` for one that only holds others together.
    pub fn element(&self, id: NodeId) -> Option<Element> {
        let node = self.nodes.get(&id)?;
        let form = Form::of(node);
        let name = self.name(node);
        if matches!(form, Form::Group("group")) && name.is_none() && node.live().is_none() {
            return None;
        }
        let mut attributes = Vec::new();
        let mut set = |name, value: Option<String>| attributes.extend(value.map(|value| (name, value)));
        let role = match form {
            Form::Text => (node.role() == Role::Heading).then_some("heading"),
            Form::Part(role) | Form::Group(role) => Some(role),
            Form::Input(_) | Form::Lines => None,
        };
        set("role", role.map(str::to_owned));
        set(
            "aria-level",
            (role == Some("heading")).then(|| node.level().map_or(2, |level| level + 1).to_string()),
        );
        if let Form::Input(kind) = form {
            set("type", Some(kind.to_owned()));
        }
        let is_text = form == Form::Text;
        let text = if is_text { name.clone() } else { None };
        set("aria-label", name.filter(|_| !is_text));
        set("aria-description", node.description().map(str::to_owned));
        let toggled = if matches!(role, Some("checkbox" | "radio" | "switch")) {
            "aria-checked"
        } else {
            "aria-pressed"
        };
        let is_toggle = matches!(role, Some("button" | "checkbox" | "radio" | "switch"));
        set(toggled, node.toggled().filter(|_| is_toggle).map(|state| toggled_text(state).to_owned()));
        let expanded = node.is_expanded().or((role == Some("combobox")).then_some(false));
        set("aria-expanded", expanded.map(|is_expanded| is_expanded.to_string()));
        set("aria-disabled", node.is_disabled().then(|| true.to_string()));
        set("aria-modal", node.is_modal().then(|| true.to_string()));
        set("aria-live", node.live().map(|live| live_text(live).to_owned()));
        let [lowest, highest] = [node.min_numeric_value(), node.max_numeric_value()];
        let number = node.numeric_value();
        if let Form::Input("range" | "number") = form {
            set("min", lowest.map(|value| value.to_string()));
            set("max", highest.map(|value| value.to_string()));
            set("step", Some(node.numeric_value_step().map_or("any".to_owned(), |step| step.to_string())));
            set("aria-valuetext", node.value().map(str::to_owned));
        } else if role == Some("progressbar") {
            set("aria-valuenow", number.map(|value| value.to_string()));
        }
        let can_be_reached = node.supports_action(Action::Focus) && !is_text;
        set("tabindex", can_be_reached.then(|| "-1".to_owned()));
        set("style", self.place(node));
        let value = match form {
            Form::Input("range" | "number") => number.map(|value| value.to_string()),
            Form::Input(_) | Form::Lines => Some(node.value().unwrap_or_default().to_owned()),
            _ => None,
        };
        let text = text.or_else(|| (role == Some("combobox")).then(|| node.value().map(str::to_owned))?);
        let tag = match form {
            Form::Input(_) => "input",
            Form::Lines => "textarea",
            _ => "div",
        };
        let holds_children = matches!(form, Form::Group(_));
        Some(Element { tag, children: Vec::new(), attributes, text, value, holds_children })
    }

    /// The name of a node: its own, that of its labels, or the placeholder of an empty field.
    fn name(&self, node: &Node) -> Option<String> {
        let own = node.label().or_else(|| if Form::of(node) == Form::Text { node.value() } else { None });
        let of_labels = || {
            let labels = node.labelled_by().iter().filter_map(|id| self.nodes.get(id));
            labels.filter_map(|label| label.value().or_else(|| label.label())).collect::<Vec<_>>().join(" ")
        };
        let name = own.map_or_else(of_labels, str::to_owned);
        Some(name).filter(|name| !name.is_empty()).or_else(|| node.placeholder().map(str::to_owned))
    }

    /// The place on the page, to whole points: a finger on a touch screen finds an element by it.
    fn place(&self, node: &Node) -> Option<String> {
        let bounds = node.bounds()?;
        let [x0, y0, x1, y1] =
            [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|at| (at * self.zoom).round());
        let is_finite = [x0, y0, x1, y1].iter().all(|at| at.is_finite());
        is_finite.then(|| format!("left:{x0}px;top:{y0}px;width:{}px;height:{}px", x1 - x0, y1 - y0))
    }
}

fn toggled_text(state: Toggled) -> &'static str {
    match state {
        Toggled::False => "false",
        Toggled::True => "true",
        Toggled::Mixed => "mixed",
    }
}

fn live_text(live: Live) -> &'static str {
    match live {
        Live::Off => "off",
        Live::Polite => "polite",
        Live::Assertive => "assertive",
    }
}
