//! Whether two scenes are the same: a hash of what is in them, however the program calls its parts.

use relativity_core::Turning;
use relativity_render::{Body, Emission, Motion, Paint, Pattern, Spin};

use super::content::{Scene, SceneGroup};
use crate::files::provenance::Provenance;

impl Scene {
    /// The fingerprint of its content, 16 hexadecimal digits: equal for equal scenes, and as good as never
    /// equal for others.
    ///
    /// The FNV-1a hash (G. Fowler, L. C. Noll, K.-P. Vo) of, in this order: the name, the tracked point, the
    /// height of the ground, its street if there is one, "sunlit" if it is, and of each group its name, its
    /// own beta, and its bodies; of a body its shape by the name in a scene file, the numbers of that in the
    /// order of the scene format (of a box half its size, and its turn as a quaternion), its wavelength, the
    /// linear colour of other than white paint, the name of its material or the temperature at which it glows
    /// after "paint", "material" or "glows", and, if it is below 1, its brightness after that word, and if it
    /// has one its pattern by name, with its spacing; and if it turns after "rolls" or "turns" its axle, the
    /// radius on which it rolls and, if it does not roll, the speed of its rim; and of a model, whose shape
    /// is the box around it, after "triangles" the same hash of these, word by word. Names end in a zero
    /// byte; numbers go in bit by bit, big end first, those that are not there as infinity.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let mut hash = Hash::default();
        hash.name(&self.name);
        hash.numbers(&self.tracked);
        hash.numbers(&[self.ground_z.unwrap_or(f64::INFINITY)]);
        self.street.iter().for_each(|street| hash.numbers(street));
        if self.sunlit {
            hash.name("sunlit");
        }
        for group in &self.groups {
            hash.group(group);
            self.bodies[group.bodies()].iter().for_each(|body| hash.body(body));
        }
        format!("{:016x}", hash.0)
    }

    /// Returns the provenance of a picture of the scene, which this `command` makes.
    #[must_use]
    pub fn provenance(&self, command: String) -> Provenance {
        Provenance {
            title: self.name.clone(),
            parameters: command,
            scene_fingerprint: self.fingerprint(),
            models: self.reports().collect::<Vec<_>>().join("\n"),
        }
    }
}

/// FNV-1a of 64 bits.
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn name(&mut self, name: &str) {
        self.bytes(name.as_bytes());
        self.bytes(&[0]);
    }

    fn numbers(&mut self, numbers: &[f64]) {
        for number in numbers {
            self.bytes(&number.to_bits().to_be_bytes());
        }
    }

    fn group(&mut self, group: &SceneGroup) {
        self.name(&group.name);
        self.numbers(&[match group.motion {
            Motion::Scene => f64::INFINITY,
            Motion::Own(velocity) => velocity.beta(),
            Motion::WithEyes => f64::NEG_INFINITY,
        }]);
    }

    fn body(&mut self, body: &Body) {
        self.name(body.shape.name());
        self.numbers(&body.shape.numbers());
        self.numbers(&[body.emission.wavelength_nm().unwrap_or(f64::INFINITY)]);
        self.light(body.emission);
        if body.brightness < 1.0 {
            self.name("brightness");
            self.numbers(&[body.brightness]);
        }
        self.pattern(body.pattern);
        self.spin(body.spin);
        if let Some(triangles) = &body.triangles {
            self.name("triangles");
            self.bytes(&triangles.fingerprint().to_be_bytes());
        }
    }

    /// Nothing of light of one wavelength, and of white light.
    fn light(&mut self, emission: Emission) {
        match emission {
            Emission::Wavelength(_) | Emission::WHITE => {}
            Emission::Glowing(kelvin) => {
                self.name("glows");
                self.numbers(&[kelvin]);
            }
            Emission::Painted(Paint::Smooth(colour)) => {
                self.name("paint");
                self.numbers(&colour);
            }
            Emission::Painted(Paint::Measured(material)) => {
                self.name("material");
                self.name(material.name());
            }
        }
    }

    /// Nothing of a body that does not turn.
    fn spin(&mut self, spin: Option<Spin>) {
        let Some(Spin { hub, radius, turning }) = spin else { return };
        let (name, rim_speed) = match turning {
            Turning::Rolling => ("rolls", None),
            Turning::RimSpeed(speed) => ("turns", Some(speed)),
        };
        self.name(name);
        self.numbers(&hub);
        self.numbers(&[radius]);
        self.numbers(rim_speed.as_slice());
    }

    /// Nothing of a plain body.
    fn pattern(&mut self, pattern: Pattern) {
        let (name, spacing) = match pattern {
            Pattern::Plain => return,
            Pattern::Faces => ("faces", f64::INFINITY),
            Pattern::Graticule { step_degrees } => ("graticule", step_degrees),
            Pattern::Chequer { step } => ("chequer", step),
            Pattern::Stripes { step } => ("stripes", step),
        };
        self.name(name);
        self.numbers(&[spacing]);
    }
}

#[cfg(test)]
mod tests {
    use relativity_render::{Material, Velocity};

    use super::*;

    #[test]
    fn the_fingerprint_of_a_preset_is_pinned() {
        let scene = Scene::preset("two-balls").expect("it is a preset");
        assert_eq!(scene.fingerprint(), "67c61ac45f224318");
    }

    #[test]
    fn every_part_of_a_scene_shows_in_its_fingerprint() {
        let scene = Scene::preset("cyclist").expect("a preset");
        let mut others = vec![scene.clone(); 21];
        others[0].name.push('2');
        others[1].tracked[2] += 1e-9;
        others[2].ground_z = None;
        others[3].bodies.swap(0, 1);
        others[4].bodies[0].emission = Emission::Wavelength(701.0);
        others[7].bodies[0].emission = Emission::WHITE;
        others[8].bodies[0].brightness = 0.5;
        others[5].groups[0].count -= 1;
        others[6].groups[0].motion = Motion::Own(Velocity::REST);
        others[9].street = Some([2.0, 9.0, 13.0]);
        others[10].bodies[0].pattern = Pattern::Stripes { step: 0.5 };
        others[11].bodies[0].pattern = Pattern::Stripes { step: 0.6 };
        let spin = Spin { hub: [-0.5, 3.0, 2.0], radius: 0.5, turning: Turning::Rolling };
        others[12].bodies[0].spin = Some(spin);
        others[13].bodies[0].spin = Some(Spin { radius: 0.6, ..spin });
        others[14].bodies[0].spin = Some(Spin { turning: Turning::RimSpeed(0.5), ..spin });
        others[15].bodies[0].spin = Some(spin.moved([0.0, 1e-9, 0.0]));
        others[16].bodies[0].emission = Emission::Glowing(2700.0);
        others[17].bodies[0].emission = Emission::Painted(Paint::Smooth([0.5; 3]));
        others[18].bodies[0].emission = Emission::Painted(Paint::Measured(Material::ALL[0]));
        others[19].bodies[0].emission = Emission::Painted(Paint::Measured(Material::ALL[1]));
        others[20].sunlit = true;
        let mut fingerprints: Vec<_> = others.iter().map(Scene::fingerprint).collect();
        fingerprints.push(scene.fingerprint());
        fingerprints.sort();
        fingerprints.dedup();
        assert_eq!(fingerprints.len(), 22);
    }
}
