#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Holds .ci/setup.sh's installing of packages against stand-ins for apt-get, dpkg-query and df that
# answer as Debian 12's do. Usage: setup_test.sh REPOSITORY
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$1/.ci" "$work/.ci"
mkdir "$work/bin"
failures=0

stand_in() {  # stand_in NAME: its text comes from standard input
  { echo '#!/bin/sh'; cat; } >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# install: what install_packages says and returns; in $output and $code.
install() {
  output=$(PATH="$work/bin:$PATH" bash -c '. "$1/.ci/setup.sh"; install_packages' - "$work" 2>&1)
  code=$?
}

expect() {  # expect CASE CODE PATTERN
  if [ "$code" -ne "$2" ] || ! grep -q -- "$3" <<<"$output"; then
    printf 'FAILED %s: code %s, expected %s and "%s" in:\n%s\n' "$1" "$code" "$2" "$3" "$output"
    failures=$((failures + 1))
  fi
}

stand_in dpkg-query <<<'exit 1'
stand_in id <<<'echo 0'
stand_in df <<<'printf "Filesystem 1M Used Available\nx 9000 0 9000 0%% /\n"'

# No mirror answers: apt-get update warns, and fails only where it is told to.
stand_in apt-get <<'END'
case "$*" in
  *update*Error-Mode=any*) echo "E: Failed to fetch"; exit 100 ;;
  *update*) echo "W: Failed to fetch"; exit 0 ;;
esac
echo "E: Unable to locate package"
exit 100
END
install
expect 'offline' 3 'is there a network'

# A source that has nothing of ours is gone; the packages can be had.
stand_in apt-get <<'END'
case "$*" in *update*) exit 100 ;; esac
END
install
expect 'another source is gone' 0 'installing Debian packages'

stand_in apt-get <<'END'
case "$*" in *install*) exit 100 ;; esac
END
install
expect 'a package cannot be had' 3 'could not be installed'

# The disk that apt fills is not the repository's.
for full in /usr /var/cache/apt/archives; do
  stand_in df <<END
[ "\$2" = $full ] && free=100 || free=9000
printf 'Filesystem 1M Used Available\nx 9000 0 %s 0%% /\n' \$free
END
  install
  expect "full disk" 3 "only 100 MB free on the disk of $full"
done

stand_in dpkg-query <<<'echo installed'
stand_in apt-get <<<'exit 1'
install
expect 'nothing is missing' 0 '^$'

exit $((failures > 0))
