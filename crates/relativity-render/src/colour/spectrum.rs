//! Names of wavelengths: what eyes see of them, and what that colour is called.

/// Range of visible light, nm. Colours fade towards its ends.
pub const VISIBLE_NM: [f64; 2] = [380.0, 780.0];

/// Upper end of each colour but the last, nm, and the last: the spectrum as it is usually divided, with cyan
/// for the transition that looks like neither blue nor green.
const COLOURS: [(f64, &str); 7] = [
    (450.0, "violet"),
    (485.0, "blue"),
    (500.0, "cyan"),
    (565.0, "green"),
    (590.0, "yellow"),
    (625.0, "orange"),
    (VISIBLE_NM[1], "red"),
];

/// Above this temperature what glows is seen to, K (the Draper point: J. W. Draper, 1847).
const DRAPER_KELVIN: f64 = 798.0;

/// Part of the spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Band {
    /// Shorter than what eyes see.
    Ultraviolet,
    /// Light that eyes see.
    Visible,
    /// Longer than what eyes see.
    Infrared,
}

impl Band {
    /// From the shortest waves to the longest.
    pub const ALL: [Self; 3] = [Self::Ultraviolet, Self::Visible, Self::Infrared];

    /// The band that holds this wavelength (above 0); both ends of the visible range belong to it.
    #[must_use]
    pub fn from_wavelength(wavelength_nm: f64) -> Self {
        let [shortest, longest] = VISIBLE_NM;
        if wavelength_nm < shortest {
            Self::Ultraviolet
        } else if wavelength_nm > longest {
            Self::Infrared
        } else {
            Self::Visible
        }
    }

    /// Returns the band of a body that glows at this temperature, K: eyes see it however hot it is.
    #[must_use]
    pub fn of_glow(kelvin: f64) -> Self {
        if kelvin < DRAPER_KELVIN { Self::Infrared } else { Self::Visible }
    }

    /// Returns the name of the band.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ultraviolet => "ultraviolet",
            Self::Visible => "visible",
            Self::Infrared => "infrared",
        }
    }
}

/// Returns the name of light of this wavelength (above 0): its colour, or the band if eyes do not see it.
///
/// # Examples
///
/// ```
/// use relativity_render::colour::spectrum::name;
///
/// let names = [189.0, 410.0, 567.0, 606.0, 900.0].map(name);
/// assert_eq!(names, ["ultraviolet", "violet", "yellow", "orange", "infrared"]);
/// ```
#[must_use]
pub fn name(wavelength_nm: f64) -> &'static str {
    let band = Band::from_wavelength(wavelength_nm);
    let colour = COLOURS.iter().find(|(end, _)| band == Band::Visible && wavelength_nm <= *end);
    colour.map_or(band.name(), |(_, colour)| colour)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::linear_srgb;

    #[test]
    fn bands_end_where_colours_do() {
        let is_black = |wavelength| linear_srgb(wavelength) == [0.0; 3];
        let [first, last] = VISIBLE_NM;
        assert!(is_black(first) && is_black(last) && !is_black(first + 1.0) && !is_black(last - 1.0));
        assert_eq!(
            [first - 0.1, first, last, last + 0.1].map(name),
            ["ultraviolet", "violet", "red", "infrared"]
        );
    }

    #[test]
    fn names_agree_with_the_largest_component_of_the_colour() {
        let largest = |wavelength| {
            let rgb = linear_srgb(wavelength);
            (0..3).max_by(|&a, &b| rgb[a].total_cmp(&rgb[b])).expect("three")
        };
        for (name_there, component, wavelengths) in
            [("red", 0, [630.0, 700.0]), ("green", 1, [510.0, 550.0]), ("blue", 2, [455.0, 480.0])]
        {
            for wavelength in wavelengths {
                assert_eq!((name(wavelength), largest(wavelength)), (name_there, component), "{wavelength}");
            }
        }
    }
}
