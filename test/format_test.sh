#!/usr/bin/env bash
# The sources are formatted as .clang-format says. Versions of clang-format differ, so only 14 counts.
#
# Usage: format_test.sh REPOSITORY
set -euo pipefail
cd "$1"

version=$(clang-format --version 2>/dev/null | sed -E 's/.*version ([0-9]+).*/\1/' || true)
[[ $version == 14 ]] || {
  echo "needs clang-format 14"
  exit 77
}
find benchmark include src test \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run --Werror
