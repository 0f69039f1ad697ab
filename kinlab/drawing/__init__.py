"""What a picture holds, as data, and matplotlib's hand that draws it once."""
import logging
import sys

if sys.platform == "emscripten":  # every session there begins without matplotlib's list of fonts
    logging.getLogger("matplotlib.font_manager").addFilter(
        lambda record: "font cache" not in record.msg)
