"""Runs the examples of the gallery, and makes their pictures for docs/gallery.md.

`python crates/gamow-python/gallery/pictures.py [NAME...]`, as in `... pictures.py film`; without names all.
"""

import os
import pathlib
import runpy
import sys
import tempfile

import matplotlib
import matplotlib.pyplot as plt
from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
PICTURES = HERE.parents[2] / "docs" / "pictures" / "gallery"
EXAMPLES = sorted(path for path in HERE.glob("*.py") if path != pathlib.Path(__file__).resolve())
# Pictures with as many colours as a photograph.
RENDERED = {"film", "leaves_by_speed"}


def run(example):
    """Runs an example, which writes its picture into the current folder."""
    with matplotlib.rc_context():
        runpy.run_path(str(example), run_name="__main__")
    plt.close("all")


def main(names):
    matplotlib.use("Agg")
    PICTURES.mkdir(exist_ok=True)
    for example in EXAMPLES:
        if names and example.stem not in names:
            continue
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            run(example)
            picture = Image.open(f"{example.stem}.png").convert("RGB")
            if example.stem in RENDERED:
                file = PICTURES / f"{example.stem}.jpg"
                picture.save(file, quality=82, optimize=True)
            else:
                file = PICTURES / f"{example.stem}.png"
                picture.quantize(256, dither=Image.Dither.NONE).save(file, optimize=True)
            os.chdir(HERE)
        print(f"{file.name}: {file.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
