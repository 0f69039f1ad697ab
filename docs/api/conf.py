"""The API reference, from the docstrings:  sphinx-build -n -W docs/api build/api"""
from sphinx.util.inspect import signature, stringify_signature

import kinlab

project = "kinlab"
version = release = kinlab.__version__
copyright = "the authors of kinlab"
extensions = ["sphinx.ext.autodoc", "numpydoc"]
html_theme = "alabaster"
html_theme_options = {"description": "The forward kinematics of robot arms, to see, to derive and "
                                     "to check.", "page_width": "1020px"}
html_show_sourcelink = False

autodoc_typehints = "none"  # the docstrings say more: shapes and units
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "inherited-members": True}
numpydoc_show_class_members = False


def setup(app):
    app.connect("autodoc-skip-member", somebody_elses)
    app.connect("autodoc-process-signature", as_called)


def somebody_elses(app, what, name, member, skip, options):
    """Leave out what a view has from ipywidgets and a tuple from Python: it is told there."""
    function = getattr(member, "fget", None) or getattr(member, "func", member)
    home = getattr(function, "__module__", None) or ""
    return skip or not home.startswith(kinlab.__name__)


def as_called(app, what, name, made, options, arguments, returned):
    """A widget is made by its own arguments, where ipywidgets would show any."""
    if what == "class" and arguments == "(*args, **kwargs)":
        own = signature(made.__init__, bound_method=True)
        return stringify_signature(own, show_annotation=False), returned
