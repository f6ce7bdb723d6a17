# make run   own virtual environment, install, build the FMUs, nominal run, results/ and the Table 3 comparison
# make test  the same environment with what the tests need, then all tests and checks
# make docs  the documentation, into build/docs; needs no network
# make pictures  those of its gallery and of the README, by the commands that they show
# make lowest  the lowest versions that pyproject.toml allows, in an environment of their own, with the tests that touch libraries most
# make wheel  the native FMUs, then wheel and source distribution, into dist/; nothing of it is left elsewhere
# make release  those, and a zip with all FMUs and what their receivers need
# make first-run  how long a stranger takes from `pip install` of that wheel to Table 3, in an environment of its own
# make evidence  claims of many thousand cases (tests/evidence/README.md); goes on where it was stopped
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

run: $(VENV)/run.stamp
	$(BIN)/rovbrush build
	$(BIN)/rovbrush run nominal --out results --check

test: $(VENV)/test.stamp
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	@$(MAKE) --no-print-directory -j 2 types tests

types: $(VENV)/test.stamp
	$(BIN)/mypy components orchestrator docs/generate

tests: $(VENV)/test.stamp
	$(BIN)/python -m pytest -n logical --dist worksteal

docs: $(VENV)/test.stamp
	$(BIN)/python -m sphinx -b html -W --keep-going -q docs build/docs
	@echo "build/docs/index.html"

pictures: $(VENV)/test.stamp
	$(BIN)/python docs/gallery/make.py

evidence: $(VENV)/test.stamp
	$(BIN)/python -m tests.evidence

wheel: $(VENV)/test.stamp
	$(BIN)/python -m release.wheel

release: wheel
	$(BIN)/python -m release.fmus

first-run: $(VENV)/test.stamp
	test -n "$(wildcard dist/*.whl)" || $(MAKE) --no-print-directory wheel
	$(BIN)/python -m release.first_run

lowest:
	$(PYTHON) -m release.environment .lowest test lowest-direct
	.lowest/bin/python -m pytest -n logical --dist worksteal -o cache_dir=.lowest/cache tests/packaging tests/system/test_nominal.py \
	  tests/fmus tests/components/dc_motor tests/components/test_kernels_have_three_lives.py $(addprefix tests/orchestrator/, \
	  test_api.py test_units.py cli/test_command_line.py exchange fmu paper participant results system studies/test_convergence.py \
	  studies/sweep/test_sweep_dask.py)

$(VENV)/run.stamp: pyproject.toml
	$(PYTHON) -m release.environment $(VENV) compile
	touch $@

$(VENV)/test.stamp: pyproject.toml
	$(PYTHON) -m release.environment $(VENV) test
	touch $@

clean:
	rm -rf $(VENV) .lowest results fmus/*.fmu build dist *.egg-info

.PHONY: run test types tests docs pictures lowest evidence wheel release first-run clean
