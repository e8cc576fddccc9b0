# The sanitizers' options for ./test --asan. Sourced before the tests run; dermis_root is the repository.
# Not strict_string_checks: libxkbcommon-x11 gives strndup a reply of the X server that no zero ends. Leaks are looked for too; packaging/leaks.supp names those of libraries that keep something until the process ends.
export ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1:abort_on_error=0:new_delete_type_mismatch=1
export LSAN_OPTIONS=suppressions=$dermis_root/packaging/leaks.supp:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
