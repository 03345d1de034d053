# Compiler flags of our own targets; nothing here reaches a consumer. Why: docs/decisions/0001-house.md.

# Processors of 2013 and later know x86-64-v3 (AVX2, FMA); on an older one the default steps back.
set(lissom_default_arch "")
string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" lissom_processor)
if(lissom_processor MATCHES "^(x86_64|amd64)$" AND NOT MSVC)
  set(lissom_default_arch x86-64-v3)
  if(NOT CMAKE_CROSSCOMPILING)
    include(CheckCXXSourceRuns)
    check_cxx_source_runs([[
      int main() {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2") ? 0 : 1;
      }]] LISSOM_RUNS_X86_64_V3)
    if(NOT LISSOM_RUNS_X86_64_V3)
      set(lissom_default_arch "")
    endif()
  endif()
endif()
set(LISSOM_ARCH "${lissom_default_arch}" CACHE STRING "Value of -march; empty: the compiler's default; native: this machine")
set(LISSOM_SANITIZE "" CACHE STRING "Value of -fsanitize, for example address,undefined; empty: none")
option(LISSOM_WERROR "Treat warnings in lissom's own sources as errors" ${PROJECT_IS_TOP_LEVEL})

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
if(MSVC)
  set(CMAKE_CXX_FLAGS_RELEASE "/O2 /DNDEBUG")
endif()

function(lissom_flags target)
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4 /permissive- /fp:precise $<$<BOOL:${LISSOM_WERROR}>:/WX>)
    return()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
    # False alarms of GCC 12: vector loads of Vector3d, and text + std::string (its bug 105329, under two names).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds> $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
    $<$<BOOL:${LISSOM_WERROR}>:-Werror>
    # Square roots and the like as instructions: nothing looks at errno.
    -fno-math-errno
    -ffp-contract=off)
  if(LISSOM_ARCH)
    target_compile_options(${target} PRIVATE -march=${LISSOM_ARCH})
  endif()
  if(LISSOM_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${LISSOM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # A check at every access for what the address sanitizer sees anyway; without them the build takes 40 % less.
    if(LISSOM_SANITIZE MATCHES "address" AND LISSOM_SANITIZE MATCHES "undefined")
      target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,object-size)
    endif()
    target_link_options(${target} PRIVATE -fsanitize=${LISSOM_SANITIZE})
  endif()
endfunction()
