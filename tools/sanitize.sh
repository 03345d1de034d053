#!/usr/bin/env bash
# Builds the unit and derivative tests, and those of the studio's server, with the address and undefined-behaviour sanitizers and runs them.
set -euo pipefail
. "$(dirname "$0")/common.sh"
tools/build.sh sanitizers tests_unit tests_derivatives server_parts_test server_http_test server_live_test server_fuzz_test &&
  LSAN_OPTIONS=suppressions=$PWD/tools/lsan.supp:print_suppressions=0 \
    ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1 UBSAN_OPTIONS=print_stacktrace=1 \
    python3 tools/run_tests.py build/sanitizers --labels unit,derivatives,server
