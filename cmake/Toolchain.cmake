# SPDX-License-Identifier: GPL-3.0-or-later
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "" FORCE)
endif()
# Asserts stay on: they guard our own bugs. -g1 keeps symbols and lines at a third of the link time.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1")

set(TRIVAR_SANITIZE "" CACHE STRING "sanitizers to build with: address,undefined or thread")
# Contraction would let the compiler fuse a*b+c at will, so that bits differ between compilers.
# Only g++'s warnings are errors: clang has others, and in a unity build names those that one source hides
# of another.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast
                    $<$<CXX_COMPILER_ID:GNU>:-Werror> -ffp-contract=off)
if(TRIVAR_SANITIZE)
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1") # finds the same, and builds in half the time
  add_compile_options(-fsanitize=${TRIVAR_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TRIVAR_SANITIZE})
  # Between the sanitizers' checks clang cannot unroll what it is asked to.
  add_compile_options($<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>)
  # The sanitizers' extra branches make g++ 12 see paths that do not exist.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # It breaks down with them where it propagates constants between functions of some files.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-ipa-cp>)
endif()

# Collecting its garbage from the first gigabyte on, not from 128 MiB, takes g++ a tenth of its time
# away. A job may then hold 1.7 GB.
cmake_host_system_information(RESULT memory_mib QUERY TOTAL_PHYSICAL_MEMORY)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR memory_mib_each "${memory_mib} / ${cores}")
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND memory_mib_each GREATER 2500)
  add_compile_options("SHELL:--param ggc-min-heapsize=1048576")
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # ccache's manual asks for this where headers are precompiled.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                      "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
  # The key is the files that were read (depend mode), never preprocessed text: that names the
  # former precompiled header where there is one, so that a changed header could be given another
  # tree's.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1 ${CCACHE})
endif()
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()

option(TRIVAR_FUZZ "build the fuzzers (clang only)" OFF)
if(TRIVAR_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
