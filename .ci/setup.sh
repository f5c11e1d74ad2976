# SPDX-License-Identifier: Apache-2.0
# Sourced by ./run and ./test: installs what is missing, configures, builds. Quiet when all is well.

set -u
HOROPTER_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
HOROPTER_LOGS=$HOROPTER_ROOT/build/log

fail() {  # fail EXIT_CODE MESSAGE...
  local code=$1
  shift
  printf 'horopter: %s\n' "$@" >&2
  exit "$code"
}

# run_logged NAME COMMAND...: silent on success; on failure the log's end and where the rest is.
run_logged() {
  local log=$HOROPTER_LOGS/$1.log
  shift
  if ! "$@" >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    printf 'horopter: failed: %s\nhoropter: the whole log: %s\n' "$*" "$log" >&2
    return 1
  fi
}

check_disk() {  # check_disk NEEDED_MB FOLDER
  local free_mb
  free_mb=$(df -Pm "$2" | awk 'NR == 2 {print $4}')
  if [ "${free_mb:-0}" -lt "$1" ]; then
    fail 3 "only ${free_mb:-0} MB free on the disk of $2, $1 MB needed; free some space."
  fi
}

missing_packages() {
  local package
  grep -Ev '^\s*(#|$)' "$HOROPTER_ROOT/.ci/packages.txt" | while read -r package; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      echo "$package"
  done
}

install_packages() {
  local missing sudo="" lists_are_new=yes
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail 3 "this set-up needs Debian 12 (apt-get not found). Install the equivalents of the packages" \
      "in .ci/packages.txt by hand, then: cmake --preset release && cmake --build --preset release"
  fi
  missing=$(missing_packages | tr '\n' ' ')
  [ -n "${missing// /}" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail 3 "packages are missing and there is no sudo; as root: apt-get install $missing"
    sudo=sudo
  fi
  echo "horopter: installing Debian packages: $missing"
  check_disk 2500 /usr
  check_disk 700 /var/cache/apt/archives
  export DEBIAN_FRONTEND=noninteractive
  # Without the error mode apt calls it a success when no mirror answers. It is no failure here
  # either as long as the packages can be had: one of a machine's other sources may be gone.
  $sudo apt-get update -o APT::Update::Error-Mode=any >"$HOROPTER_LOGS/apt-update.log" 2>&1 ||
    lists_are_new=no
  # shellcheck disable=SC2086
  if ! run_logged apt-install $sudo apt-get install -y --no-install-recommends $missing; then
    [ $lists_are_new = yes ] ||
      fail 3 "the package lists could not be fetched: is there a network?" \
        "The log: $HOROPTER_LOGS/apt-update.log" "Missing packages: $missing"
    fail 3 "these packages could not be installed (Debian 12 has them all): $missing"
  fi
}

# build PRESET TARGET...
build() {
  local preset=$1 dir=$HOROPTER_ROOT/build/$1
  shift
  if [ ! -f "$dir/build.ninja" ]; then
    check_disk 1500 "$HOROPTER_ROOT"
    run_logged configure cmake -S "$HOROPTER_ROOT" --preset "$preset" ||
      fail 3 "the configure step failed."
  fi
  # Asked first, so that a person is told of a build that takes minutes and not of one that does not.
  if ! ninja -C "$dir" -n "$@" 2>/dev/null | grep -q 'no work to do'; then
    echo "horopter: building ($preset) ..."
  fi
  run_logged build ninja -C "$dir" "$@" || fail 3 "the build failed."
}

mkdir -p "$HOROPTER_LOGS" 2>/dev/null ||
  fail 3 "cannot write to $HOROPTER_ROOT/build; check its permissions and the disk."
