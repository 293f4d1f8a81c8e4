#!/bin/sh
# layers.sh ROOT: every #include under src, exact, proofs, fuzz, figures and studies obeys the layers. Prints each violation; exit 1 if any.
#   a lower layer never includes a higher one; exact knows scalar and algebra only; nobody but cli includes cli
#   exact/decide and the other folders of exact that are no arithmetics are a layer of their own, above quasi and exact
#   src/cad, the plugin, knows io only and is included by nobody but fuzz/targets/cad; these two alone may use OpenCASCADE
#   src/mpi, the other plugin, knows fuzz/campaign/ranks.hpp only and alone may use MPI; SQLite is for fuzz/campaign
#   fuzz/targets are programs above all of them
#   LBFGS.h is for the sources of src/quasi, no header of which shows it
#   our own headers have one spelling, "torse/<layer>/..."; everything in quotes is ours
#   src without cli uses the standard library and Eigen (io: nlohmann too), so no GMP, MPFR, FLINT, Arb or Boost
set -eu
cd "$1"
folders=
for folder in src exact proofs fuzz figures studies; do
  if [ -d "$folder" ]; then folders="$folders $folder"; fi
done
find $folders -name '*.hpp' -o -name '*.cpp' | LC_ALL=C sort | awk '
BEGIN {
  may["scalar"] = "scalar"
  may["algebra"] = may["scalar"] " algebra"
  may["spline"] = may["algebra"] " spline"
  may["developable"] = may["spline"] " developable"
  may["quasi"] = may["developable"] " quasi"
  may["io"] = may["quasi"] " io"
  may["cad"] = "io cad"
  may["mpi"] = "fuzz mpi"
  may["exact"] = may["algebra"] " exact"
  may["decide"] = may["quasi"] " exact decide"
  may["proofs"] = may["fuzz"] = may["io"] " exact decide proofs fuzz"
  may["figures"] = may["io"] " exact decide proofs figures"
  may["studies"] = may["proofs"] " studies"
  may["cli"] = may["targets"] = may["studies"] " figures cli"
  may["cad_targets"] = may["targets"] " cad"
}
function arithmetic(folder) { return folder ~ /^(ball|bigfloat|instrumented|modular|rational|roots|symbolic)$/ }
function wrong(reason) { print file ":" row ": " reason; ++violations }
function check(layer, name, own,   part) {
  if (own && name !~ /^torse\//) { wrong("\"" name "\": our headers are spelled \"torse/<layer>/...\", others <...>"); return }
  if (!own && name ~ /^torse\//) { wrong("<" name ">: our headers are in quotes"); return }
  if (own) {
    split(name, part, "/")
    if (part[2] == "exact" && !arithmetic(part[3])) part[2] = "decide"
    if (index(" " may[layer] " ", " " part[2] " ") == 0 || (layer == "mpi" && part[2] == "fuzz" && name != "torse/fuzz/campaign/ranks.hpp"))
      wrong(layer " may not include " name)
  } else if (layer != "mpi" && name == "mpi.h") {
    wrong("<mpi.h> is for src/mpi")
  } else if (where !~ /^fuzz\/campaign\// && name == "sqlite3.h") {
    wrong("<sqlite3.h> is for fuzz/campaign")
  } else if (name == "LBFGS.h" && where !~ /^src\/quasi\/.*\.cpp$/) {
    wrong("<LBFGS.h> is for the sources of src/quasi")
  } else if (layer !~ /^cad/ && name ~ /\.hxx$/) {
    wrong("<" name ">: OpenCASCADE is for src/cad and fuzz/targets/cad")
  } else if (where ~ /^src\// && layer != "cli" && name !~ /^[a-z_0-9]+$/ && name !~ /^Eigen\// && !(layer == "io" && name ~ /^nlohmann\//) &&
             !(layer == "cad" && name ~ /^[A-Za-z0-9_]+\.hxx$/) && !(layer == "mpi" && name == "mpi.h") && name != "LBFGS.h") {
    wrong("<" name "> is not for src/" layer ": the standard library and Eigen only")
  }
}
{
  file = where = $0
  layer = where
  sub(/^src\//, "", layer)
  split(layer, part, "/")
  if (part[1] == "exact" && !arithmetic(part[2])) layer = "decide"
  sub(/\/.*/, "", layer)
  if (where ~ /^fuzz\/targets\//) layer = where ~ /^fuzz\/targets\/cad\// ? "cad_targets" : "targets"
  if (!(layer in may)) { row = 1; wrong("no such layer: " layer); next }
  ++files
  for (row = 1; (getline text < file) > 0; ++row)
    if (match(text, /^[ \t]*#[ \t]*include[ \t]*["<][^">]*[">]/)) {
      ++includes
      text = substr(text, 1, RLENGTH)
      own = text ~ /"$/
      sub(/^[^"<]*["<]/, "", text)
      check(layer, substr(text, 1, length(text) - 1), own)
    }
  close(file)
}
END {
  printf "layers: %d files, %d includes, %d violations\n", files, includes, violations
  exit files == 0 || violations > 0
}'
