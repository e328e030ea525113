# Reads what the test runner prints and ends at the first failure: prints the test, or why it cannot be run.
/^res:\/\/tests\// { script = substr($1, 7) }
/^\* test_/ { test = $2 }
/^ +\[Failed\]/ { print "killed by " script " " test; exit }
/^SCRIPT ERROR: (Parse|Compile) Error/ { print "DOES NOT COMPILE"; exit }
/^ERROR: it printed nothing for / { print "killed by the time limit"; exit }
