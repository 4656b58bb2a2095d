"""How Sphinx builds the manual: see `docs` in the Makefile."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent

project = "medax"
version = release = re.search(r'^version = "(.+)"', (ROOT / "Cargo.toml").read_text(), re.M)[1]
copyright = "the medax authors"

extensions = ["myst_parser"]
exclude_patterns = ["manual"]
# Anchors as GitHub makes them, so that a link to a section works in both places.
myst_heading_anchors = 4
# The pages are plain text with x, " and ... as they were typed.
smartquotes = False

html_theme = "furo"
html_static_path = ["manual/static"]
html_css_files = ["wide.css"]
html_title = f"medax {version}"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False
