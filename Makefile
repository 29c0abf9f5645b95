# `make help` lists the targets. make creates .venv by itself.
# PROCESSES is the number of test processes: auto (one per core), a number, or 0 (no subprocess).
PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
TOOLS  := $(VENV)/.tools
SCALE  ?=
ARGS   ?=
PROCESSES ?= auto
FUZZ_SECONDS ?= 600
# Python compiles imported modules itself, unless it may not write bytecode; pip would compile all packages.
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check $(if $(PYTHONDONTWRITEBYTECODE),,--no-compile)
PYTEST := $(BIN)/python -m pytest -n $(PROCESSES)
USUAL  := not cluster and not exhaustive
# Numerical tests, whose rounding may differ on other processors. Tests of the cache of machine code do
# not depend on the processor.
NUMERICAL := tests/kernels $(addprefix --ignore=tests/kernels/,test_loading.py test_machine_code.py) \
  $(addprefix --ignore=tests/kernels/compile/test_,cache.py cache_files.py clock.py) \
  tests/independent tests/workflow/reduce \
  $(addprefix tests/hard/test_,corners.py shapes.py domain.py convergence.py scenes.py fits.py)
# The last column of each table in docs/reliability.md names the tests that repeat the trial.
TRIALS = $(shell grep -i '^|.*$(ARGS)' docs/reliability.md | grep -oE 'tests/[a-z_/]+/test_\w+\.py' | sort -u)
FUZZED := tests/workflow/study/test_fuzz.py tests/workflow/scene/test_random_calls.py
STUDIES = $(notdir $(patsubst %/,%,$(dir $(sort $(wildcard studies/*/study.toml)))))
.DEFAULT_GOAL := help
.PHONY: help setup study studies report test test-all test-exhaustive test-cluster test-nojit test-processors test-generic test-rounding test-oldest test-newest try-slurm chaos trials fuzz coverage check docs wheel bench mutation intervals clean

help: ## List the targets
	@grep -hE '^[a-z%-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 17

setup: $(TOOLS) ## Create .venv with the package and its development tools

$(READY): pyproject.toml # the package and its machine code, enough to run a study
	$(PYTHON) -m venv $(VENV)
	$(PIP) --editable .
	@echo "Compiling the numerical core, about half a minute, once."
	$(BIN)/python -c 'from elastomer_friction.kernels import Quantities, loading; loading.load("exponential", Quantities())'
	touch $@

$(TOOLS): $(READY)
	$(PIP) --editable '.[dev]'
	touch $@

study: $(READY) ## Run a study file and draw its figure: STUDY=my/study.toml [SCALE=...]
	$(BIN)/python -m workflow run $(STUDY) $(if $(SCALE),--scale $(SCALE)) $(ARGS)
	$(BIN)/python -m workflow figure $(STUDY) $(if $(SCALE),--scale $(SCALE)) $(ARGS)

study-%: $(READY) ## Run studies/% and draw its figure [SCALE=smoke|paper] [ARGS=...]
	$(MAKE) --no-print-directory study STUDY=$*

studies: $(READY) ## Run all studies one after the other, then the report [SCALE=...]
	for study in $(STUDIES); do $(MAKE) --no-print-directory study-$$study || exit; done
	$(MAKE) --no-print-directory report

report: $(READY) ## Write results/report.html from the existing results [SCALE=...]
	$(BIN)/python -m workflow report $(if $(SCALE),--scale $(SCALE))

test: $(TOOLS) ## Run the tests on all cores, except cluster and exhaustive tests
	$(PYTEST) -m "$(USUAL)"

test-all: $(TOOLS) ## Run the tests on all cores, including the exhaustive ones
	$(PYTEST) -m "not cluster" --hypothesis-profile exhaustive

test-exhaustive: $(TOOLS) ## Run only the exhaustive tests
	$(PYTEST) -m exhaustive

test-cluster: $(TOOLS) ## Run the tests that start clusters on this machine (SLURM if installed)
	$(PYTEST) -m cluster tests/cluster

test-nojit: $(TOOLS) ## Run the tests of the kernels as plain Python
	NUMBA_DISABLE_JIT=1 $(PYTEST) -m "$(USUAL)" tests/kernels --ignore=tests/kernels/half_space/test_friction_heat.py \
	  $(addprefix tests/hard/test_,corners.py shapes.py domain.py scenes.py)

test-processors: test-generic test-rounding ## Run the numerical tests as on other processors

test-generic: $(TOOLS) ## ... with baseline instructions only
	NUMBA_CPU_NAME=generic NUMBA_CPU_FEATURES= NPY_DISABLE_CPU_FEATURES="$$($(BIN)/python -c \
	  'import numpy; print(*numpy.show_config(mode="dicts")["SIMD Extensions"].get("found", []))')" \
	  $(PYTEST) -m "$(USUAL)" $(NUMERICAL) --ignore=tests/kernels/quick/blocks  # a third of the compilation

test-rounding: $(TOOLS) ## ... with the last bit of the lines changed
	LAST_BIT=1 $(PYTEST) -m "$(USUAL)" $(NUMERICAL)

install-%: ## Install the environment of test-oldest or test-newest
	$(PYTHON) -m tests.tools.environments $* install

test-oldest: $(TOOLS) ## Run a smoke study and numerical tests with the oldest supported packages
	$(BIN)/python -m tests.tools.environments oldest

test-newest: $(TOOLS) ## Do the same with the newest Python of this machine
	$(BIN)/python -m tests.tools.environments newest

try-slurm: $(TOOLS) ## Run a study in jobs of a private SLURM on this machine [ARGS="fig7 --scale smoke"]
	$(BIN)/python -m tests.cluster.slurm $(ARGS)

chaos: $(TOOLS) ## Kill processes of a run 50 times and compare the result [ARGS="--kills 100 --seed 2"]
	$(BIN)/python -m tests.tools.chaos $(ARGS)

trials: $(TOOLS) ## Repeat the trials of docs/reliability.md, or the rows that contain a word [ARGS="disk"]
	$(BIN)/python -m pytest -m "not exhaustive" $(or $(TRIALS),$(error no row with a test contains "$(ARGS)"))

fuzz: $(TOOLS) ## Fuzz the study reader and scene.run [FUZZ_SECONDS=600]
	end=$$(($$(date +%s) + $(FUZZ_SECONDS))); while [ $$(date +%s) -lt $$end ]; do \
	  $(BIN)/python -m pytest -q --hypothesis-profile exhaustive --hypothesis-show-statistics $(FUZZED) || exit; done

coverage: $(TOOLS) ## Measure the coverage of make test, including kernels and workers
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

docs: $(READY) ## Build the documentation as a searchable site: site/index.html
	$(PIP) --editable '.[docs]'
	$(BIN)/python -m elastomer_friction.workflow.reference
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet

wheel: $(TOOLS) ## Build dist/*.whl with machine code for x86-64-v3, so that nothing is compiled there
	$(BIN)/python -m tests.tools.wheel

bench: $(TOOLS) ## Print ratios of CPU times: to C, to tamaas, and by effect (accuracy: make study-accuracy)
	$(BIN)/python -m tests.tools.bench

mutation: $(TOOLS) ## Change code and count the changes that no test detects [ARGS="workflow/store --count 100 --seed 12"]
	$(BIN)/python -m tests.tools.mutation $(or $(ARGS),workflow/store)

intervals: $(TOOLS) ## Check the coverage of stated errors over many small studies (minutes)
	$(BIN)/python -m tests.tools.intervals
	$(BIN)/python -m tests.tools.map_intervals

clean: ## Remove .venv and caches, keep results
	rm -rf $(VENV) $(VENV)-* .pytest_cache .ruff_cache .mypy_cache .hypothesis .import_linter_cache src/*.egg-info
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
