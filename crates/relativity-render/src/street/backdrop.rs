//! The backdrop: a sky, a road or a grid on the ground, and house fronts, all at rest on the ground.
//!
//! To a camera at rest it is never shifted, dimmed or exposed: it gives motion something to be seen against.
//! `shaders/backdrop.wgsl` draws the same, with the same constants.

use std::cell::LazyCell;

use glam::{DVec2, DVec3, Vec3Swizzles as _};
use relativity_core::math;

use super::contact::{Contacts, DARKEST, FARTHEST};
use super::cover::{band_cover, line_cover, repeated_cover};
use super::house_fronts::{self, FrontPixel, Paints};
use super::sight::{GroundLine, StreetSight, StreetVariant};
use crate::camera::Camera;
use crate::camera::lines_of_sight::LinesOfSight;
use crate::colour::mix;
use crate::colour::sunlit::share_of_sky;
use crate::light::street_light::{StreetLight, painted};
use crate::light::tone::BRIGHTEST;
use crate::light::{palette, tone};
use crate::view::effects::{Constant, number};
use crate::view::{Appearance, Geometry};

/// Half the width of the grid's lines, one per unit of length along x and along y.
pub(crate) const LINE_HALF_WIDTH: f64 = 0.012;
/// Half the width of the two lines through the origin.
pub(crate) const AXIS_HALF_WIDTH: f64 = 0.02;
/// Share of the grid that is drawn where a pixel is p units wide on the ground: the first number less p times
/// the second, that is all of it where four pixels lie between two lines, none where only two do and lines
/// would merge.
pub(crate) const GRID_FADE: [f64; 2] = [2.0, 4.0];
/// Width of the kerbs beside a road.
pub(crate) const KERB_WIDTH: f64 = 0.25;
/// Half the width of the line in the middle of a road.
pub(crate) const LANE_HALF_WIDTH: f64 = 0.09;
/// Length of the dashes of that line, the first of which begins at x = 0, and from one to the next.
pub(crate) const DASH: [f64; 2] = [3.0, 8.0];
/// Haze of a grid: at the distance s the share 1/(1 + haze s^2) of the ground is seen, half of a grid 20
/// units away, of a road half of it 50 units away: so the plane ends in the sky and not in a line, and the
/// flicker of far lines with it.
const GRID_HAZE: f64 = 0.0025;
const ROAD_HAZE: f64 = 0.0004;
/// Lines of sight with a lesser y meet no house fronts.
pub(crate) const LEAST_TOWARDS_FRONTS: f64 = 1e-4;
/// The sky is the zenith's colour above the height z of a line of sight of 1/`SKY_RISE`, 46 degrees: a
/// picture that looks straight ahead shows all of the gradient.
pub(crate) const SKY_RISE: f64 = 1.4;

/// Columns and rows of the tiles that a picture is drawn in.
pub(crate) const TILES: [u32; 2] = [12, 24];

/// Linear sRGB colours of a backdrop.
#[derive(Debug, Clone, Copy)]
struct Palette {
    plain: [f64; 3],
    horizon: [f64; 3],
    zenith: [f64; 3],
    earth: [f64; 3],
    grid_line: [f64; 3],
    axis_line: [f64; 3],
    asphalt: [f64; 3],
    pavement: [f64; 3],
    joint: [f64; 3],
    paint: [f64; 3],
    fronts: Paints,
}

// Dusk, not night: what is shifted out of the visible is black, and must stand out.
const DARK: Palette = Palette {
    plain: [0.055, 0.062, 0.075],
    horizon: [0.190, 0.225, 0.275],
    zenith: [0.045, 0.062, 0.105],
    earth: [0.050, 0.056, 0.066],
    grid_line: [0.145, 0.165, 0.195],
    axis_line: [0.270, 0.305, 0.350],
    asphalt: [0.040, 0.045, 0.054],
    pavement: [0.085, 0.092, 0.104],
    joint: [0.052, 0.057, 0.066],
    paint: [0.330, 0.345, 0.365],
    fronts: Paints {
        wall: [0.150, 0.152, 0.160],
        frame: [0.205, 0.205, 0.205],
        glass: [0.030, 0.036, 0.048],
        door: [0.030, 0.028, 0.028],
        shop: [0.300, 0.240, 0.150],
    },
};

const LIGHT: Palette = Palette {
    plain: [0.880, 0.890, 0.910],
    horizon: [0.860, 0.890, 0.920],
    zenith: [0.480, 0.620, 0.800],
    earth: [0.640, 0.665, 0.680],
    grid_line: [0.400, 0.430, 0.460],
    axis_line: [0.190, 0.220, 0.260],
    asphalt: [0.270, 0.280, 0.300],
    pavement: [0.560, 0.555, 0.540],
    joint: [0.400, 0.400, 0.395],
    paint: [0.900, 0.900, 0.880],
    fronts: Paints {
        wall: [0.660, 0.635, 0.590],
        frame: [0.820, 0.810, 0.790],
        glass: [0.170, 0.200, 0.240],
        door: [0.150, 0.140, 0.135],
        shop: [0.240, 0.275, 0.320],
    },
};

/// The floor that is seen below the horizon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Floor {
    /// No floor.
    Open,
    /// A grid of lines.
    Grid,
    /// A road between pavements.
    Road,
    /// A road, with house fronts beyond it.
    Street,
}

/// The part of the backdrop that some tiles of a picture show: each tile is drawn with no more than its part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum BackdropPart {
    /// Nothing but the sky.
    Sky,
    /// The grid, and the sky it ends in.
    Grid,
    /// Sky and road, without fronts.
    Road,
    /// House fronts, and the sky above them.
    Fronts,
    /// Fronts and the road before them.
    Street,
}

impl Floor {
    /// The parts of a picture with this floor.
    pub const fn parts(self) -> &'static [BackdropPart] {
        match self {
            Self::Open => &[BackdropPart::Sky],
            Self::Grid => &[BackdropPart::Sky, BackdropPart::Grid],
            Self::Road => &[BackdropPart::Sky, BackdropPart::Road],
            Self::Street => {
                &[BackdropPart::Sky, BackdropPart::Road, BackdropPart::Fronts, BackdropPart::Street]
            }
        }
    }

    /// Returns the part that shows all of it.
    pub const fn whole(self) -> BackdropPart {
        match self {
            Self::Open => BackdropPart::Sky,
            Self::Grid => BackdropPart::Grid,
            Self::Road => BackdropPart::Road,
            Self::Street => BackdropPart::Street,
        }
    }
}

impl BackdropPart {
    /// Whether the ground can be seen in it.
    pub const fn has_ground(self) -> bool {
        matches!(self, Self::Grid | Self::Road | Self::Street)
    }

    /// Whether house fronts can.
    pub const fn has_fronts(self) -> bool {
        matches!(self, Self::Fronts | Self::Street)
    }

    /// Returns the haze of the floor: at the distance s the share 1/(1 + haze s^2) of it is seen.
    pub const fn haze(self) -> f64 {
        if matches!(self, Self::Grid) { GRID_HAZE } else { ROAD_HAZE }
    }
}

/// The last pass of a picture over one part of its backdrop, with everything decided that its shader can
/// decide before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct LastPass {
    pub part: BackdropPart,
    pub street: StreetVariant,
    pub is_conformal: bool,
    /// Whether the street moves otherwise than along x.
    pub is_oblique: bool,
}

impl LastPass {
    /// Returns the values of the constants of `shaders/backdrop.wgsl`, but for the one on samples.
    pub fn constants(self) -> Vec<Constant> {
        let of_backdrop = [
            ("CONFORMAL", number(self.is_conformal)),
            ("OBLIQUE_STREET", number(self.is_oblique)),
            ("STREET_GEOMETRY", self.street.geometry()),
            ("STREET_ROW", self.street.row()),
            ("GROUND", number(self.part.has_ground())),
            ("ROAD", number(self.part != BackdropPart::Grid)),
            ("FRONTS", number(self.part.has_fronts())),
            ("TILE_COLUMNS", f64::from(TILES[0])),
            ("TILE_ROWS", f64::from(TILES[1])),
            ("KERB_WIDTH", KERB_WIDTH),
            ("LANE_HALF_WIDTH", LANE_HALF_WIDTH),
            ("DASH_LENGTH", DASH[0]),
            ("DASH_PERIOD", DASH[1]),
            ("LINE_HALF_WIDTH", LINE_HALF_WIDTH),
            ("AXIS_HALF_WIDTH", AXIS_HALF_WIDTH),
            ("GRID_FADE_START", GRID_FADE[0]),
            ("GRID_FADE_RATE", GRID_FADE[1]),
            ("LEAST_TOWARDS_FRONTS", LEAST_TOWARDS_FRONTS),
            ("HAZE", self.part.haze()),
            ("SKY_RISE", SKY_RISE),
            ("CONTACT_DARKEST", DARKEST),
            ("CONTACT_FARTHEST", FARTHEST),
        ];
        of_backdrop
            .into_iter()
            .chain(house_fronts::CONSTANTS)
            .chain(tone::constants())
            .chain([("BRIGHTEST", BRIGHTEST)])
            .chain(palette::places())
            .collect()
    }
}

/// The backdrop of one camera's picture.
#[derive(Debug, Clone, Copy)]
pub struct Backdrop {
    palette: Palette,
    /// Linear sRGB of the horizon and the zenith, and the share of the sky's own light in it.
    sky: [[f64; 4]; 2],
    aperture: DVec2,
    /// Height of the ground from the aperture, below 0: ground above the eye would hide everything.
    ground: Option<f64>,
    road: Option<[f64; 2]>,
    /// y of the house fronts from the aperture, above 0.
    fronts: Option<f64>,
    /// Contacts of bodies with the road.
    contacts: Contacts,
    lines_of_sight: LinesOfSight,
    /// Passage of lines of sight to the ground, which may move against the camera.
    street: StreetSight,
    /// Light of the street as the camera receives it.
    light: StreetLight,
}

impl Backdrop {
    /// Returns the backdrop of `camera` in a view of this `geometry`, without the shadows of bodies that
    /// touch a road.
    #[must_use]
    pub fn new(camera: &Camera, geometry: Geometry, appearance: &Appearance) -> Self {
        let aperture = camera.aperture;
        let street = StreetSight::new(camera, geometry);
        let palette = palette(appearance);
        let sky = |colour: [f64; 3]| {
            let [red, green, blue] = colour;
            [red, green, blue, share_of_sky(colour)]
        };
        Self {
            palette,
            sky: [palette.horizon, palette.zenith].map(sky),
            aperture: DVec2::new(aperture.x, aperture.y),
            ground: appearance.ground_z.map(|z| z - aperture.z).filter(|z| *z < 0.0),
            road: appearance.road,
            fronts: appearance.fronts.map(|y| y - aperture.y).filter(|y| *y > 0.0),
            contacts: Contacts::default(),
            lines_of_sight: camera.lines_of_sight(),
            street,
            light: street.light(appearance),
        }
    }

    /// Returns the backdrop with the shadows of what touches the road.
    pub(crate) fn with_contacts(self, contacts: &Contacts) -> Self {
        Self { contacts: *contacts, ..self }
    }

    /// Linear sRGB of the horizon, the zenith, the ground, its grid's lines, the paint on it, a road, and of
    /// house fronts; and the share of the sky's own light in each.
    pub(crate) fn colours(&self) -> [[f64; 4]; 11] {
        let Palette { earth, grid_line, axis_line, asphalt, .. } = self.palette;
        let [earth, lines, paint] = match self.road {
            Some(_) => [self.palette.pavement, self.palette.joint, self.palette.paint],
            None => [earth, grid_line, axis_line],
        };
        let Paints { wall, frame, glass, door, shop } = self.palette.fronts;
        let [horizon, zenith] = self.sky;
        let [earth, lines, paint, asphalt, wall, frame, glass, door, shop] =
            [earth, lines, paint, asphalt, wall, frame, glass, door, shop].map(painted);
        [horizon, zenith, earth, lines, paint, asphalt, wall, frame, glass, door, shop]
    }

    /// y of the near and the far kerb of a road, equal where there is none, and of house fronts from the
    /// aperture, 0 where there are none.
    pub(crate) fn places(&self) -> [f64; 3] {
        let [near, far] = self.road.unwrap_or_default();
        [near, far, self.fronts.unwrap_or_default()]
    }

    /// Linear sRGB of what lies behind the bodies along `line_of_sight` (unit vector).
    pub(crate) fn behind(&self, line_of_sight: DVec3) -> [f64; 3] {
        let seen = self.street.line(line_of_sight);
        let turns = || self.lines_of_sight.turns_of(line_of_sight).map(|turn| self.street.turn(&seen, turn));
        self.light.received(self.at_rest(&seen, turns), seen.camera_per_ground)
    }

    /// Linear sRGB at rest of what is `seen`, and the share of the sky's own light in it; `turns` of the line
    /// on the ground lead from one pixel to the next.
    fn at_rest(&self, seen: &GroundLine, turns: impl FnOnce() -> [DVec3; 2]) -> [f64; 4] {
        let turns = LazyCell::new(turns);
        let front = self.front(seen, || *turns);
        if let Some((colour, 1.0)) = front {
            return colour;
        }
        let below = self.height_distance(seen.direction);
        let below = below.map(|distance| self.ground(seen, *turns, distance));
        let without = below.unwrap_or_else(|| self.sky_above(seen.direction));
        front.map_or(without, |(colour, cover)| mix(without, colour, cover))
    }

    /// The colour of house fronts in a pixel, and the share of it that they cover, if any are in it.
    fn front(&self, seen: &GroundLine, turns: impl FnOnce() -> [DVec3; 2]) -> Option<([f64; 4], f64)> {
        let (fronts, ground, _) = (self.fronts?, self.ground?, self.road?);
        let direction = seen.direction;
        if direction.y <= LEAST_TOWARDS_FRONTS {
            return None;
        }
        let distance = fronts / direction.y;
        let place = DVec2::new(self.aperture.x, -ground) + direction.xz() * distance;
        let shift = |turn: DVec3| (turn.xz() - direction.xz() * (turn.y / direction.y)) * distance;
        let FrontPixel { colour, cover } = self.palette.fronts.front(place, pixel(turns(), shift))?;
        Some((self.hazy(painted(colour), seen, distance), cover))
    }

    /// Returns the colour that is seen along `seen` of a surface of this `colour` at `distance` on the
    /// ground.
    fn hazy(&self, colour: [f64; 4], seen: &GroundLine, distance: f64) -> [f64; 4] {
        let distance = distance * seen.haze_share();
        let haze = if self.road.is_some() { ROAD_HAZE } else { GRID_HAZE };
        mix(self.sky_above(seen.direction), colour, 1.0 / (1.0 + haze * distance * distance))
    }

    /// Height of the ground from the aperture, below 0; `None` if there is none to be seen.
    pub(crate) fn ground_height(&self) -> Option<f64> {
        self.ground
    }

    /// Linear sRGB of the sky along the camera's `line_of_sight` (unit vector).
    #[must_use]
    pub fn sky(&self, line_of_sight: DVec3) -> [f64; 3] {
        let seen = self.street.line(line_of_sight);
        self.light.received(self.sky_above(seen.direction), seen.camera_per_ground)
    }

    /// Returns the sky at rest along a line of sight on the ground.
    fn sky_above(&self, line_of_sight: DVec3) -> [f64; 4] {
        let [horizon, zenith] = self.sky;
        let nearness = 1.0 - (SKY_RISE * line_of_sight.z.abs()).min(1.0);
        mix(zenith, horizon, nearness * nearness)
    }

    /// Distance of the ground along the camera's `line_of_sight` (unit vector) in its frame, if it is met.
    pub(crate) fn ground_distance(&self, line_of_sight: DVec3) -> Option<f64> {
        let seen = self.street.line(line_of_sight);
        self.height_distance(seen.direction).map(|distance| distance * seen.camera_per_ground)
    }

    /// Distance of the ground along a line of sight on it.
    fn height_distance(&self, line_of_sight: DVec3) -> Option<f64> {
        let distance = self.ground? / line_of_sight.z;
        (distance > 0.0 && distance.is_finite()).then_some(distance)
    }

    /// Linear sRGB of the ground met at `distance` along a line of sight on it, which turns by `turns` from
    /// one pixel to the next.
    fn ground(&self, seen: &GroundLine, turns: [DVec3; 2], distance: f64) -> [f64; 4] {
        let n = seen.direction;
        let foot = self.aperture + n.truncate() * distance;
        let shift = |turn: DVec3| (turn.truncate() - n.truncate() * (turn.z / n.z)) * distance;
        let pixel = pixel(turns, shift);
        let [_, _, earth, lines, paint, asphalt, ..] = self.colours();
        let grid = grid_cover(foot.x, pixel.x).max(grid_cover(foot.y, pixel.y));
        let gridded = mix(earth, lines, grid);
        let painted = match self.road {
            Some(kerbs) => {
                let surface = mix(gridded, asphalt, band_cover(foot.y, kerbs, pixel.y));
                let marked = mix(surface, paint, marks_cover(foot, kerbs, pixel));
                let left = self.contacts.leave(n * distance, pixel);
                marked.map(|part| part * left)
            }
            None => mix(gridded, paint, axis_cover(foot.x, pixel.x).max(axis_cover(foot.y, pixel.y))),
        };
        self.hazy(painted, seen, distance)
    }
}

/// Returns width and height of a pixel on a surface, given the turns of the line of sight to the next;
/// `shift` gives the shift on the surface for a turn.
fn pixel(turns: [DVec3; 2], shift: impl Fn(DVec3) -> DVec2) -> DVec2 {
    let [right, down] = turns.map(shift);
    DVec2::new(math::hypot(right.x, down.x), math::hypot(right.y, down.y))
}

/// The colours for `appearance`; where the sky is plain, it has one colour.
fn palette(appearance: &Appearance) -> Palette {
    let palette = if appearance.light { LIGHT } else { DARK };
    if appearance.sky {
        return palette;
    }
    Palette { horizon: palette.plain, zenith: palette.plain, ..palette }
}

/// Share of a pixel, `pixel` wide on the ground, that the lines at whole numbers cover; a grid finer than
/// pixels is left out.
fn grid_cover(coordinate: f64, pixel: f64) -> f64 {
    let off_line = (coordinate - coordinate.round()).abs();
    line_cover(off_line, LINE_HALF_WIDTH, pixel) * (GRID_FADE[0] - GRID_FADE[1] * pixel).clamp(0.0, 1.0)
}

/// Share of a pixel that the kerbs of a road and the dashes in its middle cover.
fn marks_cover(foot: DVec2, [near, far]: [f64; 2], pixel: DVec2) -> f64 {
    let middle = 0.5 * (near + far);
    let kerbs = band_cover(foot.y, [near - KERB_WIDTH, near], pixel.y)
        + band_cover(foot.y, [far, far + KERB_WIDTH], pixel.y);
    let lane = band_cover(foot.y, [middle - LANE_HALF_WIDTH, middle + LANE_HALF_WIDTH], pixel.y);
    kerbs + lane * repeated_cover(foot.x, DASH[0], DASH[1], pixel.x)
}

/// Share of a pixel that the line at 0 covers.
fn axis_cover(coordinate: f64, pixel: f64) -> f64 {
    line_cover(coordinate.abs(), AXIS_HALF_WIDTH, pixel)
}
