//! People: heads and hats, and passers-by of known height.

use super::objects::{Objects, Place};

/// A person who stands or walks.
pub struct Person {
    /// Place of the feet on the ground.
    pub at: [f64; 2],
    /// 1 who walks towards +x, -1 towards -x.
    pub facing: f64,
    /// Height without the hat; 2.7 is 1.75 m.
    pub height: f64,
    pub coat: &'static str,
    /// Cloth of the trousers; a skirt is of that of the coat.
    pub trousers: Option<&'static str>,
    pub has_hat: bool,
}

/// Adds the head whose middle this is, with a face that looks along `facing` x, a moustache and a bowler
/// hat if wanted.
pub fn head(objects: &mut Objects, [x, y, z]: Place, facing: f64, [has_moustache, has_hat]: [bool; 2]) {
    let at = |ahead: f64, aside: f64, up: f64| [x + facing * ahead, y + aside, z + up];
    objects.ball("skin", at(0.0, 0.0, 0.0), 0.135);
    objects.named("head");
    objects.tube("skin", at(0.03, 0.0, -0.03), at(0.05, 0.0, -0.115), 0.098);
    objects.named("jaw");
    objects.tube("skin", at(0.118, 0.0, 0.02), at(0.15, 0.0, -0.028), 0.019);
    objects.named("bridge of the nose");
    objects.ball("skin", at(0.15, 0.0, -0.03), 0.029);
    objects.named("nose");
    objects.ball("hair", at(-0.028, 0.0, 0.012), 0.132);
    objects.named("hair");
    for (name, side) in [("right", -facing), ("left", facing)] {
        objects.ball("skin", at(-0.005, 0.132 * side, -0.01), 0.036);
        objects.named(&format!("{name} ear"));
        objects.ball("linen", at(0.112, 0.05 * side, 0.028), 0.024);
        objects.named(&format!("white of the {name} eye"));
        objects.ball("slot", at(0.129, 0.052 * side, 0.028), 0.0115);
        objects.named(&format!("{name} eye"));
        objects.tube("hair", at(0.122, 0.026 * side, 0.066), at(0.108, 0.08 * side, 0.06), 0.011);
        objects.named(&format!("{name} eyebrow"));
        if has_moustache {
            objects.tube("hair", at(0.14, 0.012 * side, -0.068), at(0.118, 0.092 * side, -0.088), 0.022);
            objects.named(&format!("{name} half of the moustache"));
        }
    }
    if has_hat {
        hat(objects, at(-0.012, 0.0, 0.075));
    }
}

/// Adds a bowler hat on a brim with this middle.
fn hat(objects: &mut Objects, [x, y, z]: Place) {
    let up = |up: f64| [x, y, z + up];
    objects.cylinder("hat", up(0.0), up(0.016), 0.225);
    objects.named("brim of the hat");
    objects.ring("hat", up(0.016), [0.0, 0.0, 1.0], [0.222, 0.016]);
    objects.named("edge of the brim");
    objects.cylinder("hat band", up(0.0), up(0.062), 0.155);
    objects.named("band of the hat");
    objects.tube("hat", up(0.02), up(0.082), 0.15);
    objects.named("crown of the hat");
}

/// Adds somebody who walks along the pavement.
pub fn person(objects: &mut Objects, person: &Person) {
    let &Person { at: [x, y], facing, height, coat, trousers, has_hat } = person;
    // Measures are those of somebody 2.7 tall.
    let scale = height / 2.7;
    let at = |ahead: f64, aside: f64, up: f64| [x + facing * ahead * scale, y + aside * scale, up * scale];
    for (side, step) in [(-1.0, 0.28), (1.0, -0.24)] {
        let hip = at(0.0, 0.1 * side, 1.3);
        let knee = at(0.4 * step + 0.06, 0.1 * side, 0.75);
        let heel = at(step, 0.1 * side, 0.16 + if step < 0.0 { 0.06 } else { 0.0 });
        let cloth = trousers.unwrap_or("skin");
        objects.tube(cloth, hip, knee, 0.115 * scale);
        objects.tube(cloth, knee, heel, 0.085 * scale);
        let toe = at(step + 0.2, 0.11 * side, 0.06);
        objects.tube("black leather", at(step, 0.1 * side, 0.08), toe, 0.06 * scale);
        let elbow = at(-0.5 * step - 0.04, 0.32 * side, 1.62);
        let hand = at(-0.8 * step + 0.06, 0.3 * side, 1.24);
        objects.tube(coat, at(0.0, 0.24 * side, 2.12), elbow, 0.085 * scale);
        objects.tube(coat, elbow, hand, 0.07 * scale);
        objects.ball("skin", hand, 0.075 * scale);
        objects.tube(coat, at(0.0, 0.13 * side, 2.05), at(0.0, 0.1 * side, 1.35), 0.15 * scale);
        // The skirts of the coat, or a skirt.
        let hem = if trousers.is_some() { 0.95 } else { 0.7 };
        objects.tube(coat, at(0.02, 0.09 * side, 1.4), at(0.02, 0.13 * side, hem), 0.17 * scale);
    }
    objects.tube(coat, at(0.0, -0.2, 2.12), at(0.0, 0.2, 2.12), 0.11 * scale);
    objects.tube("skin", at(0.0, 0.0, 2.15), at(0.02, 0.0, 2.4), 0.075 * scale);
    head_of(objects, at(0.03, 0.0, 2.52), facing, has_hat, trousers.is_some());
}

/// Adds the head of a passer-by: without names, of which each means one body.
fn head_of(objects: &mut Objects, [x, y, z]: Place, facing: f64, has_hat: bool, is_man: bool) {
    objects.ball("skin", [x, y, z], 0.15);
    objects.tube("skin", [x + 0.03 * facing, y, z - 0.03], [x + 0.05 * facing, y, z - 0.12], 0.1);
    objects.ball("skin", [x + 0.155 * facing, y, z - 0.03], 0.03);
    objects.ball("hair", [x - 0.035 * facing, y, z + 0.02], if is_man { 0.145 } else { 0.165 });
    if has_hat {
        objects.cylinder("hat", [x, y, z + 0.08], [x, y, z + 0.1], 0.23);
        objects.tube("hat", [x, y, z + 0.09], [x, y, z + 0.15], 0.155);
    }
}
