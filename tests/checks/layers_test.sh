#!/bin/sh
# layers.sh accepts a tree that obeys and rejects the same tree with any one of these lines planted in it.
set -eu
here=$(pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# plant FILE LINE: a tree that obeys, and LINE in FILE.
plant() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/src/scalar" "$tree/src/io" "$tree/src/cli" "$tree/exact/rational" "$tree/proofs"
  printf '#include <vector>\n' > "$tree/src/scalar/a.hpp"
  printf '#include <nlohmann/json.hpp>\n#include "torse/scalar/a.hpp"\n' > "$tree/src/io/a.cpp"
  printf '#include <gmp.h>\n#include "torse/algebra/a.hpp"\n' > "$tree/exact/rational/a.hpp"
  printf '#include "torse/exact/a.hpp"\n#include "torse/quasi/a.hpp"\n' > "$tree/proofs/a.hpp"
  printf '#include <gmp.h>\n#include "torse/proofs/a.hpp"\n#include "torse/cli/a.hpp"\n' > "$tree/src/cli/main.cpp"
  mkdir -p "$tree/$(dirname "$1")"
  printf '%s\n' "$2" >> "$tree/$1"
}
accepts() {
  plant "$1" "$2"
  sh "$here/layers.sh" "$tree" > /dev/null || { echo "rejected: $1: $2"; failures=$((failures + 1)); }
}
rejects() {
  plant "$1" "$2"
  if sh "$here/layers.sh" "$tree" > /dev/null; then echo "accepted: $1: $2"; failures=$((failures + 1)); fi
}

accepts src/algebra/b.hpp '#include <Eigen/Core>'
accepts fuzz/b.hpp '#include <rapidcheck.h>'
accepts src/algebra/b.hpp '// #include "torse/spline/a.hpp"'
rejects src/scalar/b.hpp '#include "torse/algebra/a.hpp"'
rejects src/algebra/b.hpp ' #  include "torse/spline/a.hpp"'
rejects src/spline/b.hpp '#include "torse/developable/a.hpp"'
rejects src/developable/b.hpp '#include "torse/quasi/a.hpp"'
rejects src/quasi/b.cpp '#include "torse/io/a.hpp"'
accepts src/quasi/b.cpp '#include <LBFGS.h>'
rejects src/quasi/b.hpp '#include <LBFGS.h>'
rejects src/io/b.cpp '#include <LBFGS.h>'
rejects src/io/b.cpp '#include "torse/cli/a.hpp"'
rejects src/developable/b.hpp '#include "torse/exact/rational/a.hpp"'
rejects src/quasi/b.hpp '#include "torse/proofs/a.hpp"'
accepts exact/decide/b.cpp '#include "torse/developable/a.hpp"'
accepts proofs/b.cpp '#include "torse/exact/decide/a.hpp"'
accepts exact/decide/b.cpp '#include "torse/quasi/a.hpp"'
rejects exact/decide/b.cpp '#include "torse/io/a.hpp"'
rejects exact/ball/b.cpp '#include "torse/exact/decide/a.hpp"'
rejects exact/ball/b.cpp '#include "torse/spline/a.hpp"'
rejects exact/ball/b.cpp '#include "torse/proofs/a.hpp"'
rejects proofs/b.hpp '#include "torse/cli/a.hpp"'
rejects src/scalar/b.hpp '#include <gmp.h>'
rejects src/algebra/b.hpp '#include <gmpxx.h>'
rejects src/algebra/b.hpp '#include <mpfr.h>'
rejects src/spline/b.hpp '#include <flint/fmpz.h>'
rejects src/spline/b.hpp '#include <arb.h>'
rejects src/io/b.cpp '#include <boost/multiprecision/gmp.hpp>'
rejects src/quasi/b.hpp '#include <nlohmann/json.hpp>'
accepts src/cad/b.cpp '#include <Geom_Plane.hxx>'
accepts fuzz/targets/cad/b.cpp '#include <Geom_Plane.hxx>'
accepts fuzz/targets/cad/b.cpp '#include "torse/cad/a.hpp"'
rejects fuzz/targets/b.cpp '#include <Geom_Plane.hxx>'
rejects fuzz/targets/b.cpp '#include "torse/cad/a.hpp"'
accepts src/cad/b.cpp '#include "torse/io/a.hpp"'
rejects src/cad/b.cpp '#include <gmp.h>'
rejects src/cad/b.cpp '#include "torse/scalar/a.hpp"'
rejects src/io/b.cpp '#include <Geom_Plane.hxx>'
rejects src/cli/b.cpp '#include <Geom_Plane.hxx>'
rejects src/cli/b.cpp '#include "torse/cad/a.hpp"'
accepts src/mpi/b.cpp '#include <mpi.h>'
accepts src/mpi/b.cpp '#include "torse/fuzz/campaign/ranks.hpp"'
rejects src/mpi/b.cpp '#include "torse/fuzz/campaign/store.hpp"'
rejects src/mpi/b.cpp '#include <gmp.h>'
rejects fuzz/campaign/b.cpp '#include <mpi.h>'
rejects src/cli/b.cpp '#include <mpi.h>'
rejects src/cli/b.cpp '#include "torse/mpi/a.hpp"'
accepts fuzz/campaign/b.cpp '#include <sqlite3.h>'
rejects fuzz/b.cpp '#include <sqlite3.h>'
rejects src/cli/b.cpp '#include <sqlite3.h>'
rejects src/scalar/b.hpp '#include "a.hpp"'
rejects src/algebra/b.hpp '#include <torse/scalar/a.hpp>'
rejects src/novel/b.hpp '#include <vector>'
rm -rf "${tree:?}"/*
mkdir "$tree/src"
if sh "$here/layers.sh" "$tree" > /dev/null; then echo "accepted: an empty tree"; failures=$((failures + 1)); fi
[ "$failures" = 0 ]
