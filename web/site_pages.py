"""Hooks of the documentation's site (`mkdocs.yml`). They add pages that stand elsewhere in the tree, the references
of the Python package and, once `cargo doc` has made it, of the crates; and they turn formulas into MathML, which
browsers draw by themselves."""

import glob
import html
import os
import posixpath
import re
import shutil

from latex2mathml.converter import convert
from mkdocs.structure.files import File

# Pages and pictures of the site by their places in the tree.
ELSEWHERE = {
    "assets/scenes/README.md": "scene-files.md",
    "assets/lessons/README.md": "lesson-files.md",
    "CHANGELOG.md": "changes.md",
    "CONTRIBUTING.md": "contributing.md",
    "assets/window.png": "pictures/window.png",
}
# The scripts of the gallery, which its page links to.
ELSEWHERE |= {path: f"gallery/{os.path.basename(path)}" for path in glob.glob("crates/gamow-python/gallery/*.py")}
PYTHON = "# Reference of the Python package\n\n::: gamow\n"

CRATES = {"relativity_core": "the numerics", "relativity_render": "the renderers"}
CRATES_DOC = "target/doc"
# Plain HTML, since the generator knows no such pages.
CRATES_PAGE = "# Reference of the crates\n\n" + "".join(
    f'- <a href="crates/{name}/index.html"><code>{name}</code></a>: {what}\n' for name, what in CRATES.items()
)

LINK = re.compile(r"\[([^\]]*)\]\(([^)\s#]*)(#[^)\s]*)?\)")
FORMULA = re.compile(r'<(span|div) class="arithmatex">\\[(\[](.*?)\\[)\]]</\1>', re.DOTALL)


def has_crates():
    return all(os.path.isdir(f"{CRATES_DOC}/{name}") for name in CRATES)


def on_config(config):
    if has_crates():
        reference = next(part["Reference"] for part in config.nav if "Reference" in part)
        reference.insert(reference.index("python-reference.md") + 1, "crates-reference.md")
    return config


def on_post_build(config):
    if has_crates():
        shutil.copytree(CRATES_DOC, f"{config.site_dir}/crates", dirs_exist_ok=True)


def on_files(files, config):
    for path, name in ELSEWHERE.items():
        files.append(File.generated(config, name, abs_src_path=os.path.abspath(path)))
    files.append(File.generated(config, "python-reference.md", content=PYTHON))
    if has_crates():
        files.append(File.generated(config, "crates-reference.md", content=CRATES_PAGE))
    return files


def on_page_markdown(markdown, page, config, files):
    """Leads links to pages of the site, and leaves only the words of those to other files of the tree."""
    place = {name: path for path, name in ELSEWHERE.items()}.get(page.file.src_uri)
    folder = posixpath.dirname(place or f"docs/{page.file.src_uri}")

    def led(link):
        words, target, anchor = link[1], link[2], link[3] or ""
        if not target or ":" in target:
            return link[0]
        path = posixpath.normpath(posixpath.join(folder, target))
        name = ELSEWHERE.get(path) or path.removeprefix("docs/")
        if files.get_file_from_path(name) is None and not path.startswith("docs/"):
            return words
        return f"[{words}]({name}{anchor})"

    return LINK.sub(led, markdown)


def on_page_content(content, page, config, files):
    def formula(found):
        display = "block" if found[1] == "div" else "inline"
        # The library knows names of operators in letters only.
        tex = re.sub(r"\\operatorname\{(\w*\d)\}", r"\\mathrm{\1}", html.unescape(found[2]))
        return convert(tex, display=display)

    return FORMULA.sub(formula, content)
