#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Adds every model to a LIGGGHTS source tree: the laws go into src/plastigran/, the models flat into
# src/, the combinations to compile into src/style_contact_model_user.whitelist. Running it again brings both up to date and
# leaves alone what already is.
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

# The set: the adapter and the models; the laws and what is built on them keep their folders.
models=$(dirname "$0")/..
set -- "$models"/liggghts/elastoplastic_normal_model.h "$models"/liggghts/energy_ledger.h \
  "$models"/liggghts/wall_point.h "$models"/liggghts/*_watch.h "$models"/liggghts/own_fix.h \
  "$models"/liggghts/history_keeper.h "$models"/liggghts/property_name.h \
  "$models"/liggghts/engine_access.h "$models"/liggghts/normal_model_*.h

# A fork may have a file of the same name. All of ours name our namespace.
for header; do
  target=$tree/src/${header##*/}
  if [ -e "$target" ] && ! grep -q 'plastigran' "$target"; then
    fail "$target is not ours and would be overwritten; nothing was changed"
  fi
done

# Only what differs is copied, so that a build after this compiles no more than it must.
for header; do
  target=$tree/src/${header##*/}
  cmp -s "$header" "$target" || cp "$header" "$target"
done

for folder in laws shared impact; do
  mkdir -p "$tree/src/plastigran/$folder"
  for header in "$models/plastigran/$folder"/*.h; do
    target=$tree/src/plastigran/$folder/${header##*/}
    cmp -s "$header" "$target" || cp "$header" "$target"
  done
done

# The engine compiles combinations of low model ids by itself and runs the others through its slow
# generic class, unless they are listed. These are the ones the plugin has too (register_model.h).
whitelist=$tree/src/style_contact_model_user.whitelist
touch -a "$whitelist"
[ -z "$(tail -c 1 "$whitelist")" ] || echo >>"$whitelist"  # its last line may be unfinished
for model in $(sed -n 's/^NORMAL_MODEL(\([A-Z0-9_]*\),.*/\1/p' "$models"/liggghts/normal_model_*.h); do
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
