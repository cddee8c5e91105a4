//! The window's accessibility tree as elements of a page, and what changes in the page when the tree does.
//!
//! The toolkit hands out the whole tree each time; of the page only what differs is touched. Nothing here
//! knows a browser, so that it is tested on the desktop.

mod change;
mod element;
#[cfg(test)]
mod tests;

use std::collections::{HashMap, HashSet};

use eframe::egui::accesskit::{NodeId, TreeUpdate};

pub use self::change::Change;
use self::element::{Element, Nodes};

/// The mirror: what the page has of the window.
#[derive(Debug, Default)]
pub struct Mirror {
    elements: HashMap<NodeId, Element>,
    /// The elements' numbers, parents before their children.
    order: Vec<NodeId>,
    roots: Vec<NodeId>,
    focus: Option<NodeId>,
    /// Elements whose values somebody has changed in the page.
    touched: HashSet<NodeId>,
}

impl Mirror {
    /// Notes that the page no longer has the value that it was given: the window may refuse the new one.
    pub fn touch(&mut self, id: NodeId) {
        self.touched.insert(id);
    }

    /// Takes the whole tree, in points of which `zoom` make a point of the page, and returns what changes.
    pub fn update(&mut self, update: TreeUpdate, zoom: f64) -> Vec<Change> {
        let root = update.tree.map(|tree| tree.root);
        let nodes = Nodes::new(update.nodes, zoom);
        let mut new = Self { touched: std::mem::take(&mut self.touched), ..Self::default() };
        new.roots = root.map(|root| new.take(&nodes, nodes.children(root))).unwrap_or_default();
        new.focus = Some(update.focus).filter(|id| new.elements.contains_key(id));
        let changes = new.changes_from(self);
        *self = Self { touched: HashSet::new(), ..new };
        changes
    }

    /// Takes these nodes and what is below them; returns those that become elements of their parent's.
    fn take(&mut self, nodes: &Nodes, ids: &[NodeId]) -> Vec<NodeId> {
        let mut taken = Vec::with_capacity(ids.len());
        for &id in ids {
            if self.elements.contains_key(&id) || nodes.is_left_out(id) {
                continue;
            }
            let Some(element) = nodes.element(id) else {
                taken.extend(self.take(nodes, nodes.children(id)));
                continue;
            };
            let holds_children = element.holds_children;
            self.elements.insert(id, element);
            self.order.push(id);
            taken.push(id);
            if holds_children {
                let children = self.take(nodes, nodes.children(id));
                self.elements.entry(id).and_modify(|element| element.children = children);
            }
        }
        taken
    }

    fn changes_from(&self, old: &Self) -> Vec<Change> {
        // Those that go are taken away first: else all behind them would have to be moved.
        let is_kept = |id: &NodeId| {
            let [now, then] = [self, old].map(|mirror| mirror.elements.get(id).map(|element| element.tag));
            now == then
        };
        let gone = old.order.iter().rev().filter(|id| !is_kept(id));
        let mut changes: Vec<Change> = gone.map(|id| Change::Delete(*id)).collect();
        let nothing = Element::default();
        let before = |id: &NodeId| old.elements.get(id).filter(|_| is_kept(id)).unwrap_or(&nothing);
        for id in &self.order {
            let element = &self.elements[id];
            if !is_kept(id) {
                changes.push(Change::Create(*id, element.tag));
            }
            element.add_changes(*id, before(id), self.touched.contains(id), &mut changes);
        }
        if self.roots != old.roots {
            changes.push(Change::Children(None, self.roots.clone()));
        }
        for id in &self.order {
            let children = &self.elements[id].children;
            if *children != before(id).children {
                changes.push(Change::Children(Some(*id), children.clone()));
            }
        }
        if self.focus != old.focus {
            changes.push(Change::Focus(self.focus));
        }
        changes
    }
}
