from hypothesis import settings

# The same examples on every run; `--hypothesis-profile=explore` looks for new ones.
settings.register_profile("steady", max_examples=60, deadline=None, derandomize=True)
settings.register_profile("explore", max_examples=1000, deadline=None)
settings.load_profile("steady")
