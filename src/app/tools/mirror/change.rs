//! Changes of the page.

use eframe::egui::accesskit::NodeId;

/// A change of the page. Changes are made in the order in which they are returned.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Change {
    /// Makes an element with this tag, which is nowhere yet.
    Create(NodeId, &'static str),
    /// Gives an attribute its value, or removes it.
    Attribute(NodeId, &'static str, Option<String>),
    /// Writes the text of an element without children.
    Text(NodeId, String),
    /// Sets the value of a slider or a field.
    Value(NodeId, String),
    /// Puts these children into an element, or into the mirror itself, in this order.
    Children(Option<NodeId>, Vec<NodeId>),
    /// Removes an element. What is still in it stays in the mirror.
    Delete(NodeId),
    /// Moves the focus of the keyboard to this element, or to none of them.
    Focus(Option<NodeId>),
}
