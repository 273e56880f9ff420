"""Run all benchmarks: `python -m benchmarks`."""

from . import california

california.main()
