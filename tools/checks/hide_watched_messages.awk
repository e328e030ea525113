# Between the marks of tests/support/run_start.gd and run_report.gd the test runner watches the engine's errors and
# warnings: one that no test expects turns its test red there. So those lines are left out here, and whatever
# message is left was not expected by anybody.
/^=== first test$/ { watched = 1; next }
/^=== last test$/ { watched = 0; next }
watched && /^[ \t]*(SCRIPT |USER |SHADER )?(ERROR|WARNING):/ { message = 1; next }
message && /^ +at: / { message = 2; next }
message == 1 { next }
message == 2 && /^ +(GDScript backtrace|\[[0-9]+\] )/ { next }
{ message = 0; print; fflush() }
