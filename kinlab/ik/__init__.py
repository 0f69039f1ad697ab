"""Joint values that bring the tool to a target."""
