#!/usr/bin/env bash
# Uses every exported demo as a person would: in headless Chromium, and on Linux on a screen in memory. Exports what is
# missing or stale. Usage: tools/e2e.sh [PYTEST OPTIONS]   (with options only the browser's tests run, such as -k dot_product)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../web/site.sh
. "$(dirname "$0")/../web/site.sh"

venv=$LAB_CACHE/e2e-venv

test_in_browser() {
	if ! need chromium chromium ||
		! bring_python_packages "$venv" "playwright==$PLAYWRIGHT_VERSION" "pytest==$PYTEST_VERSION"; then
		say "the browser tests were skipped: they need Chromium and Playwright"
		return 0
	fi
	bring_site_up_to_date || return 1
	CHROMIUM=$(command -v chromium) PYTHONDONTWRITEBYTECODE=1 \
		"$venv/bin/python" -m pytest -p no:cacheprovider "$LAB_ROOT/tests/e2e" "$@"
}

failed=0
make_build_folder
test_in_browser "$@" || failed=1
[ $# -gt 0 ] || "$LAB_ROOT/tools/export/check_linux_demos.sh" || failed=1
exit "$failed"
