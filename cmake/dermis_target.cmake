# What every target of ours has in common: warnings as errors, and the sanitizers where a preset asks for them.
# -Wrestrict, -Wstringop-overflow and -Warray-bounds are off: GCC 12 sees overlaps and endless copies in std::string's operator+ that
# aren't there (GCC bug 105651), and from a precompiled header it reports them too. clang-tidy and the sanitizers look for real ones.
function(dermis_target name)
  target_compile_options(${name} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds;-Werror>)
  if(DERMIS_SANITIZE)
    # Instrumented code looks uninitialised to GCC where it isn't (std::regex), as its manual says.
    target_compile_options(${name} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wno-maybe-uninitialized;-fsanitize=${DERMIS_SANITIZE};-fno-omit-frame-pointer;-fno-sanitize-recover=all>)
    target_link_options(${name} PRIVATE -fsanitize=${DERMIS_SANITIZE})
  endif()
endfunction()
