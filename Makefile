# make run    set up what is missing and start Burnish on a bundled model
# make test   set up what is missing and run all checks and tests
# make bench  print the benchmarks as one table
# make monkey let a random user do ten thousand things in the window; make soak works an hour
# make models make the bundled models anew

BIN := .venv/bin
MODEL ?= sample:creature

.PHONY: run test check bench monkey soak models clean

run:
	@sh .ci/setup run
	@$(BIN)/burnish $(MODEL)

# A process that crashes ends the run: pytest-xdist waits for ever after a crash in the last test of
# a file. A test that hangs is ended with the stacks of its threads. Three processes on two cores: the
# windows' tests wait a quarter of their time.
test: check
	$(BIN)/pytest -n 3 --dist loadfile --no-loadscope-reorder --max-worker-restart=0 --timeout=300

check:
	@sh .ci/setup test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

# Open3D brings dash, whose plugin for pytest does not go with ours.
bench:
	@sh .ci/setup test
	$(BIN)/pytest tests/benchmarks -p no:dash --benchmark-only --benchmark-disable-gc --override-ini addopts=--import-mode=importlib

monkey:
	@sh .ci/setup test
	BURNISH_MONKEY_ACTIONS=$(or $(ACTIONS),10000) $(BIN)/pytest tests/gui/monkey/test_monkey.py

soak:
	@sh .ci/setup test
	BURNISH_SOAK_MINUTES=$(or $(MINUTES),60) $(BIN)/pytest tests/gui/monkey/test_soak.py

models:
	@sh .ci/setup run
	$(BIN)/python -m resources.models.generate

clean:
	rm -rf .venv out build .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis .benchmarks
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
