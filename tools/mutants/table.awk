# Reads the results (number, kind, verdict, line), says again which mutants are not killed, and counts. Ends with 1
# when a named mistake is not killed, or when one that should make no difference is.
{ all[$2]++ }
$3 ~ /^killed/ { killed[$2]++ }
$3 == "SURVIVED" { survived[$2]++ }
$3 == "DOES NOT COMPILE" { not_compiled[$2]++ }
($2 == "equivalent") == ($3 ~ /^killed/) { print $4 }

function row(title, kind, compiled, share) {
	compiled = all[kind] - not_compiled[kind]
	share = compiled > 0 ? sprintf("%.1f %%", 100 * killed[kind] / compiled) : "-"
	printf "%-22s%9d%9d%10d%10s%17d\n", title, compiled, killed[kind], survived[kind], share, not_compiled[kind]
}

END {
	printf "\n%-22s%9s%9s%10s%10s%17s\n", "", "mutants", "killed", "survived", "killed", "do not compile"
	row("named mistakes", "named")
	row("other small changes", "other")
	row("listed as equivalent", "equivalent")
	exit killed["named"] < all["named"] || killed["equivalent"] > 0
}
