"""The documentation: `make docs` builds it into build/docs, with warnings as errors and no network.

Equations become MathML (`generate/maths.py`): browsers set it by themselves, where MathJax would bring megabytes of
scripts, or a link to somebody's server. Where the reader's machine has no font for mathematics, STIX Two is there.
"""

import sys
from importlib.metadata import version as installed
from importlib.util import find_spec
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

project = "rovbrush"
author = "the rovbrush developers"
copyright = author
version = release = installed("rovbrush")

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx_design",
    "sphinx_copybutton",
    "myst_nb",
    "generate",
]
exclude_patterns = ["generate"]
templates_path: list[str] = []
nitpicky = False
highlight_language = "none"
smartquotes = False  # options begin with two dashes

myst_enable_extensions = ["amsmath", "attrs_block", "attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False
nb_execution_mode = "off"  # the tests run the notebooks
nb_merge_streams = True
suppress_warnings = ["mystnb.unknown_mime_type"]

autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"
default_role = "code"

html_theme = "pydata_sphinx_theme"
html_title = "rovbrush"
html_static_path = ["_static", str(Path(find_spec("ziamath").origin).parent / "fonts" / "STIXTwoMath-Regular.ttf")]
html_css_files = ["rovbrush.css"]
html_sidebars = {"index": [], "gallery/index": [], "tutorial/index": []}
html_math_renderer = "mathml"
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "logo": {"text": "rovbrush"},
    "navbar_align": "left",
    "header_links_before_dropdown": 7,
    "navigation_with_keys": False,
    "show_prev_next": True,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "pygments_light_style": "a11y-high-contrast-light",
    "pygments_dark_style": "a11y-high-contrast-dark",
}
copybutton_prompt_text = "$ "
