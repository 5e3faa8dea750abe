#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Build upstream LIGGGHTS with the given laws in its source tree, in the folder WORK. The last line
# on stdout is the path of the binary; all other output goes to stderr.
#
#   build_upstream.sh WORK LAW...
#
# Earlier results in WORK stay. The script does nothing if our files are older than the last build;
# otherwise it compiles only the changed files.
set -eu
exec 3>&1 1>&2

fail() { printf 'ERROR: %s\n' "$*"; exit 1; }

[ $# -ge 2 ] || fail "usage: $0 WORK LAW..."
here=$(cd "$(dirname "$0")" && pwd)
models=$here/../../contact_models
mkdir -p "$1"
work=$(cd "$1" && pwd)
shift
laws=$*
# Of several test processes, the first builds and the others wait.
exec 9>"$work/lock"
flock 9
tree=$work/liggghts

unpack() {
  [ -n "$(find "$work" -maxdepth 1 -name 'liggghts_*.orig.tar.*')" ] ||
    (cd "$work" && "$here/fetch_source.sh" liggghts)
  rm -rf "$tree" "$work/build"
  mkdir "$tree"
  tar -x -f "$work"/liggghts_*.orig.tar.* -C "$tree" --strip-components=1
  cd "$tree/src"

  # Since g++ 11 `stream() << x` is a temporary, which binds to a reference to const only.
  sed -i 's/static_cast< std::ostringstream & >/static_cast< const std::ostringstream \& >/' utils.h
  # A pointer cannot be compared with 0 by `>`; the condition is true if the list exists.
  sed -i 's/numneigh > 0)/numneigh != NULL)/' finish.cpp
  # This VTK writer is compiled even without VTK.
  rm -f dump_mesh_vtk.cpp dump_mesh_vtk.h
  # The combinations of LIGGGHTS' own models; an empty list uses the generic class and saves half a
  # minute per build.
  : >style_contact_model.whitelist
  echo "$laws" >"$tree/unpacked"
}

# Returns true if this script and its laws are those of the unpacked tree.
tree_is_current() {
  [ "$tree/unpacked" -nt "$here/build_upstream.sh" ] && [ "$(cat "$tree/unpacked")" = "$laws" ]
}

# Precompile the headers of nearly every source, without MPI's unused C++ classes; this
# shortens the build. Optimization takes longer than the tests gain.
flags="-O0 -std=c++17 -w -DOMPI_SKIP_MPICXX -DSUPERQUADRIC_ACTIVE_FLAG -DNONSPHERICAL_ACTIVE_FLAG"
precompile() {
  printf '#include <%s>\n' mpi.h algorithm cmath cstring fstream iostream list map set sstream \
    string vector >"$work/common.h"
  printf '#include "pointers.h"\n' >>"$work/common.h"
  # shellcheck disable=SC2046,SC2086
  c++ $flags $(mpicxx --showme:compile) -I"$tree/src" -x c++-header "$work/common.h" \
    -o "$work/common.h.gch"
}

# Other laws compile the same templates. They would only lengthen the build.
remove_other_laws() {
  for file in "$tree"/src/law_*.cpp; do
    law=$(basename "$file" .cpp)
    law=${law#law_}
    case " $laws " in *" $law "*) continue ;; esac
    rm "$file"
    sed -i "/^LAW($law)$/d" "$tree/src/registered.inc"
  done
}

# Superquadrics are on as in LIGGGHTS' `make auto`, and off in Debian's package: between them the
# plugin and this binary cover both layouts of LIGGGHTS' contact data.
build() {
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # otherwise ccache rejects precompiled headers
  [ -e "$work/build/build.ninja" ] || {
    precompile
    cmake -S "$tree/src" -B "$work/build" -G Ninja -Wno-dev \
      -DCMAKE_CXX_FLAGS="$flags -fpch-preprocess -include \"$work/common.h\"" \
      -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON -DCMAKE_DISABLE_FIND_PACKAGE_JPEG=ON
  }
  # A separate run, because ninja does not check headers again that the same run rewrote.
  cmake --build "$work/build" --target GenerateHeaders
  cmake --build "$work/build" --target liggghts_bin --parallel "$(nproc)"
}

# The stamp has the time of the start of the build, so that an edit during a build counts.
if [ ! -e "$work/built" ] || ! tree_is_current ||
  [ -n "$(find "$models" "$here" \( -name '*.h' -o -name '*.cpp' -o -name '*.in' -o -name '*.txt' -o -name '*.sh' \) -newer "$work/built")" ]; then
  touch "$work/begun"
  tree_is_current || unpack
  "$models/in_tree/install.sh" "$tree"
  remove_other_laws
  build
  mv "$work/begun" "$work/built"
fi
echo "$work/build/liggghts" >&3
