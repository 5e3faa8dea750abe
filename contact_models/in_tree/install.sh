#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Adds every model to a LIGGGHTS source tree: the engine's list of models reads normal_model_*.h flat
# in src/, its builds compile every .cpp flat in src/, all other headers keep their folders, and the
# combinations to compile go into src/style_contact_model_user.whitelist. Running it again brings
# all up to date and leaves alone what already is.
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

# Where a file goes, below src/. The energy ledger and the plugin's own files stay out.
models=$(cd "$(dirname "$0")/.." && pwd)
files=$(cd "$models" && find plastigran liggghts/model liggghts/models liggghts/fixes \
  \( -name '*.h' -o -name '*.cpp' \))
target_of() {
  case $1 in
    *.cpp | liggghts/models/*) echo "$tree/src/${1##*/}" ;;
    *) echo "$tree/src/$1" ;;
  esac
}

# A fork may have a file of the same name. All of ours name our namespace.
for file in $files; do
  target=$(target_of "$file")
  if [ -e "$target" ] && ! grep -q 'plastigran' "$target"; then
    fail "$target is not ours and would be overwritten; nothing was changed"
  fi
done

# The engine's builds do not look for headers in src/ itself: from a folder, two levels below it,
# every file is included by its way from there. Only what differs is written, so that a build after
# this compiles no more than it must.
for file in $files; do
  target=$(target_of "$file")
  mkdir -p "${target%/*}"
  way=
  [ "${target%/*}" = "$tree/src" ] || way=../../
  sed "s|^#include \"|&$way|" "$models/$file" | cmp -s - "$target" ||
    sed "s|^#include \"|&$way|" "$models/$file" >"$target"
done

# The engine compiles combinations of low model ids by itself and runs the others through its slow
# generic class, unless they are listed. These are the ones the plugin has too (plugin/CMakeLists.txt).
whitelist=$tree/src/style_contact_model_user.whitelist
touch -a "$whitelist"
[ -z "$(tail -c 1 "$whitelist")" ] || echo >>"$whitelist"  # its last line may be unfinished
for model in $(sed -n 's/^NORMAL_MODEL(\([A-Z0-9_]*\),.*/\1/p' "$models"/liggghts/models/*.h); do
  for tangential in OFF NO_HISTORY HISTORY; do
    for rolling in OFF CDT EPSD2; do
      line="GRAN_MODEL($model, TANGENTIAL_$tangential, COHESION_OFF, ROLLING_$rolling, SURFACE_DEFAULT)"
      grep -qxF "$line" "$whitelist" || echo "$line" >>"$whitelist"
    done
  done
done

cat <<END
The models are in $tree/src. Build LIGGGHTS as you always do, with C++17; for instance

  cmake -S "$tree/src" -B "$tree/build" -DCMAKE_CXX_FLAGS="-O2 -std=c++17"
  cmake --build "$tree/build" --target liggghts_bin --parallel

(3.8.0 as released needs small repairs for g++ 11 and later: see tests/in_tree/build_upstream.sh.)
END
