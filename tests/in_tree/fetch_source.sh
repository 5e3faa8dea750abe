#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
#
# Download the tarball of a Debian source package to the current folder, with private package
# lists, without root.
#
#   fetch_source.sh PACKAGE [SUITE]     SUITE is a release of Debian, by default that of this machine
set -eu

fail() { printf 'ERROR: %s\n' "$*" >&2; exit 1; }

command -v apt-get >/dev/null || fail "apt-get is needed to download the source of $1"
# The mirror of this machine as "URI SUITE/COMPONENT"; Debian's own if there are no package lists.
repository=$(LC_ALL=C apt-cache policy liggghts | awk '/ Packages$/ { print $2, $3; exit }')
[ -n "$repository" ] ||
  repository="http://deb.debian.org/debian $(. /etc/os-release && echo "$VERSION_CODENAME")/main"
distribution=${repository#* }
here=$PWD
apt=$(mktemp -d)
trap 'rm -rf "$apt"' EXIT
mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
printf 'deb-src [signed-by=%s] %s %s %s\n' /usr/share/keyrings/debian-archive-keyring.gpg \
  "${repository% *}" "${2:-${distribution%/*}}" "${distribution##*/}" >"$apt/sources.list"
package=$1
set -- -q -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=- \
  -o "Dir::State::lists=$apt/lists" -o "Dir::Cache=$apt/cache"
cd "$apt"
apt-get "$@" update || fail "apt-get update failed; is the network reachable?"
apt-get "$@" source --tar-only --download-only "$package" ||
  fail "apt-get could not download the source of $package"
mv ./*.orig.tar.* "$here"
