use eframe::egui::accesskit::{
    Action, Live, Node, NodeId, Rect, Role, Toggled, TreeId, TreeInfo, TreeUpdate,
};

use super::{Change, Mirror};

const ROOT: NodeId = NodeId(0);

fn node(role: Role, name: &str) -> Node {
    let mut node = Node::new(role);
    if role == Role::Label {
        node.set_value(name);
    } else {
        node.set_label(name);
    }
    node
}

fn parent(role: Role, children: &[u64]) -> Node {
    let mut node = Node::new(role);
    node.set_children(children.iter().map(|id| NodeId(*id)).collect::<Vec<_>>());
    node
}

/// A tree in which all nodes but the children of other ones are the root's.
fn tree(nodes: &[(u64, Node)], focus: NodeId) -> TreeUpdate {
    let inner: Vec<NodeId> = nodes.iter().flat_map(|(_, node)| node.children().to_vec()).collect();
    let outer = nodes.iter().map(|(id, _)| *id).filter(|id| !inner.contains(&NodeId(*id)));
    let root = parent(Role::Window, &outer.collect::<Vec<_>>());
    let nodes = nodes.iter().map(|(id, node)| (NodeId(*id), node.clone()));
    TreeUpdate {
        nodes: nodes.chain([(ROOT, root)]).collect(),
        tree: Some(TreeInfo::new(ROOT)),
        tree_id: TreeId::ROOT,
        focus,
    }
}

fn attributes_of(changes: &[Change], id: u64) -> Vec<(&'static str, Option<&str>)> {
    let of_it = changes.iter().filter_map(|change| match change {
        Change::Attribute(of, name, value) if *of == NodeId(id) => Some((*name, value.as_deref())),
        _ => None,
    });
    of_it.collect()
}

#[test]
fn a_button_has_a_role_a_name_a_state_and_a_place() {
    let mut button = node(Role::Button, "Play");
    button.set_toggled(Toggled::True);
    button.set_disabled();
    button.add_action(Action::Focus);
    button.set_bounds(Rect { x0: 10.0, y0: 20.4, x1: 34.0, y1: 44.4 });
    let changes = Mirror::default().update(tree(&[(1, button)], ROOT), 2.0);
    assert_eq!(changes[0], Change::Create(NodeId(1), "div"));
    let expected = [
        ("role", Some("button")),
        ("aria-label", Some("Play")),
        ("aria-pressed", Some("true")),
        ("aria-disabled", Some("true")),
        ("tabindex", Some("-1")),
        ("style", Some("left:20px;top:41px;width:48px;height:48px")),
    ];
    assert_eq!(attributes_of(&changes, 1), expected);
    assert_eq!(changes.last(), Some(&Change::Children(None, vec![NodeId(1)])));
}

#[test]
fn nothing_changes_where_the_tree_does_not() {
    let nodes =
        [(1, parent(Role::Dialog, &[2, 3])), (2, node(Role::Label, "a")), (3, node(Role::Button, "b"))];
    let mut mirror = Mirror::default();
    assert!(!mirror.update(tree(&nodes, NodeId(3)), 1.0).is_empty());
    assert_eq!(mirror.update(tree(&nodes, NodeId(3)), 1.0), []);
}

#[test]
fn only_what_differs_is_touched() {
    let mut mirror = Mirror::default();
    let mut slider = node(Role::Slider, "Speed");
    slider.set_numeric_value(0.5);
    slider.set_min_numeric_value(0.0);
    slider.set_max_numeric_value(1.0);
    slider.set_value("0.9");
    let label = node(Role::Label, "as it was");
    let first = mirror.update(tree(&[(1, slider.clone()), (2, label)], ROOT), 1.0);
    assert!(first.contains(&Change::Create(NodeId(1), "input")));
    assert!(first.contains(&Change::Value(NodeId(1), "0.5".to_owned())));
    assert!(attributes_of(&first, 1).contains(&("aria-valuetext", Some("0.9"))));
    slider.set_numeric_value(0.6);
    let second =
        mirror.update(tree(&[(1, slider.clone()), (2, node(Role::Label, "changed"))], NodeId(1)), 1.0);
    let expected = [
        Change::Value(NodeId(1), "0.6".to_owned()),
        Change::Text(NodeId(2), "changed".to_owned()),
        Change::Focus(Some(NodeId(1))),
    ];
    assert_eq!(second, expected);
    let third = mirror.update(tree(&[(1, slider)], ROOT), 1.0);
    let expected = [Change::Delete(NodeId(2)), Change::Children(None, vec![NodeId(1)]), Change::Focus(None)];
    assert_eq!(third, expected);
}

#[test]
fn a_value_that_the_window_refuses_comes_back() {
    let mut mirror = Mirror::default();
    let mut slider = node(Role::Slider, "Speed");
    slider.set_numeric_value(0.5);
    let nodes = [(1, slider)];
    mirror.update(tree(&nodes, ROOT), 1.0);
    mirror.touch(NodeId(1));
    assert_eq!(mirror.update(tree(&nodes, ROOT), 1.0), [Change::Value(NodeId(1), "0.5".to_owned())]);
    assert_eq!(mirror.update(tree(&nodes, ROOT), 1.0), []);
}

#[test]
fn what_only_holds_together_gives_its_children_to_its_parent() {
    let mut live = parent(Role::GenericContainer, &[5]);
    live.set_live(Live::Polite);
    let nodes = [
        (1, parent(Role::GenericContainer, &[2, 3])),
        (2, node(Role::Button, "a")),
        (3, parent(Role::Pane, &[4])),
        (4, live),
        (5, node(Role::Label, "said")),
    ];
    let changes = Mirror::default().update(tree(&nodes, ROOT), 1.0);
    assert!(changes.contains(&Change::Children(None, vec![NodeId(2), NodeId(4)])));
    assert!(changes.contains(&Change::Children(Some(NodeId(4)), vec![NodeId(5)])));
    assert!(attributes_of(&changes, 4).contains(&("aria-live", Some("polite"))));
}

#[test]
fn a_field_is_called_by_its_label_else_by_its_hint() {
    let mut field = Node::new(Role::TextInput);
    field.set_labelled_by(vec![NodeId(2)]);
    let mut hinted = Node::new(Role::TextInput);
    hinted.set_placeholder("a number");
    let nodes = [(1, field), (2, node(Role::Label, "Name")), (3, hinted)];
    let changes = Mirror::default().update(tree(&nodes, ROOT), 1.0);
    assert!(attributes_of(&changes, 1).contains(&("aria-label", Some("Name"))));
    assert!(attributes_of(&changes, 3).contains(&("aria-label", Some("a number"))));
}

#[test]
fn what_is_in_a_button_is_in_its_name() {
    let mut card = node(Role::RadioButton, "shorter");
    card.set_children(vec![NodeId(2)]);
    card.set_toggled(Toggled::False);
    let changes = Mirror::default().update(tree(&[(1, card), (2, node(Role::Label, "shorter"))], ROOT), 1.0);
    assert!(!changes.contains(&Change::Create(NodeId(2), "div")));
    assert!(attributes_of(&changes, 1).contains(&("aria-checked", Some("false"))));
}
