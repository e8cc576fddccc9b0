# What every target of ours has in common: warnings as errors, and the sanitizers where a preset asks for them.
# -Wrestrict is off: GCC 12 sees overlaps in std::string's operator+ that aren't there (GCC bug 105651).
function(dermis_target name)
  target_compile_options(${name} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wno-restrict;-Werror>)
  if(DERMIS_SANITIZE)
    target_compile_options(${name} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${DERMIS_SANITIZE};-fno-omit-frame-pointer;-fno-sanitize-recover=all>)
    target_link_options(${name} PRIVATE -fsanitize=${DERMIS_SANITIZE})
  endif()
endfunction()
