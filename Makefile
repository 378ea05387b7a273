# Crawford's commands. Everything they make lies in build/ and out/.

FIDELITY ?= paper
OUT ?= out
JOBS ?= $(shell nproc)

# Debian 12. OpenBLAS makes the Cholesky factorisation three times as fast as the reference BLAS does.
PACKAGES := build-essential cmake ninja-build \
  libeigen3-dev libsuitesparse-dev libopenblas-dev libboost-dev libhdf5-dev \
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libudunits2-dev libpugixml-dev zlib1g-dev \
  libgtest-dev libgmock-dev libbenchmark-dev gnuplot-nox
TOOLS := clang-format clang-tidy
ENSEMBLE_PACKAGES := snakemake
SLURM_PACKAGES := munge slurmctld slurmd slurm-client
PYTHON_PACKAGES := python3-dev pybind11-dev python3-numpy python3-h5py python3-pytest
FUZZ_PACKAGES := clang-14 llvm-14 libclang-rt-14-dev libomp-14-dev
SANITIZE_PACKAGES := valgrind
COVERAGE_PACKAGES := gcovr

SOURCES = $(shell git ls-files --cached --others --exclude-standard -- '*.cpp' '*.hpp')

# $(call install,PACKAGES): those that are missing. The lists of packages are updated only if that fails without.
define install
	@missing=; \
	for package in $(1); do \
	  dpkg-query -W -f='$${db:Status-Status}' $$package 2>/dev/null | grep -q '^installed' || missing="$$missing $$package"; \
	done; \
	if [ -n "$$missing" ]; then \
	  if [ "$$(id -u)" = 0 ]; then as_root='env'; else as_root='sudo env'; fi; \
	  apt="$$as_root DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0"; \
	  echo "Installing$$missing"; \
	  $$apt install --no-install-recommends $$missing >/dev/null 2>&1 || \
	    { $$apt update && $$apt install --no-install-recommends $$missing >/dev/null; }; \
	fi
endef

# What clang-tidy looks at for a change: the sources that differ from the last commit a day older than this one, at
# most so many of them (all: make tidy).
TIDY_SINCE ?= $(shell git rev-list -1 --before="@$$(($$(git log -1 --format=%ct) - 86400))" HEAD)
TIDY_MOST ?= 12

# The sources to look at, what changed last first: those not committed, then commit by commit. A header stands for the
# source of its name.
changed_sources = { git diff --name-only HEAD; git log --format= --name-only $(TIDY_SINCE)..HEAD; } | \
  sed -n 's/[.]hpp$$/.cpp/; /[.]cpp$$/p' | awk '!seen[$$0]++' | while read -r f; do [ -f "$$f" ] && echo "$$f"; done

# How each file is compiled, but without GCC's precompiled headers, which clang cannot read: so a source that relies on
# them for an include of its own is found, too.
define tidy_database
	@cmake --preset release -B build/tidy -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON > /dev/null
endef

# How long `make fuzz` stays with each reader.
SECONDS_EACH ?= 60

.PHONY: fuzz sanitize coverage faults faults-short help deps tools python test-python test-freefem program build test verify mutants figures ledger extremes ensemble ensemble-test ensemble-slurm bench format check-format tidy tidy-changed clean

help:
	@echo 'make verify   build, then hold the solver against its independent truths (exit 1 if it falls short),'
	@echo '              with a report to read: $(OUT)/verify/report.html'
	@echo 'make test     build, then run the tests of the parts (JUnit XML: build/junit.xml)'
	@echo 'make mutants  put seeded faults into a copy, one by one, and ask who sees them (hours; FAULTS=names)'
	@echo 'make faults   kill it, fill the disk, damage its files ...: a table of what was lost (make faults-short: a few tries)'
	@echo 'make program  build/crawford; make build: the tests as well'
	@echo 'make figures  the figures of the paper and the ledger of its claims, with their pages: read'
	@echo '              $(OUT)/figures/index.html (FIDELITY=draft|paper|fine, now $(FIDELITY)). What was cut off goes on'
	@echo 'make ledger   settle the ledger anew: readings, refinements, other packs (hours)'
	@echo 'make extremes maps of where answers stand, far from the paper: $(OUT)/figures/extremes.html'
	@echo 'make ensemble burns of many packs, gathered to $(OUT)/ensemble/ensemble.html (ENSEMBLE=workflow/example.yaml);'
	@echo '              ensemble-test kills one, changes one, leaves one no memory; ensemble-slurm tries a cluster (as root)'
	@echo 'make python   the Python module, in build/python (PYTHONPATH=build/python python3 -c "import crawford")'
	@echo 'make test-python  the tests of it, and the examples for other codes'
	@echo 'make test-freefem  FreeFEM solves two sandwiches and is judged'
	@echo 'make bench    how fast the parts are, and against results/bench.json'
	@echo 'make fuzz     broken bytes for every reader of files (SECONDS_EACH=600; now $(SECONDS_EACH))'
	@echo 'make sanitize the tests under sanitizers of memory, arithmetic and threads, a burn under valgrind (1.5 h)'
	@echo 'make coverage which lines of solver/ and reference/ the tests run: build/coverage/coverage.html (an hour)'
	@echo 'make deps     install what is missing of the Debian packages that Crawford needs'
	@echo 'make format   put all sources into the one format; make check-format only looks'
	@echo 'make tidy     clang-tidy over all sources; make tidy-changed: over what changed of late'
	@echo 'make clean    remove build/'

deps:
	$(call install,$(PACKAGES))

tools:
	$(call install,$(TOOLS))

# What Python loads is compiled apart (position-independent), and only what it needs.
python: program
	$(call install,$(PYTHON_PACKAGES))
	@cmake -S . -B build/python-module -G Ninja -D CMAKE_BUILD_TYPE=Release \
	  -D CMAKE_POSITION_INDEPENDENT_CODE=ON -D CRAWFORD_PYTHON=ON > /dev/null
	@cmake --build build/python-module --target engine -j $(JOBS)

# Debian's own: another python3 in PATH may lack pytest.
test-python: python
	@/usr/bin/python3 -B -m pytest -q -p no:cacheprovider examples/python

# Another code's sandwiches, held against the exact ones.
test-freefem: program
	$(call install,freefem++)
	@examples/freefem/judge $(OUT)/freefem

program: deps
	@cmake --preset release >/dev/null
	@cmake --build --preset release --target crawford --parallel $(JOBS)

build: program
	@cmake --build --preset release --parallel $(JOBS)

test: build
	@ctest --preset release --label-exclude verify --parallel $(JOBS) --output-junit junit.xml

verify: program
	@build/crawford verify --out $(OUT)/verify

mutants: deps
	@cmake --preset release >/dev/null
	@cmake --build --preset release --target mutants --parallel $(JOBS)
	@build/tests/mutants/mutants $(FAULTS)

faults: program
	$(call install,python3 $(ENSEMBLE_PACKAGES))
	@nice python3 -B tests/faults/faults.py

faults-short: program
	$(call install,python3)
	@nice python3 -B tests/faults/faults.py --short

figures: program
	@build/crawford run --all --fidelity $(FIDELITY) --out $(OUT)
	@build/crawford ledger --out $(OUT)

# What is settled at the paper's fidelity is what the tree keeps.
ledger: program
	@build/crawford ledger --settle --fidelity $(FIDELITY) --out $(OUT)
	@if [ $(FIDELITY) = paper ]; then cp $(OUT)/figures/ledger.json results/ledger.json; fi

# Nothing may be wrong without a word.
extremes: program
	@build/crawford run extremes --fidelity $(FIDELITY) --out $(OUT)
	@if grep -q '"class": "wrong"' $(OUT)/extremes.json; then \
	  echo 'make extremes: answers are wrong without a word; see $(OUT)/figures/extremes.html'; exit 1; fi

ENSEMBLE ?= workflow/example.yaml
# How often ensemble-test kills, and what.
KILLS ?= 1
KILLED ?= workflow/twenty.yaml

ensemble: program
	$(call install,$(ENSEMBLE_PACKAGES))
	@snakemake --snakefile workflow/Snakefile --profile workflow/profiles/local --configfile "$(ENSEMBLE)" \
	  --config "out=$(OUT)/ensemble"

ensemble-test: program
	$(call install,$(ENSEMBLE_PACKAGES))
	@workflow/try_kills "$(KILLED)" "$(OUT)/ensemble-test" $(KILLS)
	@workflow/try_changes "$(OUT)/ensemble-changes"
	@workflow/try_short_memory "$(OUT)/ensemble-memory"

ensemble-slurm: program
	$(call install,$(ENSEMBLE_PACKAGES) $(SLURM_PACKAGES))
	@workflow/try_slurm workflow/twenty.yaml "$(OUT)/ensemble-slurm"

bench: program
	@cmake --build --preset release --target bench bench_with_regions --parallel $(JOBS)
	$(call install,python3-minimal)
	@build/tests/bench/bench --benchmark_out=build/bench.json --benchmark_out_format=json
	@python3 tests/bench/compare.py results/bench.json build/bench.json
	@for pair in 1 2 3; do for program in bench bench_with_regions; do \
	  echo "pack, pair $$pair, $$program:"; \
	  build/tests/bench/$$program --benchmark_filter=solver_pack/cholmod 2>/dev/null | grep solver_pack; done; done

# Exit 1 if any reader breaks.
fuzz: program
	$(call install,$(FUZZ_PACKAGES))
	@cmake --preset fuzz > /dev/null
	@cmake --build --preset fuzz --target fuzzers --parallel $(JOBS)
	@tests/fuzz/run $(SECONDS_EACH)

sanitize: program
	$(call install,$(SANITIZE_PACKAGES))
	@JOBS=$(JOBS) tests/sanitize/run

coverage: deps
	$(call install,$(COVERAGE_PACKAGES))
	@JOBS=$(JOBS) tests/sanitize/coverage

format: tools
	@clang-format -i $(SOURCES)

check-format: tools
	@clang-format --dry-run --Werror $(SOURCES)

tidy: tools build
	$(tidy_database)
	@here=$$(pwd | sed 's/[][\.*+?^$${}()|]/\\&/g'); \
	run-clang-tidy -quiet -p build/tidy "$$here/(base|solver|reference|reports|cases|program|tests)/.*"

tidy-changed: tools build
	$(tidy_database)
	@sources=$$($(changed_sources)); count=$$(echo "$$sources" | grep -c .); \
	if [ $$count -gt $(TIDY_MOST) ]; then \
	  echo "clang-tidy: the $(TIDY_MOST) changed last of $$count; all: make tidy-changed TIDY_MOST=$$count"; fi; \
	echo "$$sources" | head -n $(TIDY_MOST) | xargs -r -P $(JOBS) -n 1 clang-tidy --quiet -p build/tidy

clean:
	@rm -rf build
