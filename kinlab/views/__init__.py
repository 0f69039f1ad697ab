"""The widgets: a scene with its controls, and a table to type in."""
