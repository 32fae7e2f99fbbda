# SPDX-License-Identifier: GPL-3.0-or-later
# A capability is a folder; this file turns the folder into a library and its tests into a program.

# The system's headers that nearly every source reads are parsed once, in the lowest room; once more,
# with the testing library's, for the tests. Sources still include what they use: tests/lint sees to it.
set(common_headers <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional>
                   <limits> <map> <memory> <optional> <set> <span> <string> <string_view> <variant>
                   <vector> <fmt/format.h> <glm/glm.hpp>)
set(test_headers ${common_headers} <gmock/gmock.h> <gtest/gtest.h>)
# Neighbours of a room are compiled twenty at a time: they share the templates of their headers, which
# halves a clean build. A name in an anonymous namespace is therefore the only one of its room.
# -DCMAKE_UNITY_BUILD=OFF compiles each alone, as the style checks want it.
option(CMAKE_UNITY_BUILD "compile several sources at once" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 20)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # A class of a source may have a member of that source's own; said wrongly of several together.
  add_compile_options(-Wno-subobject-linkage)
endif()
# A test runs once a build: what -O2 would gain in running it loses in compiling.
set(test_options -O1)

# trivar_room(NAME DEPENDS lib...): every .cpp of the current folder becomes the library trivar_NAME.
# PUBLIC names what includers of its headers need, DEPENDS what only its sources need. HEADERS are
# its own that nearly all of its sources read: they are precompiled for it, beside the system's. A LIGHT
# room leaves what is slow to those below: -O1 compiles it in three quarters of the time.
function(trivar_room name)
  cmake_parse_arguments(ROOM "LIGHT" "" "PUBLIC;DEPENDS;SUBFOLDERS;HEADERS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp *.h)
  foreach(folder ${ROOM_SUBFOLDERS})
    file(GLOB more CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.h)
    list(APPEND sources ${more})
  endforeach()
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  add_library(trivar_${name} STATIC ${sources})
  set_target_properties(trivar_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(trivar_${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(trivar_${name} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_DEPENDS})
  if(ROOM_LIGHT)
    target_compile_options(trivar_${name} PRIVATE -O1)
  endif()
  if(name STREQUAL base)
    target_precompile_headers(trivar_base PRIVATE ${common_headers})
  elseif(name STREQUAL test_support)
    target_precompile_headers(trivar_test_support PRIVATE ${test_headers})
    target_compile_options(trivar_test_support PRIVATE ${test_options})
  elseif(ROOM_HEADERS)
    target_precompile_headers(trivar_${name} PRIVATE ${common_headers} ${ROOM_HEADERS})
  else()
    target_precompile_headers(trivar_${name} REUSE_FROM trivar_base)
  endif()
endfunction()

# trivar_tests(NAME LIBRARIES lib...): every .cpp of tests/NAME and of its folders becomes one
# program, found by ctest test by test.
function(trivar_tests name)
  cmake_parse_arguments(ROOM "" "" "LIBRARIES;HEADERS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp
       ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_test ${sources})
  target_include_directories(${name}_test PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name}_test PRIVATE ${ROOM_LIBRARIES} trivar_test_support GTest::gmock
                                             GTest::gtest_main)
  if(ROOM_HEADERS)
    target_precompile_headers(${name}_test PRIVATE ${test_headers} ${ROOM_HEADERS})
  else()
    target_precompile_headers(${name}_test REUSE_FROM trivar_test_support)
  endif()
  target_compile_options(${name}_test PRIVATE ${test_options})
  target_compile_definitions(${name}_test PRIVATE TRIVAR_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                                  TRIVAR_BINARY_DIR="${CMAKE_BINARY_DIR}")
  # Suites named RealData... want the folder of real models; they skip with a message without it.
  gtest_discover_tests(${name}_test TEST_FILTER "-RealData*" TEST_LIST ${name}_cases
                       DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                       PROPERTIES TIMEOUT 300)
  gtest_discover_tests(${name}_test TEST_FILTER "RealData*" TEST_LIST ${name}_realdata_cases
                       DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                       PROPERTIES TIMEOUT 300 LABELS realdata)
endfunction()
