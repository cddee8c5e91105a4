//! The note in a picture on light that eyes do not see.

use relativity_render::colour::spectrum::Band;
use relativity_render::light::received::Shares;

/// Share of a group from which on it is remarked on.
const SUBSTANTIAL: f64 = 0.03;
/// From this part on it is all of it.
const ALL: f64 = 0.97;

/// Returns the note on light outside the visible, drawn hatched or else black, from the shares of a picture's
/// groups; `None` where there is little.
#[must_use]
pub fn notice(groups: &[Shares], is_hatched: bool) -> Option<String> {
    let shown: Vec<&Shares> =
        groups.iter().filter(|shares| shares.iter().any(|share| *share > 0.0)).collect();
    let any = |band: Band, part: f64| shown.iter().any(|shares| shares[band as usize] >= part);
    let all = |band: Band| !shown.is_empty() && shown.iter().all(|shares| shares[band as usize] >= ALL);
    let unseen = [Band::Ultraviolet, Band::Infrared];
    if let Some(band) = unseen.into_iter().find(|band| all(*band)) {
        return Some(format!("received as {}, invisible to the eye", band.name()));
    }
    let names: Vec<_> = unseen.into_iter().filter(|band| any(*band, SUBSTANTIAL)).map(Band::name).collect();
    let drawn = if is_hatched { "hatched" } else { "black" };
    (!names.is_empty()).then(|| format!("{drawn}: {}, invisible to the eye", names.join(" and ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unseen_light_is_explained_and_nothing_else() {
        let said = |groups: &[Shares]| notice(groups, true).unwrap_or_default();
        assert_eq!(said(&[[1.0, 0.0, 0.0]]), "received as ultraviolet, invisible to the eye");
        assert_eq!(said(&[[0.0, 0.02, 0.98]]), "received as infrared, invisible to the eye");
        assert_eq!(said(&[[0.5, 0.5, 0.0]]), "hatched: ultraviolet, invisible to the eye");
        assert_eq!(said(&[[0.4, 0.2, 0.4]]), "hatched: ultraviolet and infrared, invisible to the eye");
        // A street in sight, and a rider who is not.
        assert_eq!(said(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), "hatched: ultraviolet, invisible to the eye");
        assert_eq!(said(&[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), "");
        assert_eq!(said(&[[0.01, 0.99, 0.0]]), "");
        assert_eq!(said(&[]), "");
        let black = notice(&[[0.5, 0.5, 0.0]], false);
        assert_eq!(black.as_deref(), Some("black: ultraviolet, invisible to the eye"));
    }
}
