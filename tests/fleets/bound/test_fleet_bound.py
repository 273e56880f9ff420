"""The bound on a fleet's costs against all plans, the linear program, and its own shares."""

import numpy as np
import pytest
from soak import draws
from tiny_fleets import (
    MODELS,
    all_schedules,
    cost_under,
    linear_bound,
    optimum,
    tiny_fleet,
    valid_by_trying,
)

from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.bound.bound import Bound

LARGEST = (0, 2, 3)


def never():
    return False
