//! report.html: report.md as one page that holds its figures.

use anyhow::Context as _;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

const HEAD: &str = "\
<!DOCTYPE html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<title>Gamow's cyclist, reproduced</title>
<style>
body { font: 16px/1.5 sans-serif; color: #222; background: #fff; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; margin-top: 2em; }
table { border-collapse: collapse; font-size: 14px; }
th, td { border: 1px solid #ccc; padding: 0.2em 0.5em; text-align: left; vertical-align: top; }
th { background: #f2f2f2; }
figure { margin: 2em 0; }
figure > svg { max-width: 100%; height: auto; }
figcaption { color: #444; }
code { font-size: 12px; overflow-wrap: anywhere; }
</style>
</head>
<body>
";

/// The page of `markdown`, in which each picture is replaced by what `svg` gives for its file, as a figure with its
/// caption.
///
/// # Errors
///
/// Those of `svg`.
pub fn page(markdown: &str, svg: impl Fn(&str) -> anyhow::Result<String>) -> anyhow::Result<String> {
    let mut events = Vec::new();
    let mut parser = Parser::new_ext(markdown, Options::ENABLE_TABLES);
    while let Some(event) = parser.next() {
        let Event::Start(Tag::Image { dest_url, .. }) = event else {
            events.push(event);
            continue;
        };
        let caption = parser.by_ref().take_while(|event| *event != Event::End(TagEnd::Image));
        let mut shown = String::new();
        html::push_html(&mut shown, caption);
        let svg = svg(&dest_url).with_context(|| dest_url.to_string())?;
        let figure = format!("<figure>\n{svg}<figcaption>{shown}</figcaption>\n</figure>\n");
        events.push(Event::Html(CowStr::from(figure)));
    }
    let mut page = HEAD.to_owned();
    html::push_html(&mut page, without_paragraphs_around_figures(events).into_iter());
    page.push_str("</body>\n</html>\n");
    Ok(page)
}

/// A figure is no part of a paragraph: one that stands in a paragraph of its own stands without it.
fn without_paragraphs_around_figures(events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    let mut kept: Vec<Event<'_>> = Vec::new();
    let mut is_alone = false;
    for event in events {
        match (&event, kept.last()) {
            (Event::Html(_), Some(Event::Start(Tag::Paragraph))) => {
                kept.pop();
                is_alone = true;
                kept.push(event);
            }
            (Event::End(TagEnd::Paragraph), Some(Event::Html(_))) if is_alone => is_alone = false,
            _ => kept.push(event),
        }
    }
    kept
}

/// `bytes` of this kind as an address that holds them (RFC 2397).
pub fn data_uri(kind: &str, bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut uri = format!("data:{kind};base64,");
    for three in bytes.chunks(3) {
        let byte = |index: usize| u32::from(three.get(index).copied().unwrap_or_default());
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let value = bits >> (18 - 6 * digit) & 63;
            uri.push(if digit > three.len() { '=' } else { char::from(DIGITS[value as usize]) });
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of RFC 4648, section 10.
    #[test]
    fn bytes_are_written_as_in_the_standard() {
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(data_uri("text/plain", bytes.as_bytes()), format!("data:text/plain;base64,{text}"));
        }
    }

    #[test]
    fn pictures_become_figures_and_tables_stay_tables() {
        let markdown =
            "# A\n\n| a | b |\n|---|---|\n| 1 < 2 | `x` |\n\n![the *curve* of T](curve.svg)\n\nText.\n";
        let page = page(markdown, |file| Ok(format!("<svg>{file}</svg>\n"))).expect("there is a figure");
        let expected =
            "<figure>\n<svg>curve.svg</svg>\n<figcaption>the <em>curve</em> of T</figcaption>\n</figure>";
        assert!(page.contains(expected), "{page}");
        assert!(page.contains("<td>1 &lt; 2</td><td><code>x</code></td>") && page.contains("<p>Text.</p>"));
        assert!(!page.contains("<p><figure>") && !page.contains("</figure>\n</p>"));
        assert!(super::page(markdown, |_| anyhow::bail!("it is gone")).is_err());
    }
}
