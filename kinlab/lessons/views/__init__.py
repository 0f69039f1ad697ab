"""Views that a lesson has of its own, a module each."""
