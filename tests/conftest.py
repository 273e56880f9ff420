"""How the property tests draw their examples.

`make test` draws the same ones each time, so that a change is judged by what it changed.
`make soak` draws new ones, round after round, and prints how to repeat a failure.
"""

import os

from hypothesis import settings

settings.register_profile("same", derandomize=True, deadline=None)
settings.register_profile("soak", print_blob=True, deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "same"))
