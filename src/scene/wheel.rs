//! A wheel of a scene file: its bodies, and how they turn.
//!
//! The axle lies along y. Angles in the wheel are from +x towards +z, as it is at t' = 0.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use relativity_core::{Turning, math};
use relativity_render::{Body, Emission, Paint, Pattern, Shape, Spin};

use super::error::Located;
use super::light;
use super::object::Object;
use super::table::Table;

/// End of a wheel's name, which the names of its parts replace.
const WHEEL: &str = "wheel";
/// Length of a valve inwards from the rim, in radii of the wheel.
const VALVE: f64 = 0.15;

/// The motion of a wheel within its group.
#[derive(Debug, Clone, Copy)]
enum WheelMotion {
    Still,
    Turns(Turning),
}

/// The changes that an include makes to its wheels.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Changes {
    motion: Option<WheelMotion>,
    tread: Option<f64>,
    valve: Option<bool>,
}

impl Changes {
    const KEYS: [&str; 4] = ["rolls", "rim_speed", "tread", "valve"];

    /// Parses the changes in a table of an include.
    pub fn from_table(wheels: &Table) -> Result<Self, Located> {
        wheels.check_keys(&Self::KEYS)?;
        Self::read(wheels)
    }

    fn read(table: &Table) -> Result<Self, Located> {
        Ok(Self { motion: motion(table)?, tread: table.size("tread")?, valve: table.truth("valve")? })
    }

    /// Returns the turning of the wheels in a table that gives their motion alone, if any turns: this one by
    /// default.
    pub fn turning_of(self, table: &Table, default: Turning) -> Result<Option<Turning>, Located> {
        Ok(match self.motion.or(motion(table)?) {
            Some(WheelMotion::Turns(turning)) => Some(turning),
            Some(WheelMotion::Still) => None,
            None => Some(default),
        })
    }

    /// Returns these changes, completed by those of `others`.
    pub fn or(self, others: Self) -> Self {
        Self {
            motion: self.motion.or(others.motion),
            tread: self.tread.or(others.tread),
            valve: self.valve.or(others.valve),
        }
    }
}

/// Parses the motion of a wheel, if one is given.
fn motion(wheel: &Table) -> Result<Option<WheelMotion>, Located> {
    let (rolls, speed) = (wheel.truth("rolls")?, wheel.coordinate("rim_speed")?);
    match (rolls, speed) {
        (Some(true), Some(_)) => Err(wheel.wrong("rim_speed", "left out where rolls = true, which sets it")),
        (Some(true), None) => Ok(Some(WheelMotion::Turns(Turning::Rolling))),
        (_, Some(speed)) if speed.abs() < 1.0 => Ok(Some(WheelMotion::Turns(Turning::RimSpeed(speed)))),
        (_, Some(_)) => Err(wheel.wrong(
            "rim_speed",
            "between -1 and 1, the speed of light (above 0 it turns as if rolling to +x)",
        )),
        (Some(false), None) => Ok(Some(WheelMotion::Still)),
        (None, None) => Ok(None),
    }
}

/// Measures from which the bodies of a wheel are made.
struct Wheel {
    hub: DVec3,
    radius: f64,
    /// Radii of the tubes of tyre and rim, and of the circle in the middle of the rim's.
    tyre: f64,
    rim: f64,
    rim_radius: f64,
    /// Length and radius of the hub.
    axle: f64,
    hub_radius: f64,
    /// Radius of the circles on which spokes start, and the distance of these.
    flange_radius: f64,
    flanges: f64,
    spokes: usize,
    spoke_radius: f64,
    /// Crossing of spokes: the angle by which the start is behind and ahead of the end, in turn, and where
    /// the first ends; radians.
    crossing: f64,
    angle: f64,
}

/// The bodies of a wheel: tyre, rim, hub, spokes, and its valve if it has one.
pub(super) fn wheel(table: &Table, changes: Changes) -> Result<Vec<Object>, Located> {
    let wheel = Wheel::read(table)?;
    let name = table.string("name")?.unwrap_or(WHEEL);
    let light = Body {
        emission: light::emission(table)?,
        brightness: light::brightness(table)?,
        ..Body::white(wheel.hub_tube())
    };
    let changes = changes.or(Changes::read(table)?);
    let spin = match changes.motion {
        Some(WheelMotion::Turns(turning)) => {
            Some(Spin { hub: wheel.hub.to_array(), radius: wheel.radius, turning })
        }
        Some(WheelMotion::Still) | None => None,
    };
    let tread = changes.tread.map_or(Pattern::Plain, |spacing| wheel.tread(spacing));
    let object = |name: String, shape, pattern| Object {
        body: Body { shape, pattern, spin, ..light.clone() },
        name: Some(name),
        include: None,
        span: table.span.clone(),
    };
    let mut tyre = object(part_name(name, "tyre"), wheel.ring(wheel.radius - wheel.tyre, wheel.tyre), tread);
    if table.has("tyre_paint") {
        let paint = Paint::Smooth(light::paint(table, "tyre_paint")?);
        tyre.body = Body { emission: Emission::Painted(paint), brightness: 1.0, ..tyre.body };
    }
    let mut objects = vec![
        tyre,
        object(part_name(name, "rim"), wheel.ring(wheel.rim_radius, wheel.rim), Pattern::Plain),
        object(part_name(name, "hub"), wheel.hub_tube(), Pattern::Plain),
    ];
    let spoke =
        |number| object(format!("{name}'s spoke {}", number + 1), wheel.spoke(number), Pattern::Plain);
    objects.extend((0..wheel.spokes).map(spoke));
    if changes.valve == Some(true) {
        objects.push(object(part_name(name, "valve"), wheel.valve(), Pattern::Plain));
    }
    Ok(objects)
}

/// Returns the name of a part of the wheel called `wheel`: the "tyre" of the "front wheel" is the "front
/// tyre".
fn part_name(wheel: &str, part: &str) -> String {
    format!("{} {part}", wheel.strip_suffix(WHEEL).unwrap_or(wheel).trim_end()).trim_start().to_owned()
}

impl Wheel {
    const KEYS: [&str; 19] = [
        "name",
        "hub",
        "radius",
        "tyre",
        "rim",
        "rim_radius",
        "axle",
        "hub_radius",
        "flange_radius",
        "flanges",
        "spokes",
        "spoke_radius",
        "crossing",
        "angle",
        "rolls",
        "rim_speed",
        "tread",
        "valve",
        "tyre_paint",
    ];

    fn read(table: &Table) -> Result<Self, Located> {
        table.check_keys(&[&Self::KEYS[..], &light::KEYS].concat())?;
        let (radius, tyre, rim) = (
            table.needed("radius", Table::size)?,
            table.needed("tyre", Table::size)?,
            table.needed("rim", Table::size)?,
        );
        let within = radius - 2.0 * tyre - rim;
        let rim_radius = table.size("rim_radius")?.unwrap_or(within);
        let (hub_radius, spoke_radius) =
            (table.needed("hub_radius", Table::size)?, table.needed("spoke_radius", Table::size)?);
        let spokes = table.needed("spokes", Table::count)?;
        let wheel = Self {
            hub: table.needed("hub", Table::point)?.into(),
            radius,
            tyre,
            rim,
            rim_radius,
            axle: table.needed("axle", Table::size)?,
            hub_radius,
            flange_radius: table.size("flange_radius")?.unwrap_or(hub_radius),
            flanges: table.size("flanges")?.unwrap_or(0.0),
            spokes,
            spoke_radius,
            crossing: table.coordinate("crossing")?.unwrap_or(0.0).to_radians(),
            angle: table.coordinate("angle")?.map_or(PI / spokes as f64, f64::to_radians),
        };
        wheel.check(table)
    }

    /// Returns the wheel, unless its parts do not lie one inside the other.
    fn check(self, table: &Table) -> Result<Self, Located> {
        let wrong = |key, expected| Err(table.wrong(key, expected));
        if 4.0 * self.tyre >= self.radius {
            return wrong("tyre", "below a quarter of `radius`: it is the radius of the tyre's tube");
        }
        if self.rim >= self.rim_radius {
            return wrong("rim", "smaller: it is the radius of the rim's tube, which lies inside the tyre");
        }
        if self.rim_radius + self.rim > self.radius {
            return wrong("rim_radius", "so small that the rim lies inside `radius`");
        }
        if self.flange_radius + self.spoke_radius >= self.rim_radius {
            let key = if table.has("flange_radius") { "flange_radius" } else { "hub_radius" };
            return wrong(key, "so small that there is room for spokes out to the rim");
        }
        if self.hub_radius >= self.rim_radius {
            return wrong("hub_radius", "smaller than the rim around it");
        }
        Ok(self)
    }

    /// A place in the wheel, so far to the left (along y) of its middle plane.
    fn place(&self, radius: f64, angle: f64, left: f64) -> [f64; 3] {
        let (sine, cosine) = math::sin_cos(angle);
        (self.hub + DVec3::new(radius * cosine, left, radius * sine)).to_array()
    }

    fn ring(&self, radius: f64, tube_radius: f64) -> Shape {
        Shape::Ring { centre: self.hub.to_array(), axis: [0.0, 1.0, 0.0], radius, tube_radius }
    }

    fn hub_tube(&self) -> Shape {
        let end = |left| (self.hub + DVec3::new(0.0, left, 0.0)).to_array();
        Shape::Tube { from: end(-0.5 * self.axle), to: end(0.5 * self.axle), radius: self.hub_radius }
    }

    /// The spoke of this number, from 0: from the right and the left flange in turn, behind and ahead of its
    /// end.
    fn spoke(&self, number: usize) -> Shape {
        let end = self.angle + TAU * number as f64 / self.spokes as f64;
        let side = if number.is_multiple_of(2) { -1.0 } else { 1.0 };
        Shape::Tube {
            from: self.place(self.flange_radius, end + side * self.crossing, 0.5 * side * self.flanges),
            to: self.place(self.rim_radius - self.spoke_radius, end, 0.0),
            radius: self.spoke_radius,
        }
    }

    /// A tube as thick as the rim, from there inwards, midway between the last spoke and the first.
    fn valve(&self) -> Shape {
        let angle = self.angle - PI / self.spokes as f64;
        let inner = (self.rim_radius - VALVE * self.radius).max(0.5 * self.rim_radius);
        Shape::Tube {
            from: self.place(self.rim_radius, angle, 0.0),
            to: self.place(inner, angle, 0.0),
            radius: self.rim,
        }
    }

    /// Bands across the tyre: the even number of them that comes closest to a `spacing`.
    fn tread(&self, spacing: f64) -> Pattern {
        let around = TAU * (self.radius - self.tyre);
        let pairs = (0.5 * around / spacing).round().max(1.0);
        Pattern::Stripes { step: 0.5 * around / pairs }
    }
}
