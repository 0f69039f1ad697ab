"""The notebooks run, and the sites built from them."""
