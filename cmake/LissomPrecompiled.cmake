# Headers that nearly every source sees, read once: half of what a source costs to compile is Eigen and the standard
# library. Sources include what they use all the same; tools/lint.py compiles without precompiled headers and sees it.
# CMAKE_DISABLE_PRECOMPILE_HEADERS=ON turns them off.

set(lissom_common_headers
  <Eigen/Cholesky> <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/LU> <Eigen/SparseCore>
  <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numbers> <optional> <set> <span> <string>
  <variant> <vector> <fmt/format.h>)

# What every user of precompiled headers and the headers themselves have to agree on.
function(lissom_precompiled_base target)
  lissom_flags(${target})
  target_link_libraries(${target} PRIVATE fmt::fmt)
endfunction()

# lissom_add_precompiled(NAME HEADERS <...> LINK <...>): a set of precompiled headers for the targets that link the same things.
function(lissom_add_precompiled name)
  cmake_parse_arguments(set "" "" "HEADERS;LINK" ${ARGN})
  set(source "${PROJECT_BINARY_DIR}/generated/${name}.cpp")
  if(NOT EXISTS "${source}")
    file(WRITE "${source}" "// A set of precompiled headers needs a target with a source.\n")
  endif()
  add_library(${name} OBJECT EXCLUDE_FROM_ALL "${source}")
  target_link_libraries(${name} PRIVATE ${set_LINK})
  target_compile_features(${name} PRIVATE cxx_std_20)
  lissom_precompiled_base(${name})
  target_precompile_headers(${name} PRIVATE ${set_HEADERS})
endfunction()

# Flags of our own targets, and the precompiled headers NAME.
function(lissom_own target name)
  lissom_precompiled_base(${target})
  target_precompile_headers(${target} REUSE_FROM ${name})
endfunction()
