# make run   own virtual environment, install, build the FMUs, nominal run, results/ and the Table 3 comparison
# make test  the same environment with what the tests need, then all tests and checks
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
	$(BIN)/mypy components orchestrator
	$(BIN)/python -m pytest -n logical --dist worksteal

evidence: $(VENV)/test.stamp
	$(BIN)/python -m tests.evidence

$(VENV)/run.stamp: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
	touch $@

$(VENV)/test.stamp: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[test]"
	touch $@

clean:
	rm -rf $(VENV) results fmus/*.fmu build *.egg-info

.PHONY: run test evidence clean
