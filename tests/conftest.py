import pytest
from hypothesis import settings

from kinlab import exercises

# The same examples on every run; `--hypothesis-profile=explore` looks for new ones.
settings.register_profile("steady", max_examples=60, deadline=None, derandomize=True)
settings.register_profile("explore", max_examples=1000, deadline=None)
settings.load_profile("steady")

# What a check says does not depend on how busy the machine is that runs the tests.
exercises.SECONDS = 60.0


@pytest.fixture(scope="session")
def course_site(tmp_path_factory):
    """The folder of the whole site, built once for all tests; it takes about half a minute."""
    from kinlab.course import site
    folder = tmp_path_factory.mktemp("site") / "new" / "course"
    site.build(folder)
    return folder
