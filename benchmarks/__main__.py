"""Run all benchmarks: `python -m benchmarks`."""

from platoon_osm_x import california, engines, reach, study

california.main()
reach.main()
study.main()
engines.main()
