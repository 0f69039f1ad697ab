"""Paths: joint values that go from one pose to another in a stated time."""
