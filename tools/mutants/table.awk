# Counts the results (number, kind, verdict). Ends with 1 when a named mistake is not killed, or when one is that should
# make no difference.
{ all[$2]++ }
$3 ~ /^killed/ { killed[$2]++ }
$3 == "SURVIVED" { survived[$2]++ }
$3 == "invalid" { invalid[$2]++ }

function row(title, kind) {
	share = all[kind] > invalid[kind] ? sprintf("%.1f %%", 100 * killed[kind] / (all[kind] - invalid[kind])) : "-"
	printf "%-26s%9d%9d%9d%9s%12d\n", title, all[kind] - invalid[kind], killed[kind], survived[kind], share, invalid[kind]
}

END {
	printf "\n%-26s%9s%9s%9s%9s%12s\n", "", "mutants", "killed", "survived", "share", "no code"
	row("named mistakes", "named")
	row("other small changes", "other")
	row("listed as equivalent", "equivalent")
	exit killed["named"] < all["named"] || killed["equivalent"] > 0
}
