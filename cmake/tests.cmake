# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0

# Tests spend their time in the library; compiling them fast matters more than running their own code fast.
set(TEST_OPTIONS -O1)
file(WRITE ${CMAKE_BINARY_DIR}/precompiled_tests.cpp "int main() {}\n")
add_executable(scan_to_path_precompiled_tests ${CMAKE_BINARY_DIR}/precompiled_tests.cpp)
target_compile_options(scan_to_path_precompiled_tests PRIVATE ${TEST_OPTIONS})
target_compile_definitions(scan_to_path_precompiled_tests PRIVATE SCAN_TO_PATH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(scan_to_path_precompiled_tests PRIVATE Eigen3::Eigen GTest::gmock)
target_precompile_headers(scan_to_path_precompiled_tests PRIVATE
                          <algorithm> <cmath> <functional> <optional> <string> <vector> <Eigen/Geometry> <gmock/gmock.h>)

# scan_to_path_test(NAME SOURCES file… [LINK target…] [LABELS label…]): a GoogleTest executable, registered with ctest.
function(scan_to_path_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINK;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  scan_to_path_join_sources(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_options(${name} PRIVATE ${TEST_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM scan_to_path_precompiled_tests)
  target_compile_definitions(${name} PRIVATE SCAN_TO_PATH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
endfunction()

# PCL's features and trees: an oracle in tests, a rival in benchmarks. By name: find_package(PCL COMPONENTS features)
# brings VTK and MPI along.
add_library(scan_to_path_pcl_oracle INTERFACE)
foreach(library features search kdtree common)
  find_library(PCL_${library} pcl_${library} REQUIRED)
  target_link_libraries(scan_to_path_pcl_oracle INTERFACE ${PCL_${library}})
endforeach()
target_link_libraries(scan_to_path_pcl_oracle INTERFACE scan_to_path_pcl lz4)
