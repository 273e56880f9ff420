# Targets: demo (plan and draw the bundled corridor), test (lint, then tests), lint (style,
# docstrings, types, pages), kernels (compile the fast engine), bench (speed ratios), fleets
# (tables and curves of docs/fleets.md: hours, but what is measured stays), soak (property tests on
# ROUNDS x new random inputs, and tests that have more cases there), screenshots (pictures of
# the demo page), lock (renew the pinned dependencies), clean.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
ROUNDS ?= 10
# A browser for each worker; tests of a file stay together, for they share what is dear to make,
# and files run in the order of tests/conftest.py: long ones first, lest one is waited for at the end.
# One worker more than processors: tests in a browser wait for it, and others go on meanwhile.
WORKERS ?= $(shell echo $$(($$(getconf _NPROCESSORS_ONLN) + 1)))
STAMP := $(VENV)/.installed
DEV_STAMP := $(VENV)/.installed-dev

.PHONY: demo test lint kernels bench fleets soak screenshots lock clean

demo: $(STAMP)
	$(BIN)/platoon-osm demo -o out

# While one processor checks style, another compiles what every worker would compile for itself.
test: $(DEV_STAMP)
	$(MAKE) --no-print-directory -j 2 lint kernels
	$(BIN)/python -m pytest -n $(WORKERS) --maxprocesses 4 --dist loadfile --no-loadscope-reorder

lint: $(DEV_STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m numpydoc lint $$(find platoon_osm -name '*.py')
	$(BIN)/mypy
	$(BIN)/djlint --quiet --lint platoon_osm/report/assets
	$(BIN)/oxlint --deny-warnings platoon_osm/report/assets

kernels: $(STAMP)
	$(BIN)/platoon-osm warmup

bench: $(DEV_STAMP)
	$(BIN)/python -m benchmarks

fleets: $(DEV_STAMP)
	$(BIN)/python -m benchmarks.fleets
	$(BIN)/python -m benchmarks.fleets --curves

soak: $(DEV_STAMP)
	for round in $$(seq $(ROUNDS)); do \
	  HYPOTHESIS_PROFILE=soak $(BIN)/python -m pytest -m hypothesis || exit 1; \
	done
	HYPOTHESIS_PROFILE=soak $(BIN)/python -m pytest -m soak -n $(WORKERS) --maxprocesses 4 --dist loadfile

screenshots: $(DEV_STAMP)
	$(BIN)/platoon-osm demo -o out
	$(BIN)/python docs/screenshots.py out docs/images

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	  || { echo "Python 3.11 or later is needed; give one with make PYTHON=python3.11"; exit 2; }
	$(PYTHON) -m venv $(VENV)

$(STAMP): requirements.lock pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@touch $@

$(DEV_STAMP): requirements-dev.lock $(STAMP)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-dev.lock
	@touch $@

lock: $(DEV_STAMP)
	$(BIN)/uv pip compile --universal --python-version 3.11 --generate-hashes --no-annotate --no-header \
	  --extra build pyproject.toml -o requirements.lock
	$(BIN)/uv pip compile --universal --python-version 3.11 --generate-hashes --no-annotate --no-header \
	  --extra build --extra dev -c requirements.lock pyproject.toml -o requirements-dev.lock

clean:
	rm -rf $(VENV) out .mypy_cache .ruff_cache .pytest_cache .hypothesis build dist
