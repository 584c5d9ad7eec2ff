# SPDX-License-Identifier: MIT
# Sourced by the scripts that run several checks.

# step NAME COMMAND...: runs it and prints how long it took.
step() {
  local name=$1 TIMEFORMAT="--- $1: %R s; processor time %U s, and %S s in the system"
  shift
  echo "--- $name"
  time "$@"
}
