//! Pages of Markdown that hold all that they show: pictures, formulas and style.

use anyhow::Context as _;
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use pulldown_cmark::{CowStr, Event, Tag, TagEnd, html};

use crate::formula::markdown::Markdown;
use crate::formula::{self, Formula};
pub use crate::markup::escaped;

/// The style of a page, by its use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PageStyle {
    /// To be read on a screen.
    Screen,
    /// To be printed on A4 or Letter, and written on.
    Print,
}

impl PageStyle {
    const fn css(self) -> &'static str {
        match self {
            Self::Screen => {
                "\
body { font: 16px/1.5 sans-serif; color: #222; background: #fff; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; margin-top: 2em; }
table { border-collapse: collapse; font-size: 14px; }
th, td { border: 1px solid #ccc; padding: 0.2em 0.5em; text-align: left; vertical-align: top; }
th { background: #f2f2f2; }
figure { margin: 2em 0; }
figure > svg { max-width: 100%; height: auto; }
figcaption { color: #444; }
code { font-size: 12px; overflow-wrap: anywhere; }
"
            }
            Self::Print => {
                "\
@page { margin: 15mm; }
body { font: 11pt/1.45 serif; color: #000; background: #fff; max-width: 180mm; margin: 0 auto; padding: 1rem; }
@media print { body { padding: 0; } }
h1, h2, h3 { line-height: 1.2; margin: 1.2em 0 0.5em; break-after: avoid; }
h1 { font-size: 17pt; margin-top: 0; }
h2 { font-size: 13pt; }
h3 { font-size: 11pt; }
p, li { orphans: 2; widows: 2; }
table { border-collapse: collapse; break-inside: avoid; }
th, td { border: 0.5pt solid #000; padding: 0.25em 0.6em; text-align: left; vertical-align: top; }
figure, .figure, .question { margin: 1em 0; break-inside: avoid; }
figure > svg, figure > img, .figure > svg, .figure > img { display: block; max-width: 100%; max-height: 110mm; height: auto; }
figcaption { font-size: 9.5pt; }
a { color: inherit; }
code { font-size: 9.5pt; overflow-wrap: anywhere; }
.answer-lines { break-inside: avoid; margin: 0.3em 0 1em; }
.answer-lines > div { height: 8.5mm; border-bottom: 0.5pt solid #888; }
.sheet { font-size: 10pt; line-height: 1.3; }
.sheet h2 { clear: both; margin: 0.7em 0 0.2em; }
.sheet h3 { float: left; margin: 0 0.7em 0 0; line-height: inherit; font-size: inherit; }
.sheet p { margin: 0.3em 0; }
.sheet .question { margin: 0.3em 0; }
.sheet .question h3 + p { margin-top: 0; }
.sheet .opening { overflow: hidden; }
.sheet .closing { break-before: avoid; }
.sheet .choices { columns: 2; }
.sheet .choices p { margin: 0 0 0.15em; break-inside: avoid; }
.sheet .answer-lines { margin: 0 0 0.4em; }
.sheet .answer-lines > div { height: 7.5mm; }
.sheet .name { float: right; }
.sheet figure.beside { float: right; width: 70mm; margin: 0 0 2mm 4mm; }
.sheet figure.plot > svg { max-height: 55mm; }
.class .next { break-before: page; margin-top: 2em; }
.class h3 { float: none; }
.class .question { margin: 0.6em 0; }
.class figure.plot > svg { max-height: 75mm; }
.class .key { font-size: 9pt; color: #444; }
.class table.distribution { width: 100%; }
.class .distribution td { border: none; padding: 0.1em 0.4em; vertical-align: middle; }
.class .distribution td:nth-child(2) { width: 100%; }
.class .distribution p { margin: 0; }
.class .distribution svg { display: block; }
.class .count { text-align: right; }
.class table.pupils { break-inside: auto; }
.class .pupils tr { break-inside: avoid; }
.class .pupils td + td, .class .pupils th + th { text-align: center; }
.class .pupils td, .class .pupils th { padding: 0.1em 0.6em; }
"
            }
        }
    }
}

/// Style sheet of formulas on any page.
const FORMULAS: &str = "\
.formula { max-width: 100%; overflow: visible; }
.displayed { display: block; margin: 0.8em 0; text-align: centre; break-inside: avoid; }
";

/// A page that is being written.
#[derive(Debug, Clone)]
pub struct HtmlPage {
    text: String,
}

impl HtmlPage {
    /// An empty page with this title, which the window of a browser shows.
    #[must_use]
    pub fn new(title: &str, style: PageStyle) -> Self {
        let (title, css) = (escaped(title), style.css());
        let text = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n\
             <style>\n{css}{FORMULAS}</style>\n</head>\n<body>\n"
        );
        Self { text }
    }

    /// Adds Markdown, in which each picture is replaced by what `picture` gives for its file, as a figure
    /// with its caption. Formulas are drawn; HTML is shown as the text that it is, and so is a link to
    /// anything but the web, mail or a place in the page.
    ///
    /// # Errors
    ///
    /// Those of `picture`, and a formula that cannot be drawn.
    pub fn markdown(
        &mut self,
        text: &Markdown,
        picture: impl Fn(&str) -> anyhow::Result<String>,
    ) -> anyhow::Result<()> {
        self.add(events(text), picture)
    }

    /// Adds Markdown that holds no pictures.
    ///
    /// # Errors
    ///
    /// A picture, and a formula that cannot be drawn.
    pub fn text(&mut self, text: &Markdown) -> anyhow::Result<()> {
        self.add(events(text), no_picture)
    }

    /// Adds Markdown that holds no pictures; its first paragraph begins with `lead`, which is Markdown of one
    /// paragraph.
    ///
    /// # Errors
    ///
    /// As [`Self::text`].
    pub fn text_behind(&mut self, lead: &str, text: &Markdown) -> anyhow::Result<()> {
        let mut lead: Vec<_> = events(&Markdown::new(lead)).collect();
        let end = lead.pop();
        let mut rest = events(text).peekable();
        if rest.next_if_eq(&Event::Start(Tag::Paragraph)).is_some() {
            lead.push(Event::Text(CowStr::from(" ")));
        } else {
            lead.extend(end);
        }
        self.add(lead.into_iter().chain(rest), no_picture)
    }

    /// Adds a list of Markdown that holds no pictures.
    ///
    /// # Errors
    ///
    /// As [`Self::text`].
    pub fn list<'a>(&mut self, items: impl IntoIterator<Item = &'a Markdown>) -> anyhow::Result<()> {
        let is_paragraph =
            |event: &Event<'_>| matches!(event, Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph));
        self.html("<ul>\n");
        for item in items {
            self.html("<li>");
            // A single paragraph is no paragraph of its own.
            let is_loose = events(item).filter(is_paragraph).count() > 2;
            self.add(events(item).filter(|event| is_loose || !is_paragraph(event)), no_picture)?;
            self.html("</li>\n");
        }
        self.html("</ul>\n");
        Ok(())
    }

    fn add<'a>(
        &mut self,
        mut told: impl Iterator<Item = Event<'a>>,
        picture: impl Fn(&str) -> anyhow::Result<String>,
    ) -> anyhow::Result<()> {
        let mut events = Vec::new();
        while let Some(event) = told.next() {
            let Event::Start(Tag::Image { dest_url, .. }) = event else {
                events.push(drawn(event)?);
                continue;
            };
            let caption: Result<Vec<_>, _> =
                told.by_ref().take_while(|event| *event != Event::End(TagEnd::Image)).map(drawn).collect();
            let mut shown = String::new();
            html::push_html(&mut shown, caption?.into_iter());
            let picture = picture(&dest_url).with_context(|| dest_url.to_string())?;
            let figure = format!("<figure>\n{picture}<figcaption>{shown}</figcaption>\n</figure>\n");
            events.push(Event::Html(CowStr::from(figure)));
        }
        html::push_html(&mut self.text, without_paragraphs_around_figures(events).into_iter());
        Ok(())
    }

    /// Adds HTML as it is.
    pub fn html(&mut self, html: &str) {
        self.text.push_str(html);
    }

    /// Returns the whole page.
    #[must_use]
    pub fn finish(mut self) -> String {
        self.text.push_str("</body>\n</html>\n");
        self.text
    }
}

/// Returns the Markdown events of `text`, without their places in it.
fn events(text: &Markdown) -> impl Iterator<Item = Event<'static>> {
    text.events().iter().map(|(event, _)| event.clone())
}

fn no_picture(file: &str) -> anyhow::Result<String> {
    anyhow::bail!("{file}: there are no pictures here")
}

/// `event` with its formula drawn; HTML as text.
fn drawn(event: Event<'_>) -> anyhow::Result<Event<'_>> {
    Ok(match event {
        Event::InlineMath(tex) => {
            Event::InlineHtml(CowStr::from(Formula::new(&tex, formula::Style::Inline)?.svg()))
        }
        Event::DisplayMath(tex) => {
            let svg = Formula::new(&tex, formula::Style::Displayed)?.svg();
            Event::InlineHtml(CowStr::from(format!("<span class=\"displayed\">{svg}</span>")))
        }
        Event::Html(html) | Event::InlineHtml(html) => Event::Text(html),
        event => event,
    })
}

/// Room for an answer: this many ruled lines.
#[must_use]
pub fn answer_lines(count: usize) -> String {
    format!("<div class=\"answer-lines\">{}</div>\n", "<div></div>".repeat(count))
}

/// Takes figures out of paragraphs: one in a paragraph of its own is left without it.
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
#[must_use]
pub fn data_uri(kind: &str, bytes: &[u8]) -> String {
    format!("data:{kind};base64,{}", BASE64_STANDARD.encode(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(markdown: &str) -> anyhow::Result<String> {
        let mut page = HtmlPage::new("A & B", PageStyle::Print);
        page.markdown(&Markdown::new(markdown), |file| Ok(format!("<svg>{file}</svg>\n")))?;
        page.html(&answer_lines(2));
        Ok(page.finish())
    }

    #[test]
    fn pictures_become_figures_and_tables_stay_tables() {
        let markdown =
            "# A\n\n| a | b |\n|---|---|\n| 1 < 2 | `x` |\n\n![the *curve* of T](curve.svg)\n\nText.\n";
        let page = page(markdown).expect("there is a figure");
        let expected =
            "<figure>\n<svg>curve.svg</svg>\n<figcaption>the <em>curve</em> of T</figcaption>\n</figure>";
        assert!(page.contains(expected), "{page}");
        assert!(page.contains("<td>1 &lt; 2</td><td><code>x</code></td>") && page.contains("<p>Text.</p>"));
        assert!(!page.contains("<p><figure>") && !page.contains("</figure>\n</p>"));
        let gone = HtmlPage::new("A", PageStyle::Screen)
            .markdown(&Markdown::new(markdown), |_| anyhow::bail!("it is gone"));
        assert!(gone.is_err());
    }

    #[test]
    fn words_stand_before_a_text_and_lists_hold_texts() {
        let [text, rule, two] = ["a $x$\n\nb", "- c", "d\n\ne"].map(Markdown::new);
        let mut page = HtmlPage::new("A", PageStyle::Print);
        page.text_behind("**Why.**", &text).expect("it is Markdown");
        page.text_behind("**Why.**", &rule).expect("it is Markdown");
        page.list([&Markdown::new("*f*"), &two]).expect("it is Markdown");
        let page = page.finish();
        for part in [
            "<p><strong>Why.</strong> a <svg",
            "</svg></p>\n<p>b</p>\n<p><strong>Why.</strong></p>\n<ul>\n<li>c</li>\n</ul>\n",
            "<ul>\n<li><em>f</em></li>\n<li><p>d</p>\n<p>e</p>\n</li>\n</ul>\n",
        ] {
            assert!(page.contains(part), "{part}: {page}");
        }
    }

    #[test]
    fn formulas_are_drawn_and_named() {
        let page = page("At $x<1$ it is\n\n$$\\frac{1}{2}$$\n\n![at $T$](a.svg)\n").expect("they are TeX");
        assert!(page.contains("<p>At <svg class=\"formula\" role=\"img\" aria-label=\"x &lt; 1\""), "{page}");
        assert!(page.contains("<p><span class=\"displayed\"><svg class=\"formula\""), "{page}");
        assert!(
            page.contains("<figcaption>at <svg class=\"formula\" role=\"img\" aria-label=\"T\""),
            "{page}"
        );
        let error = super::tests::page("$\\gama$").expect_err("it is no TeX");
        assert!(error.to_string().contains("gama"), "{error}");
    }

    #[test]
    fn what_a_text_links_to_is_the_web_mail_or_the_page() {
        let hostile = "[a](javascript:alert(1)) [b](data:text/html;base64,PHNjcmlwdD4=) [c](file:///etc/passwd) \
            <javascript:alert(2)> [d](JAVASCRIPT&colon;alert(3)) [e](java&#10;script:alert(4)) [f](vbscript:x) [g](x.html) \
            [h][i] **[j](javascript:1 \"a\")**\n\n[i]: javascript:alert(5)\n\n| a |\n|---|\n| [k](ftp://x) |\n";
        let page = page(hostile).expect("it is Markdown");
        assert!(
            !page.contains("<a") && !page.contains("href") && page.contains("<strong>j</strong>"),
            "{page}"
        );
        assert!(page.contains("<p>a b c javascript:alert(2) d e f g"), "{page}");
        let kind = "[a](https://a.org/?b=\"c\") <http://b.org> <me@c.org> [d](#e) [f](mailto:g@h.org)";
        let page = super::tests::page(kind).expect("it is Markdown");
        let links: Vec<_> =
            page.split("<a href=\"").skip(1).filter_map(|link| link.split('"').next()).collect();
        let expected =
            ["https://a.org/?b=%22c%22", "http://b.org", "mailto:me@c.org", "#e", "mailto:g@h.org"];
        assert_eq!(links, expected);
        assert_eq!(page.matches("</a>").count(), 5);
    }

    #[test]
    fn what_is_nested_without_end_is_a_page() {
        for begin in [">", "- ", "1. ", "> * ", "*a **b ", "[", "![", "<b>", "`", "| "] {
            let markdown = begin.repeat(20_000) + "x";
            let page = page(&markdown).expect("it is Markdown");
            assert!(page.matches("<blockquote>").count() + page.matches("<ul>").count() <= 16, "{begin}");
            assert_eq!(page.matches("<li>").count(), page.matches("</li>").count(), "{begin}");
        }
    }

    /// Every element is closed by its own end, and nothing is loaded from elsewhere.
    #[test]
    fn pages_are_well_formed_and_hold_all_they_show() {
        let markdown = "# A\n\n- one $x$\n- <img src=\"http://example.org/a.png\">\n\n$$\\sqrt{2}$$\n\n[a](http://b.org)\n";
        let page = page(markdown).expect("it is Markdown");
        assert!(page.contains("<title>A &amp; B</title>") && !page.contains("<img"), "{page}");
        let mut open = Vec::new();
        for part in page.split('<').skip(1) {
            let (tag, _) = part.split_once('>').expect("a tag ends");
            let name = tag.split([' ', '/']).find(|part| !part.is_empty()).expect("it has a name");
            if tag.starts_with('/') {
                assert_eq!(open.pop(), Some(name), "{page}");
            } else if !(tag.ends_with('/') || ["!DOCTYPE", "meta"].contains(&name)) {
                open.push(name);
            }
            let is_loaded =
                (tag.contains("src=") || tag.contains("url(")) || tag.contains("href=") && name != "a";
            assert!(!is_loaded, "{tag}");
        }
        assert!(open.is_empty(), "{open:?}");
        assert_eq!(page.matches("<div></div>").count(), 2);
    }
}
