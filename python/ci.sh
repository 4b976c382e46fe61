#!/usr/bin/env bash
# Builds the wheel, installs it into a fresh virtual environment, and runs tests, stubtest, doctests and notebooks there.
set -euo pipefail
cd "$(dirname "$0")"
target=$(cargo metadata --format-version 1 --no-deps | python3 -c 'import json, sys; print(json.load(sys.stdin)["target_directory"])')
root=$(cd .. && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

step() { printf '\n== python: %s (%ss)\n' "$*" "$SECONDS"; }

step "the wheel"
python3 -m venv "$work/venv"
bin=$work/venv/bin
"$bin/pip" install --quiet --disable-pip-version-check 'maturin>=1.9,<2'
CARGO_TARGET_DIR=$target "$bin/maturin" build --release --locked --out "$work/wheels" --interpreter "$bin/python"
"$bin/pip" install --quiet --disable-pip-version-check "$(ls "$work"/wheels/*.whl)[test]"

step "the source distribution"
# It has every file that a build reads, also those that lie outside of the packages.
"$bin/maturin" sdist --out "$work/sdist" 2>/dev/null
read_by_builds=(crates src notes assets proofs_checks/src proofs_checks/coq proofs_checks/checker)
missing=$(LC_ALL=C comm -23 <(cd .. && git ls-files "${read_by_builds[@]}" | LC_ALL=C sort) \
  <(tar tzf "$work"/sdist/*.tar.gz | sed 's#^[^/]*/##' | LC_ALL=C sort))
if [ -n "$missing" ]; then
  printf 'missing in the source distribution:\n%s\n' "$missing"
  exit 1
fi

# Away from the sources, so that what is tested is the wheel.
cp -r tests examples pyproject.toml "$work/"
mkdir -p "$work/assets"
cp -r ../assets/. "$work/assets/"
cd "$work"
export FLOCKPROOF_ASSETS=$work/assets FLOCKPROOF_ROOT=$root

step "tests"
# What is skipped is told.
"$bin/python" -m pytest --quiet -rs tests

step "doctests"
"$bin/python" -m pytest --quiet --doctest-modules --pyargs flockproof

step "types"
"$bin/python" -m mypy --strict --package flockproof
"$bin/python" -m mypy.stubtest flockproof --ignore-missing-stub

step "notebooks"
# A recording of eight zebrafish lies in this package; nothing else of it is used.
"$bin/pip" install --quiet --disable-pip-version-check --no-deps trajectorytools==0.4.2
"$bin/python" -m pytest --quiet --nbmake --nbmake-timeout=300 examples

# With the site and the ledger that .ci/run has made before.
if [ -d "$target/site" ] && [ -f "$target/ledger.json" ]; then
  step "documentation"
  (cd "$root" && .ci/documentation "$target/documentation" "$bin/python" "$target/site" "$target/ledger.json")
fi

step "done"
