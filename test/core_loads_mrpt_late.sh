#!/usr/bin/env bash
# Programs start without MRPT's libraries: only the library of this package that is loaded when it is
# used needs them.
#
# Usage: core_loads_mrpt_late.sh MRPT_LIBRARY PROGRAM_OR_LIBRARY...
# MRPT_LIBRARY, the one that does need them, proves that the check can tell.
set -euo pipefail
mrpt_library=$1
shift

needs_mrpt() {
  local needed
  needed=$(ldd "$1") || { echo "$1 cannot be examined" >&2; exit 1; }
  grep -q 'libmrpt[-_]' <<<"$needed"
}

failures=0
needs_mrpt "$mrpt_library" || { echo "no MRPT library is seen in $mrpt_library"; failures=1; }
for file in "$@"; do
  if needs_mrpt "$file"; then
    echo "$file needs MRPT's libraries when it starts: move what needs them to src/files/mrpt_module.cpp"
    failures=1
  fi
done
[[ $failures == 0 ]]
