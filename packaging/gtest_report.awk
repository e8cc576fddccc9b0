# Reads a GoogleTest run, prints what a person needs of it (the output of tests that failed), and writes
#   passed failed skipped total
# to the file `counts`. `total` is what was selected; a program that dies leaves tests of them uncounted.
# A test's own output may stand before a result on the same line, so results are known by their end.

function finish(outcome) {
  if (outcome == "failed" && block != "") printf "%s", block
  if (outcome == "failed") fflush()
  count[outcome]++
  block = ""
  running = ""
}

/^\[==========\] Running [0-9]+ tests? / { total = $3; next }
/^\[ RUN      \] / { running = substr($0, 14); block = ""; sub(/^ +/, "", running); block = $0 "\n"; next }
running != "" && /\[       OK \] .* \([0-9]+ ms\)$/ { finish("passed"); next }
running != "" && /\[  SKIPPED \] .* \([0-9]+ ms\)$/ { skipped_names[++n_skipped] = running; finish("skipped"); next }
running != "" && /\[  FAILED  \] .* \([0-9]+ ms\)$/ { block = block $0 "\n"; finish("failed"); next }
running != "" { block = block $0 "\n"; next }
# Between the tests: only what is not GoogleTest's own (a fixture's trouble, a sanitizer's report at the end).
/^Running main\(\) from / || /^\[[-= A-Z]+\]/ || /^$/ || /^Note: / || / FAILED TESTS?$/ || /^ +YOU HAVE / { next }
{ print; fflush() }

END {
  if (running != "") { printf "%s", block; print "died in " running; count["failed"]++ }
  for (i = 1; i <= n_skipped; i++) print "skipped: " skipped_names[i]
  printf "%d %d %d %d\n", count["passed"], count["failed"], count["skipped"], total > counts
}
