"""`python -m platoon_osm.cli`: the same as `platoon-osm`."""

import sys

from .command import main

sys.exit(main())
