# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
# Sourced by the scripts beside it: paths, missing Debian packages, build.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
jobs=$(nproc)

say() { printf '\033[1m%s\033[0m\n' "$*" >&2; }
fail() { printf '%s\n' "$*" >&2; exit 1; }

# Installs what is missing from the given list; fetches nothing when all is there.
install_packages() {
  local list=$1 missing
  missing=$(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$list" | while read -r package; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done)
  [ -n "$missing" ] || return 0
  command -v apt-get >/dev/null || fail "needs Debian 12: apt-get is not here; missing packages: ${missing//$'\n'/ }"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "run as root, or install sudo, or install these yourself: ${missing//$'\n'/ }"
    as_root=(sudo)
  fi
  say "Installing $(wc -w <<<"$missing") missing Debian packages"
  "${as_root[@]}" apt-get update -qq
  # shellcheck disable=SC2086
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
}

# build DIRECTORY [cmake option…] [--target TARGET]: configures, then builds what changed.
build() {
  local directory=$1 options=() target=()
  shift
  while [ $# -gt 0 ]; do
    if [ "$1" = --target ]; then target=(--target "$2"); shift; else options+=("$1"); fi
    shift
  done
  if command -v ccache >/dev/null; then options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  cmake -S "$root" -B "$directory" "${options[@]}" >"$directory.log" 2>&1 || { cat "$directory.log" >&2; return 1; }
  cmake --build "$directory" -j "$jobs" "${target[@]}"
}
