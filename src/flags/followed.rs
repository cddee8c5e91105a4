//! Points on bodies of a scene, as flags and files have them.

use std::fmt;
use std::str::FromStr;

use super::numbers::coordinates;

/// A point on a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedPoint {
    /// Place of the point at rest.
    pub place: [f64; 3],
    /// The number of the body in the scene, from 0.
    pub body: usize,
}

/// Greatest number of points in a list.
const MOST: usize = 64;

/// Points that are followed, at least one: written `X,Y,Z@BODY;X,Y,Z@BODY`.
#[derive(Debug, Clone, PartialEq)]
pub struct Followed(pub Vec<FollowedPoint>);

impl fmt::Display for Followed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, FollowedPoint { place: [x, y, z], body }) in self.0.iter().enumerate() {
            let separator = if number == 0 { "" } else { ";" };
            write!(f, "{separator}{x},{y},{z}@{body}")?;
        }
        Ok(())
    }
}

impl FromStr for Followed {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.split(';').count() > MOST {
            return Err(format!("at most {MOST} points can be followed"));
        }
        text.split(';').map(point).collect::<Result<_, _>>().map(Self)
    }
}

fn point(text: &str) -> Result<FollowedPoint, String> {
    let (place, body) =
        text.split_once('@').ok_or("write a place and the number of its body like 0,3,2@0")?;
    let body = body.trim().parse().map_err(|_| "the number of a body is a whole number from 0".to_owned())?;
    Ok(FollowedPoint { place: coordinates(place)?, body })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_places_on_bodies() {
        let point = |place, body| FollowedPoint { place, body };
        let both = Followed(vec![point([-0.5, 2.968, 2.493], 0), point([1e-9, 3.0, 2.0], 17)]);
        assert_eq!(both.to_string().parse(), Ok(both.clone()));
        assert_eq!("-0.5, 2.968, 2.493 @ 0; 1e-9,3,2@17".parse(), Ok(both));
        for text in ["", "0,3,2", "0,3@1", "0,3,2@-1", "0,3,2@1;"] {
            assert!(text.parse::<Followed>().is_err(), "{text}");
        }
    }
}
