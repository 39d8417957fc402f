# What every target of carom is compiled with: the floating-point contract and the warnings.

# No contraction and no fast-math: each operation is rounded once, as written. Public, because the headers hold the arithmetic.
function(carom_floating_point_contract target)
  target_compile_options(${target} PUBLIC -ffp-contract=off)
  target_compile_definitions(${target} PUBLIC $<$<CONFIG:Debug,RelWithDebInfo>:CAROM_CHECKS>)
endfunction()

# Not -Wmaybe-uninitialized, -Wrestrict: g++ 12 reports them wrongly inside <regex>, Boost's cpp_int and std::string.
function(carom_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${CAROM_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
