#!/bin/sh
# Makes the paper's first figure, from the root of the tree: PATH=target/release:$PATH sh paper/figures.sh
# The second is one of the documentation's, which docs/pictures/remake makes.
set -e

gamow render --state street --time 2 --size 480x300 --renderer reference --out paper/pair.png
