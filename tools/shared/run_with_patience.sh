#!/usr/bin/env bash
# Runs a program and passes on all it prints; one that prints nothing for SECONDS is stopped. (A Godot whose start
# script breaks off waits for ever.) Usage: tools/shared/run_with_patience.sh SECONDS PROGRAM [ARGUMENTS]
set -euo pipefail

seconds=$1
shift
pipe=$(mktemp -d)/output
mkfifo "$pipe"
"$@" >"$pipe" 2>&1 </dev/null &
program=$!
trap 'kill "$program" 2>/dev/null || true; rm -rf "$(dirname "$pipe")"' EXIT

# read: 0 is a line, 1 the end, more than 128 too long a silence.
pass_on() {
	local line status=0
	while IFS= read -r -t "$seconds" line || { status=$? && false; }; do
		printf '%s\n' "$line"
	done
	[ -z "$line" ] || printf '%s\n' "$line"
	[ "$status" -gt 128 ] || return 0
	printf 'ERROR: it printed nothing for %d seconds and was stopped.\n' "$seconds"
	kill "$program"
}

pass_on <"$pipe"
wait "$program"
