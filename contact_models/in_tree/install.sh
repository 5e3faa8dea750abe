#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Adds all models, with energy ledger, heat, spectra and meshes, to a LIGGGHTS source tree: the plugin's
# own files but for its launcher and its look at the engine. The engine's builds compile every .cpp flat
# in src/; headers keep their folders. Running it again brings all up to date, takes away what left the
# project and leaves alone what already is.
#
#   install.sh DIR      DIR is the tree's top folder, the one that holds src/
set -eu

fail() { printf 'ERROR: %s\n' "$*" >&2; exit 1; }

[ $# = 1 ] || fail "usage: $0 DIR, the top folder of a LIGGGHTS source tree"
tree=$1
for file in Make.sh contact_models.h normal_model_base.h version_liggghts.txt; do
  [ -f "$tree/src/$file" ] || fail "$tree is not a LIGGGHTS source tree: it has no src/$file"
done
[ -w "$tree/src" ] || fail "$tree/src cannot be written to"
version=$(cat "$tree/src/version_liggghts.txt")
[ "$version" = 3.8.0 ] ||
  printf 'WARNING: %s is LIGGGHTS %s; the models are tested with 3.8.0\n' "$tree" "$version" >&2

models=$(cd "$(dirname "$0")/.." && pwd)
plugin=$models/liggghts/plugin
new=$(mktemp -d)
trap 'rm -rf "$new"' EXIT

# The files as they are to lie below src/. The engine's builds do not look for headers in src/ itself:
# from a folder, two levels below it, every file is included by its way from there.
cd "$models"
for file in $(find plastigran liggghts -name '*.h' ! -path '*/plugin/*') \
  liggghts/plugin/any_model.h liggghts/plugin/engine_styles.h liggghts/plugin/foreign_histories.h \
  liggghts/plugin/registered.h; do
  mkdir -p "$new/${file%/*}"
  sed 's|^#include "|&../../|' "$file" >"$new/$file"
done
for file in $(find liggghts -name '*.cpp' ! -path '*/plugin/*') in_tree/require_version.cpp \
  liggghts/plugin/any_model.cpp liggghts/plugin/foreign_histories.cpp \
  liggghts/plugin/registration.cpp; do
  cp "$file" "$new"
done

# One file a law and one a combination with other models, as plugin/CMakeLists.txt makes them.
echo '// What registration.cpp puts into the factories of the engine; by plastigran.' >"$new/registered.inc"
grep '^[a-z]' "$plugin/laws.txt" | while read -r law class number; do
  sed "s|@law@|$law|g; s|@class@|$class|; s|@number@|$number|" "$plugin/law.cpp.in" >"$new/law_$law.cpp"
  echo "LAW($law)" >>"$new/registered.inc"
done
number=0
grep '^[A-Z]' "$plugin/combinations.txt" | while read -r tangential cohesion rolling surface; do
  number=$((number + 1))
  sed "s|@tangential@|$tangential|g; s|@cohesion@|$cohesion|g; s|@rolling@|$rolling|g
    s|@surface@|$surface|g; s|@number@|$number|g" "$plugin/combination.cpp.in" >"$new/combination_$number.cpp"
  echo "COMBINATION($number)" >>"$new/registered.inc"
done

cd "$new"
find . -type f ! -name plastigran_files.txt | sort >plastigran_files.txt

# A fork may have a file of the same name. All of ours name our namespace.
find . -type f | while read -r file; do
  if [ -e "$tree/src/$file" ] && ! grep -qi 'plastigran' "$tree/src/$file"; then
    fail "$tree/src/${file#./} is not ours and would be overwritten; nothing was changed"
  fi
done

# What an earlier version wrote and this one does not.
if [ -e "$tree/src/plastigran_files.txt" ]; then
  while read -r file; do
    if [ -e "$file" ] || ! grep -qi 'plastigran' "$tree/src/$file" 2>/dev/null; then continue; fi
    rm "$tree/src/$file"
  done <"$tree/src/plastigran_files.txt"
fi

# Only what differs is written, so that a build after this compiles no more than it must.
find . -type f | while read -r file; do
  cmp -s "$file" "$tree/src/$file" && continue
  mkdir -p "$tree/src/${file%/*}"
  cp "$file" "$tree/src/$file"
done

cat <<END
The models are in $tree/src. Build LIGGGHTS as you always do, with C++17; for instance

  cmake -S "$tree/src" -B "$tree/build" -DCMAKE_CXX_FLAGS="-O2 -std=c++17"
  cmake --build "$tree/build" --target liggghts_bin --parallel

(3.8.0 as released needs small repairs for g++ 11 and later: see tests/in_tree/build_upstream.sh.)
END
