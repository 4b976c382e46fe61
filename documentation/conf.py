"""Settings of Sphinx: notes in Markdown, the Python package by its docstrings, nothing from elsewhere."""

import flockproof.plot
import matplotlib.axes

# Known there to type checkers only; with it every type of a signature is one that has a place.
flockproof.plot.Axes = matplotlib.axes.Axes

project = "flockproof"
author = "The flockproof developers"
html_title = "flockproof"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_theme = "furo"
html_theme_options = {"light_css_variables": {"font-stack": "sans-serif"}}
html_show_sphinx = False
html_copy_source = False
html_static_path = ["wrap.css"]
html_css_files = ["wrap.css"]
napoleon_use_ivar = True
myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
nitpicky = False
# Blocks show what a terminal prints.
highlight_language = "none"
