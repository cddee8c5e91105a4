//! The names of a scene's bodies, each of which means one body.

use std::collections::{HashMap, HashSet};

use super::content::SceneGroup;
use super::error::{Located, SceneProblem};
use super::object::Object;

/// Names the bodies of `groups`: like their file, with a distinction behind a name that two of them have. In
/// a group with several of one name that is what each was included with; of several groups it is the group,
/// or the `rider` for the scene's own, which comes first.
///
/// # Errors
/// Two bodies of one name that nothing tells apart.
pub(super) fn names(objects: &[Object], groups: &[SceneGroup], rider: &str) -> Result<Vec<String>, Located> {
    let plain: Vec<String> =
        objects.iter().enumerate().map(|(number, object)| object.name_as(number)).collect();
    let mut names = plain.clone();
    for group in groups {
        let times = times_of(&names[group.bodies()]);
        for body in group.bodies() {
            let Some(include) = objects[body].include.as_deref() else { continue };
            if times[&plain[body]] > 1 {
                names[body] = qualified_name(&plain[body], include);
            }
        }
    }
    let times = times_of(&names);
    for (number, group) in groups.iter().enumerate() {
        let owner = if number == 0 { rider } else { &group.name };
        for name in &mut names[group.bodies()] {
            if times[name.as_str()] > 1 {
                *name = qualified_name(name, owner);
            }
        }
    }
    let mut taken = HashSet::new();
    match names.iter().position(|name| !taken.insert(name)) {
        Some(body) => {
            let problem = SceneProblem::SameName(plain[body].clone());
            Err(Located { span: objects[body].span.clone(), problem })
        }
        None => Ok(names),
    }
}

fn qualified_name(name: &str, owner: &str) -> String {
    format!("{name} ({owner})")
}

/// Counts each of `names`.
fn times_of(names: &[String]) -> HashMap<String, usize> {
    let mut times = HashMap::new();
    for name in names {
        *times.entry(name.clone()).or_default() += 1;
    }
    times
}
