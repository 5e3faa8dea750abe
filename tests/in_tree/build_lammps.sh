#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Build LAMMPS from the source package of Debian 13 in the folder WORK: first alone, with the plugin
# compiled from the same sources, then with the laws compiled in. Results are WORK/plain/lmp,
# WORK/plugin/lammps/plastigranplugin.so and WORK/with_laws/lmp. Earlier results in WORK stay; only
# changed files are compiled.
#
#   build_lammps.sh WORK
set -eu

[ $# = 1 ] || { printf 'ERROR: usage: %s WORK\n' "$0" >&2; exit 1; }
here=$(cd "$(dirname "$0")" && pwd)
project=$here/../..
mkdir -p "$1"
cd "$1"
work=$PWD

if [ ! -e sources/unpacked ]; then
  [ -n "$(find . -maxdepth 1 -name 'lammps_*.orig.tar.*')" ] ||
    "$here/fetch_source.sh" lammps trixie
  rm -rf sources
  mkdir sources
  tar -x -f lammps_*.orig.tar.* -C sources --strip-components=1
  touch sources/unpacked
fi

# The compiler optimizes little, because the tests take less time than the compilation.
build_lammps() {
  folder=$1
  shift
  cmake -S sources/cmake -B "$folder" -G Ninja -D CMAKE_BUILD_TYPE=Release \
    -D CMAKE_CXX_FLAGS_RELEASE=-O1 -D PKG_GRANULAR=yes -D PKG_PLUGIN=yes -D PKG_RIGID=yes \
    -D BUILD_MPI=yes -D BUILD_OMP=no -D WITH_JPEG=no -D WITH_PNG=no -D WITH_FFMPEG=no -D WITH_GZIP=no \
    -D WITH_CURL=no "$@"
  cmake --build "$folder" --target lmp
}

build_lammps plain
cmake -S "$project" -B plugin -G Ninja -D CMAKE_BUILD_TYPE=Release -D PLASTIGRAN_LAMMPS=yes \
  -D LAMMPS_SOURCE_DIR="$work/sources/src"
cmake --build plugin --target plastigranplugin
build_lammps with_laws \
  -D CMAKE_PROJECT_lammps_INCLUDE="$project/contact_models/lammps/in_tree.cmake"
