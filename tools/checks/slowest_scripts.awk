# From the results as JUnit XML: the seconds of each test script, then its path. Sort and cut the lines to have the slowest.

/<testcase / {
	match($0, /classname="[^"]*"/)
	script = substr($0, RSTART + 11, RLENGTH - 12)
	# A class inside of a script counts for the script.
	sub(/\.gd\..*/, ".gd", script)
	match($0, / time="[^"]*"/)
	seconds[script] += substr($0, RSTART + 7, RLENGTH - 8)
}

END {
	for (script in seconds) printf "%8.2f s  %s\n", seconds[script], script
}
