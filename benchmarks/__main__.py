"""Run all benchmarks: `python -m benchmarks`."""

from benchmarks import california, engines, reach, study

california.main()
reach.main()
study.main()
engines.main()
