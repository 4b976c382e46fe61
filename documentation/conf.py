"""Settings of Sphinx: notes in Markdown, the Python package by its docstrings, nothing from elsewhere."""

import re

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
# By their names; the page says what they are.
autodoc_type_aliases = {name: name for name in ("Number", "Numbers")}
nitpicky = False
# Blocks show what a terminal prints.
highlight_language = "none"


def named(app, what, name, thing, options, signature, result):
    """Sphinx writes names within unions as what it keeps them in."""
    return tuple(text and re.sub(r"TypeAliasForwardRef\('(\w+)'\)", r"\1", text) for text in (signature, result))


def setup(app):
    app.connect("autodoc-process-signature", named)
