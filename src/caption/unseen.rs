//! Why a part of a picture is dark.

use relativity_render::received::Shares;
use relativity_render::spectrum::Band;

/// From this part of a group on it is said.
const SUBSTANTIAL: f64 = 0.03;
/// From this part on it is all of it.
const ALL: f64 = 0.97;

/// What a picture says of light outside the visible in it, from the shares of its groups; `None` where there is little.
#[must_use]
pub fn notice(groups: &[Shares]) -> Option<String> {
    let shown: Vec<&Shares> =
        groups.iter().filter(|shares| shares.iter().any(|share| *share > 0.0)).collect();
    let any = |band: Band, part: f64| shown.iter().any(|shares| shares[band as usize] >= part);
    let all = |band: Band| !shown.is_empty() && shown.iter().all(|shares| shares[band as usize] >= ALL);
    let unseen = [Band::Ultraviolet, Band::Infrared];
    if let Some(band) = unseen.into_iter().find(|band| all(*band)) {
        return Some(format!("received as {}: eyes see nothing", band.name()));
    }
    let names: Vec<_> = unseen.into_iter().filter(|band| any(*band, SUBSTANTIAL)).map(Band::name).collect();
    (!names.is_empty()).then(|| format!("dark parts are {}: eyes see nothing there", names.join(" and ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_is_explained_and_nothing_else() {
        let said = |groups: &[Shares]| notice(groups).unwrap_or_default();
        assert_eq!(said(&[[1.0, 0.0, 0.0]]), "received as ultraviolet: eyes see nothing");
        assert_eq!(said(&[[0.0, 0.02, 0.98]]), "received as infrared: eyes see nothing");
        assert_eq!(said(&[[0.5, 0.5, 0.0]]), "dark parts are ultraviolet: eyes see nothing there");
        assert_eq!(
            said(&[[0.4, 0.2, 0.4]]),
            "dark parts are ultraviolet and infrared: eyes see nothing there"
        );
        // A street in sight, and a rider who is not.
        assert_eq!(
            said(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            "dark parts are ultraviolet: eyes see nothing there"
        );
        assert_eq!(said(&[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), "");
        assert_eq!(said(&[[0.01, 0.99, 0.0]]), "");
        assert_eq!(said(&[]), "");
    }
}
