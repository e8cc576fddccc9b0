# cmake -DSOURCES=a;b -DNAME=kName -DOUTPUT=file.h -P source_hash.cmake: a header with a number that changes with any of the files.
set(all "")
foreach(source IN LISTS SOURCES)
  file(SHA256 ${source} hash)
  string(APPEND all ${hash})
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 16 hash)
file(WRITE ${OUTPUT} "#pragma once

#include <cstdint>

inline constexpr std::uint64_t ${NAME} = 0x${hash}ULL;
")
