# Everything a user needs: `make help`. make creates .venv by itself.
# Tests run in as many PROCESSES as there are cores, or as many as are given; 0: in that of pytest alone.
PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
TOOLS  := $(VENV)/.tools
SCALE  ?=
ARGS   ?=
PROCESSES ?= auto
FUZZ_SECONDS ?= 600
# pip need not make bytecode of all packages: of what is imported Python does, where it may write it.
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check $(if $(PYTHONDONTWRITEBYTECODE),,--no-compile)
PYTEST := $(BIN)/python -m pytest -n $(PROCESSES)
USUAL  := not cluster and not exhaustive
# Tests of numbers, which other processors may round otherwise. Which machine code is made, kept and
# found is the same on all.
NUMERICAL := tests/kernels $(addprefix --ignore=tests/kernels/,test_loading.py test_machine_code.py) \
  $(addprefix --ignore=tests/kernels/compile/test_,cache.py cache_files.py clock.py) \
  tests/independent tests/workflow/reduce \
  $(addprefix tests/hard/test_,corners.py shapes.py domain.py convergence.py scenes.py fits.py units.py)
# The last column of the tables of a page names the tests that repeat what a row tells.
TRIALS = $(shell grep -i '^|.*$(ARGS)' docs/reliability.md | grep -oE 'tests/[a-z_/]+/test_\w+\.py' | sort -u)
FUZZED := tests/workflow/study/test_fuzz.py tests/workflow/scene/test_random_calls.py
STUDIES = $(notdir $(patsubst %/,%,$(dir $(sort $(wildcard studies/*/study.toml)))))
.DEFAULT_GOAL := help
.PHONY: help setup study studies report test test-all test-exhaustive test-cluster test-nojit test-processors test-generic test-rounding test-oldest test-newest try-slurm chaos trials fuzz coverage check docs wheel bench mutation intervals clean

help: ## List the targets
	@grep -hE '^[a-z%-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 17

setup: $(TOOLS) ## Create .venv with the package and its development tools

$(READY): pyproject.toml # the package alone, and its machine code: what a study needs
	$(PYTHON) -m venv $(VENV)
	$(PIP) --editable .
	@echo "Compiling the numerical core, about half a minute, once."
	$(BIN)/python -c 'from elastomer_friction.kernels import Quantities, loading; loading.load("exponential", Quantities())'
	touch $@

$(TOOLS): $(READY)
	$(PIP) --editable '.[dev]'
	touch $@

study: $(READY) ## Run a study that lies anywhere, and draw its figure: STUDY=my/study.toml [SCALE=...]
	$(BIN)/python -m workflow run $(STUDY) $(if $(SCALE),--scale $(SCALE)) $(ARGS)
	$(BIN)/python -m workflow figure $(STUDY) $(if $(SCALE),--scale $(SCALE)) $(ARGS)

study-%: $(READY) ## Run studies/% and draw its figure [SCALE=smoke|paper] [ARGS=...]
	$(MAKE) --no-print-directory study STUDY=$*

studies: $(READY) ## Run all studies one after the other, then the report [SCALE=...]
	for study in $(STUDIES); do $(MAKE) --no-print-directory study-$$study || exit; done
	$(MAKE) --no-print-directory report

report: $(READY) ## Write results/report.html from the results that are there [SCALE=...]
	$(BIN)/python -m workflow report $(if $(SCALE),--scale $(SCALE))

test: $(TOOLS) ## Run the tests on all cores: all but those with clusters and the exhaustive ones
	$(PYTEST) -m "$(USUAL)"

test-all: $(TOOLS) ## Run the tests on all cores, the exhaustive ones as well
	$(PYTEST) -m "not cluster" --hypothesis-profile exhaustive

test-exhaustive: $(TOOLS) ## Run the exhaustive tests alone
	$(PYTEST) -m exhaustive

test-cluster: $(TOOLS) ## Run the tests with real clusters on this machine (SLURM if it is installed)
	$(PYTEST) -m cluster tests/cluster

test-nojit: $(TOOLS) ## Run the tests of the kernels as plain Python
	NUMBA_DISABLE_JIT=1 $(PYTEST) -m "$(USUAL)" tests/kernels $(addprefix tests/hard/test_,corners.py shapes.py domain.py scenes.py)

test-processors: test-generic test-rounding ## Run the numerical tests as other processors do

test-generic: $(TOOLS) ## ... with none but the plainest instructions
	NUMBA_CPU_NAME=generic NUMBA_CPU_FEATURES= NPY_DISABLE_CPU_FEATURES="$$($(BIN)/python -c \
	  'import numpy; print(*numpy.show_config(mode="dicts")["SIMD Extensions"].get("found", []))')" \
	  $(PYTEST) -m "$(USUAL)" $(NUMERICAL)

test-rounding: $(TOOLS) ## ... with lines that are rounded otherwise
	LAST_BIT=1 $(PYTEST) -m "$(USUAL)" $(NUMERICAL)

install-%: ## Install what test-oldest or test-newest needs, and no more
	$(PYTHON) -m tests.tools.environments $* install

test-oldest: $(TOOLS) ## Try the oldest supported packages: a smoke study and numerical tests
	$(BIN)/python -m tests.tools.environments oldest

test-newest: $(TOOLS) ## Try the newest Python of this machine, likewise
	$(BIN)/python -m tests.tools.environments newest

try-slurm: $(TOOLS) ## Run a study in jobs of a private SLURM on this machine [ARGS="fig7 --scale smoke"]
	$(BIN)/python -m tests.cluster.slurm $(ARGS)

chaos: $(TOOLS) ## Kill what computes a study 50 times, compare the result [ARGS="--kills 100 --seed 2"]
	$(BIN)/python -m tests.tools.chaos $(ARGS)

trials: $(TOOLS) ## Try again all that docs/reliability.md tells, or the rows that hold a word [ARGS="disk"]
	$(BIN)/python -m pytest -m "not exhaustive" $(or $(TRIALS),$(error no row with a test says "$(ARGS)"))

fuzz: $(TOOLS) ## Fuzz the reader of studies and calls of scene.run [FUZZ_SECONDS=600]
	end=$$(($$(date +%s) + $(FUZZ_SECONDS))); while [ $$(date +%s) -lt $$end ]; do \
	  $(BIN)/python -m pytest -q --hypothesis-profile exhaustive --hypothesis-show-statistics $(FUZZED) || exit; done

coverage: $(TOOLS) ## Measure which lines make test runs: kernels as plain Python, workers too
	$(BIN)/coverage erase
	NUMBA_DISABLE_JIT=1 $(BIN)/coverage run -m pytest -q -m "$(USUAL)" tests/kernels
	$(BIN)/coverage run -m pytest -q -n auto -m "$(USUAL)"
	$(BIN)/coverage combine --quiet
	$(BIN)/coverage report

check: $(TOOLS) ## Lint, formatting, types, the import contracts and wording
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python -m tests.tools.language

docs: $(READY) ## Build the documentation as a site with a search: site/index.html
	$(PIP) --editable '.[docs]'
	$(BIN)/python -m elastomer_friction.workflow.reference
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet

wheel: $(TOOLS) ## Build dist/*.whl, with machine code for x86-64-v3: where it fits none is compiled
	$(BIN)/python -m tests.tools.wheel

bench: $(TOOLS) ## Print ratios of CPU times: beside C and tamaas, and by effect (accuracy: make study-accuracy)
	$(BIN)/python -m tests.tools.bench

mutation: $(TOOLS) ## Change code, see whether tests notice [ARGS="workflow/store --count 100 --seed 12"]
	$(BIN)/python -m tests.tools.mutation $(or $(ARGS),workflow/store)

intervals: $(TOOLS) ## Check that stated errors are true, over many small studies (minutes)
	$(BIN)/python -m tests.tools.intervals
	$(BIN)/python -m tests.tools.map_intervals

clean: ## Remove .venv and caches, keep results
	rm -rf $(VENV) $(VENV)-* .pytest_cache .ruff_cache .mypy_cache .hypothesis .import_linter_cache src/*.egg-info
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
