"""Run all benchmarks: `python -m benchmarks`."""

from . import california, engines, study

california.main()
study.main()
engines.main()
