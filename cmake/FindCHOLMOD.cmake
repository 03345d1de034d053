# Sparse Cholesky of SuiteSparse; it ships no CMake package on Debian. Defines CHOLMOD::CHOLMOD and CHOLMOD_VERSION.
include(FindPackageHandleStandardArgs)

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

# The version stands in cholmod_core.h before SuiteSparse 6 and in cholmod.h since.
set(CHOLMOD_VERSION "")
foreach(header cholmod_core.h cholmod.h)
  if(CHOLMOD_INCLUDE_DIR AND NOT CHOLMOD_VERSION AND EXISTS "${CHOLMOD_INCLUDE_DIR}/${header}")
    file(STRINGS "${CHOLMOD_INCLUDE_DIR}/${header}" lines REGEX "#define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION +[0-9]+")
    string(REGEX MATCHALL "[0-9]+" numbers "${lines}")
    list(JOIN numbers "." CHOLMOD_VERSION)
  endif()
endforeach()

find_package_handle_standard_args(CHOLMOD
  REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR
  VERSION_VAR CHOLMOD_VERSION)

if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
  add_library(CHOLMOD::CHOLMOD UNKNOWN IMPORTED)
  set_target_properties(CHOLMOD::CHOLMOD PROPERTIES
    IMPORTED_LOCATION "${CHOLMOD_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}")
endif()
