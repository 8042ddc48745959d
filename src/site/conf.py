"""How Sphinx makes the site of the pages that gathered_pages.py gathers. README.md here says why Sphinx.

Guarantees: pages load nothing but files beside them; templates/base.html has the policy that says so to browsers.
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "extensions")]

project = "Flowcert"
release = re.search(r"project\(flowcert VERSION ([\d.]+)", (HERE.parents[1] / "CMakeLists.txt").read_text()).group(1)
extensions = ["myst_parser", "sphinx.ext.autodoc", "clauses", "plain_docstrings"]
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]
# Formulas are plain text, here and in the pages.
myst_dmath_allow_labels = False
suppress_warnings = ["myst.header"]
highlight_language = "none"

autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
add_module_names = False

html_theme = "furo"
html_title = f"Flowcert {release}"
templates_path = [str(HERE / "templates")]
html_static_path = [str(HERE / "static")]
html_css_files = ["site.css"]
html_js_files = ["keyboard.js"]
html_copy_source = False
html_show_copyright = False
html_domain_indices = False
# Its excerpts are fetched, and browsers refuse that from disk.
html_show_search_summary = False
