#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Builds upstream LIGGGHTS with our models in its source tree, in the folder WORK. The last line on
# stdout is the path of the binary; all else goes to stderr.
#
#   build_upstream.sh WORK
#
# What WORK holds already is kept: nothing is done while our files are older than the last build,
# and changed ones are compiled anew, not the engine.
set -eu
exec 3>&1 1>&2

fail() { printf 'ERROR: %s\n' "$*"; exit 1; }

[ $# = 1 ] || fail "usage: $0 WORK"
here=$(cd "$(dirname "$0")" && pwd)
models=$here/../../contact_models
mkdir -p "$1"
work=$(cd "$1" && pwd)
# Test processes side by side: the first builds, the others wait and find it done.
exec 9>"$work/lock"
flock 9
tree=$work/liggghts

# The tarball of Debian's source package, with private lists: no root, no change to the machine.
fetch() {
  command -v apt-get >/dev/null || fail "apt-get is needed to download the LIGGGHTS source package"
  # The mirror this machine uses, as "URI SUITE/COMPONENT"; without package lists, Debian's own.
  repository=$(LC_ALL=C apt-cache policy liggghts | awk '/ Packages$/ { print $2, $3; exit }')
  [ -n "$repository" ] ||
    repository="http://deb.debian.org/debian $(. /etc/os-release && echo "$VERSION_CODENAME")/main"
  distribution=${repository#* }

  rm -rf "$work/apt"
  mkdir -p "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
  printf 'deb-src [signed-by=%s] %s %s %s\n' /usr/share/keyrings/debian-archive-keyring.gpg \
    "${repository% *}" "${distribution%/*}" "${distribution##*/}" >"$work/apt/sources.list"
  set -- -q -o "Dir::Etc::sourcelist=$work/apt/sources.list" -o Dir::Etc::sourceparts=- \
    -o "Dir::State::lists=$work/apt/lists" -o "Dir::Cache=$work/apt/cache"
  cd "$work/apt"
  apt-get "$@" update || fail "apt-get update failed; is the network reachable?"
  apt-get "$@" source --tar-only --download-only liggghts ||
    fail "apt-get could not download the source of liggghts"
  mv liggghts_*.orig.tar.* "$work"
  cd "$work"
  rm -r apt
}

unpack() {
  [ -n "$(find "$work" -maxdepth 1 -name 'liggghts_*.orig.tar.*')" ] || fetch
  rm -rf "$tree" "$work/build"
  mkdir "$tree"
  tar -x -f "$work"/liggghts_*.orig.tar.* -C "$tree" --strip-components=1
  cd "$tree/src"

  # Since g++ 11 `stream() << x` is a temporary, which binds to a reference to const only.
  sed -i 's/static_cast< std::ostringstream & >/static_cast< const std::ostringstream \& >/' utils.h
  # A pointer cannot be ordered against 0; "is there a list?" was meant.
  sed -i 's/numneigh > 0)/numneigh != NULL)/' finish.cpp
  # The one VTK writer that is compiled even when VTK is absent.
  rm -f dump_mesh_vtk.cpp dump_mesh_vtk.h
  # The combinations LIGGGHTS picks for itself; an empty list keeps its own models to the generic
  # class and saves half a minute at each build.
  : >style_contact_model.whitelist
  # The file that all combinations are compiled in: to optimise it takes longer than all it is for.
  sed -i '1i #pragma GCC optimize("O0")' lammps.cpp
  touch "$tree/unpacked"
}

# What nearly every source of the engine includes is compiled once, and without MPI's C++ classes,
# which nothing uses: a third of the time.
flags="-O1 -std=c++17 -w -DOMPI_SKIP_MPICXX -DSUPERQUADRIC_ACTIVE_FLAG -DNONSPHERICAL_ACTIVE_FLAG"
precompile() {
  printf '#include <%s>\n' mpi.h algorithm cmath cstring fstream iostream list map set sstream \
    string vector >"$work/common.h"
  printf '#include "pointers.h"\n' >>"$work/common.h"
  # shellcheck disable=SC2046,SC2086
  c++ $flags $(mpicxx --showme:compile) -I"$tree/src" -x c++-header "$work/common.h" \
    -o "$work/common.h.gch"
}

# Superquadrics are on as in LIGGGHTS' `make auto`, and off in Debian's package: between them the
# plugin and this binary cover both layouts of the engine's contact data.
build() {
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # without it a ccache refuses what is precompiled
  [ -e "$work/build/build.ninja" ] || {
    precompile
    cmake -S "$tree/src" -B "$work/build" -G Ninja -Wno-dev \
      -DCMAKE_CXX_FLAGS="$flags -fpch-preprocess -include \"$work/common.h\"" \
      -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON -DCMAKE_DISABLE_FIND_PACKAGE_JPEG=ON
  }
  # By themselves first: ninja does not look again at headers that a step of the same run rewrote.
  cmake --build "$work/build" --target GenerateHeaders
  cmake --build "$work/build" --target liggghts_bin --parallel "$(nproc)"
}

# The stamp is as old as the start of the build it tells of: an edit during a build is not lost.
if [ ! -e "$work/built" ] ||
  [ -n "$(find "$models" "$here" \( -name '*.h' -o -name '*.cpp' -o -name '*.in' -o -name '*.txt' -o -name '*.sh' \) -newer "$work/built")" ]; then
  touch "$work/begun"
  [ "$tree/unpacked" -nt "$here/build_upstream.sh" ] || unpack
  "$models/in_tree/install.sh" "$tree"
  build
  mv "$work/begun" "$work/built"
fi
echo "$work/build/liggghts" >&3
