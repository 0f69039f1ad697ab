"""The predictions of lessons that have many, a module each."""
