"""The widgets: a scene with its controls, and a table to type in."""
from ..drawing import worker

worker.begin()  # it makes itself ready while the widgets' library loads here
