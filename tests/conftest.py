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
def course_site(request, tmp_path_factory):
    """The folder of the site: of all lessons for thorough tests, else of three."""
    from kinlab.course import handout, site
    whole = any(item.get_closest_marker("thorough") for item in request.session.items)
    folder = tmp_path_factory.mktemp("site") / "new" / "course"
    site.build(folder, None if whole else [handout.FOLDER / f"{name}.ipynb" for name in
                                           ("00_start_here", "01_translation", "07_alpha_ii")])
    return folder
