//! A formula in a line of words and characters, such as `D = 1/(γ(1 − β cos θ))`.

use ratex_font::{Mode, get_symbol};
use ratex_parser::ParseNode;
use ratex_parser::parse_node::AtomFamily;

/// The formula of these nodes; `None` if there is one that no line can hold.
pub(super) fn in_words(nodes: &[ParseNode]) -> Option<String> {
    /// Pairs that stand apart when each node is spoken alone, and their spelling.
    const CLOSER: [[&str; 2]; 7] =
        [[" ,", ","], [" ;", ";"], [" )", ")"], [" ]", "]"], ["( ", "("], ["(− ", "(−"], ["= − ", "= −"]];
    let mut words = String::new();
    for node in nodes {
        words.push_str(&of_one(node)?);
    }
    let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
    Some(CLOSER.iter().fold(words, |words, [apart, closer]| words.replace(apart, closer)))
}

fn of_one(node: &ParseNode) -> Option<String> {
    Some(match node {
        ParseNode::Atom { family: AtomFamily::Rel | AtomFamily::Bin, text, .. } => {
            format!(" {} ", symbol(text))
        }
        ParseNode::Atom { family: AtomFamily::Punct, text, .. } => format!("{} ", symbol(text)),
        ParseNode::Atom { text, .. } | ParseNode::MathOrd { text, .. } | ParseNode::TextOrd { text, .. } => {
            symbol(text)
        }
        ParseNode::SpacingNode { .. } | ParseNode::Kern { .. } => " ".to_owned(),
        ParseNode::OrdGroup { body, .. }
        | ParseNode::Styling { body, .. }
        | ParseNode::Sizing { body, .. }
        | ParseNode::MClass { body, .. }
        | ParseNode::Color { body, .. }
        | ParseNode::HBox { body, .. }
        | ParseNode::Pmb { body, .. } => inside(body)?,
        ParseNode::Text { body, .. } => body.iter().map(of_one).collect::<Option<String>>()?,
        ParseNode::Font { body, .. } | ParseNode::Lap { body, .. } => of_one(body)?,
        ParseNode::SupSub { base, sup, sub, .. } => {
            let base = base.as_deref().map_or(Some(String::new()), of_one)?;
            let (base, gap) = (base.trim_end(), if base.ends_with(' ') { " " } else { "" });
            let sub =
                sub.as_deref().map(grouped).map_or(Some(String::new()), |sub| Some(format!("_{}", sub?)))?;
            let sup = sup.as_deref().map(grouped).map_or(Some(String::new()), |sup| Some(raised(&sup?)))?;
            format!("{base}{sub}{sup}{gap}")
        }
        ParseNode::GenFrac { numer, denom, has_bar_line: true, .. } => {
            format!("{}/{}", grouped(numer)?, grouped(denom)?)
        }
        ParseNode::Sqrt { body, index: None, .. } => format!("√{}", grouped(body)?),
        ParseNode::Accent { label, base, .. } => {
            format!("{} {} ", grouped(base)?, label.trim_start_matches('\\').trim_start_matches("wide"))
        }
        ParseNode::Overline { body, .. } => format!("{} bar ", grouped(body)?),
        ParseNode::Op { name: Some(name), symbol: is_symbol, .. } => {
            if *is_symbol {
                format!(" {} ", symbol(name))
            } else {
                format!(" {} ", name.trim_start_matches('\\'))
            }
        }
        ParseNode::OperatorName { body, .. } => format!(" {} ", inside(body)?),
        ParseNode::LeftRight { body, left, right, .. } => {
            format!("{}{}{}", delimiter(left), inside(body)?, delimiter(right))
        }
        ParseNode::Array { body, .. } => {
            let rows =
                body.iter().map(|row| Some(row.iter().map(of_one).collect::<Option<Vec<_>>>()?.join(" ")));
            rows.collect::<Option<Vec<_>>>()?.join("; ")
        }
        ParseNode::DelimSizing { delim, .. } | ParseNode::Middle { delim, .. } => delimiter(delim),
        _ => return None,
    })
}

fn raised(sup: &str) -> String {
    match sup {
        "2" => "²".to_owned(),
        "3" => "³".to_owned(),
        _ if sup.trim_matches(['(', '′', ')']).is_empty() => sup.replace(['(', ')'], ""),
        _ => format!("^{sup}"),
    }
}

fn inside(body: &[ParseNode]) -> Option<String> {
    let words: String = body.iter().map(of_one).collect::<Option<_>>()?;
    Some(words.trim().to_owned())
}

/// Returns the words of a node, in brackets if a sign beside it would seem to take a part of it alone.
fn grouped(node: &ParseNode) -> Option<String> {
    let words = of_one(node)?.trim().to_owned();
    let is_whole = words.chars().count() <= 1 || words.chars().all(char::is_alphanumeric);
    Some(if is_whole { words } else { format!("({words})") })
}

fn delimiter(delimiter: &str) -> String {
    if delimiter == "." { String::new() } else { symbol(delimiter) }
}

/// The character of a command, or the command's name.
fn symbol(text: &str) -> String {
    match text {
        "-" => "−".to_owned(),
        "*" => "∗".to_owned(),
        "\\prime" => "′".to_owned(),
        "\\cdot" => "·".to_owned(),
        _ if !text.starts_with('\\') => text.to_owned(),
        _ => match get_symbol(text, Mode::Math).and_then(|symbol| symbol.codepoint) {
            Some(character) => character.to_string(),
            None => text.trim_start_matches('\\').to_owned(),
        },
    }
}
