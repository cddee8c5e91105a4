//! The files beside a model that it names, and the remarks on those that are missing.

use std::cell::{Cell, RefCell};

use gamow_platform::messages;
use relativity_render::geometry::triangles::MOST_TEXELS;

/// Largest number of remarks that are kept of a model.
const MOST_REMARKS: usize = 20;
/// Largest number of files that are searched for in other places than those that the model names.
const MOST_SEARCHES: u32 = 100;
/// Largest number of parts at the end of a path that are tried without those before.
const MOST_TAILS: usize = 4;

/// Reads the file of this name beside the model.
type Read<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// The files beside a model.
pub struct Companions<'a> {
    read: Read<'a>,
    /// Returns a name as the file system spells it, if it differs in the case of letters alone.
    spelt: &'a dyn Fn(&str) -> Option<String>,
    searches: Cell<u32>,
    remarks: RefCell<Vec<String>>,
    /// Number of texels that its pictures may have together.
    pub texels: Cell<u64>,
}

impl<'a> Companions<'a> {
    /// Returns the files that `read` has, and `spelt` finds in another spelling.
    pub fn new(read: Read<'a>, spelt: &'a dyn Fn(&str) -> Option<String>) -> Self {
        let (searches, texels) = (Cell::new(0), Cell::new(MOST_TEXELS));
        Self { read, spelt, searches, remarks: RefCell::default(), texels }
    }

    /// Returns the bytes of the file that the model calls `name`: there, or else in one of these folders by
    /// the end of its path, or with letters of another case, which is remarked.
    ///
    /// # Errors
    ///
    /// No such file, or one that cannot be read: why the file of the full name cannot.
    pub fn find(&self, name: &str, folders: &[&str]) -> Result<Vec<u8>, String> {
        let name = &name.replace('\\', "/");
        let unread = match (self.read)(name) {
            Ok(bytes) => return Ok(bytes),
            Err(unread) => unread,
        };
        let searches = self.searches.get();
        if searches == MOST_SEARCHES {
            return Err(unread);
        }
        self.searches.set(searches + 1);
        let found = folders.iter().find_map(|folder| {
            tails(name).find_map(|tail| {
                let place = format!("{folder}{tail}");
                let spelt = || (self.spelt)(&place);
                (self.read)(&place).ok().map(|bytes| (bytes, place.clone())).or_else(|| {
                    let place = spelt()?;
                    Some(((self.read)(&place).ok()?, place))
                })
            })
        });
        let (bytes, place) = found.ok_or(unread)?;
        if folders.iter().all(|folder| format!("{folder}{name}") != place) {
            self.remark(format!(
                "{} was read in place of {}",
                messages::excerpt(&place),
                messages::excerpt(name)
            ));
        }
        Ok(bytes)
    }

    /// Whether `name` has blanks in it and is that of one file.
    pub fn is_one(&self, name: &str) -> bool {
        name.contains(char::is_whitespace) && (self.read)(&name.replace('\\', "/")).is_ok()
    }

    /// Notes something that the user should know of the model: once, and not at length.
    pub fn remark(&self, remark: String) {
        let mut remarks = self.remarks.borrow_mut();
        if remarks.len() < MOST_REMARKS && !remarks.contains(&remark) {
            remarks.push(remark);
        }
    }

    /// Returns the remarks that were made, in their order.
    pub fn into_remarks(self) -> Vec<String> {
        self.remarks.into_inner()
    }
}

/// The ends of a path, from all of it to the name of the file.
fn tails(path: &str) -> impl Iterator<Item = &str> {
    let parts = path.split('/').count();
    let cuts = path.match_indices('/').skip(parts.saturating_sub(MOST_TAILS));
    std::iter::once(path).chain(cuts.map(|(place, _)| &path[place + 1..])).filter(|tail| !tail.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_found_where_it_is_named_or_by_the_end_of_its_path() {
        let read = |name: &str| match name {
            "wood.png" => Ok(vec![1]),
            "maps/wood.png" => Ok(vec![2]),
            "Stone.PNG" => Ok(vec![3]),
            _ => Err(format!("there is no {name}")),
        };
        let spelt = |name: &str| name.eq_ignore_ascii_case("stone.png").then(|| "Stone.PNG".to_owned());
        for (name, folder, bytes, remark) in [
            ("wood.png", "", 1, None),
            ("maps\\wood.png", "", 2, None),
            (
                "C:\\Users\\me\\Desktop\\wood.png",
                "",
                1,
                Some("wood.png was read in place of C:/Users/me/Desktop/wood.png"),
            ),
            (
                "/home/me/maps/wood.png",
                "",
                2,
                Some("maps/wood.png was read in place of /home/me/maps/wood.png"),
            ),
            ("../wood.png", "", 1, Some("wood.png was read in place of ../wood.png")),
            ("wood.png", "maps/", 1, None),
            ("STONE.png", "", 3, Some("Stone.PNG was read in place of STONE.png")),
        ] {
            let companions = Companions::new(&read, &spelt);
            assert_eq!(companions.find(name, &[folder]), Ok(vec![bytes]), "{name}");
            assert_eq!(companions.into_remarks().first().map(String::as_str), remark, "{name}");
        }
        let companions = Companions::new(&read, &spelt);
        assert_eq!(companions.find("a/glass.png", &[""]), Err("there is no a/glass.png".to_owned()));
        for _ in 0..1000 {
            assert!(companions.find("glass.png", &[""]).is_err());
            companions.remark("it is cracked".to_owned());
        }
        assert_eq!((companions.searches.get(), companions.into_remarks().len()), (MOST_SEARCHES, 1));
    }
}
