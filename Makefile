# The doors of lissom. The work is done by CMake (see CMakePresets.json) and by the scripts in tools/.
.POSIX:

help:
	@echo "lissom: design of flexible structures"
	@echo ""
	@echo "  make run     set up, build, solve the demo scenes, then open the studio on the butterfly"
	@echo "  make test    set up, build, run every test; ends with 'N passed, N failed'"
	@echo "  make bench   set up, build, measure; writes build/bench.json and a table"
	@echo "  make bench-inverse   the same for inverse design alone, beside optimisers of others"
	@echo ""
	@echo "  make build   configure and build everything in build/release"
	@echo "  make setup   install what is missing from Debian's packages (asks nothing)"
	@echo "  make format  clang-format over all sources"
	@echo "  make lint    layer check, format check, clang-tidy"
	@echo "  make clean   remove build/ and out/"

run:
	@tools/setup.sh build
	@tools/build.sh release lissom_cli
	@tools/run_demo.sh

test:
	@tools/setup.sh test
	@tools/build.sh release
	@/usr/bin/env python3 tools/run_tests.py build/release --verify

bench:
	@tools/setup.sh build
	@tools/build.sh release benches
	@/usr/bin/env python3 tools/bench.py build/release

# The study of docs/guide/inverse.md; tools/kill_and_resume.py kills the design of the Sheet ten times.
bench-inverse:
	@tools/setup.sh bench
	@tools/build.sh release benches lissom_cli
	@/usr/bin/env python3 tools/bench.py build/release inverse_sheet_bench gradient_cost_bench inverse_study_bench methods_bench
	@/usr/bin/env python3 tools/kill_and_resume.py

build:
	@tools/build.sh release

setup:
	@tools/setup.sh test

format:
	@tools/format.sh

lint:
	@/usr/bin/env python3 tools/check_layers.py
	@tools/format.sh --check
	@/usr/bin/env python3 tools/lint.py

clean:
	rm -rf build out

.PHONY: help run test bench bench-inverse build setup format lint clean
