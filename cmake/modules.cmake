# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0

# PCL's exported targets bring VTK's flags along; the core needs only the point cloud type from its headers.
add_library(scan_to_path_pcl INTERFACE)
target_include_directories(scan_to_path_pcl SYSTEM INTERFACE ${PCL_COMMON_INCLUDE_DIRS})
target_link_libraries(scan_to_path_pcl INTERFACE Eigen3::Eigen)

# Half of what a source costs is templates that its neighbours use too. Hence names in anonymous namespaces differ within
# a module, and within its tests.
function(scan_to_path_join_sources target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${JOIN_SOURCES} UNITY_BUILD_BATCH_SIZE 16)
endfunction()

# The headers that every source includes anyway, compiled once for all modules.
file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "")
add_library(scan_to_path_precompiled STATIC ${CMAKE_BINARY_DIR}/precompiled.cpp)
target_link_libraries(scan_to_path_precompiled PRIVATE Eigen3::Eigen)
target_precompile_headers(scan_to_path_precompiled PRIVATE
                          <algorithm> <cmath> <functional> <optional> <string> <vector> <Eigen/Geometry>)

# The library's own code is checked, and only it: what the tests do around it is not worth the time. Left out is what
# costs most and finds what AddressSanitizer finds too.
set(SANITIZE_OPTIONS -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
                     -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow)
function(scan_to_path_sanitize target)
  if(SANITIZE)
    target_compile_options(${target} PRIVATE ${SANITIZE_OPTIONS})
  endif()
endfunction()
scan_to_path_sanitize(scan_to_path_precompiled)

# scan_to_path_module(NAME [USES module…] [LINK target…]): static library scan_to_path_NAME of src/NAME/*.cpp.
function(scan_to_path_module name)
  cmake_parse_arguments(ARG "" "" "USES;LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  list(TRANSFORM ARG_USES PREPEND scan_to_path_)
  if(sources)
    set(kind PUBLIC)
    add_library(scan_to_path_${name} STATIC ${sources})
    target_precompile_headers(scan_to_path_${name} REUSE_FROM scan_to_path_precompiled)
    scan_to_path_join_sources(scan_to_path_${name})
    # A static library can be made before those it uses.
    set_target_properties(scan_to_path_${name} PROPERTIES OPTIMIZE_DEPENDENCIES ON)
    scan_to_path_sanitize(scan_to_path_${name})
    set_property(GLOBAL APPEND PROPERTY scan_to_path_objects $<TARGET_OBJECTS:scan_to_path_${name}>)
  else()
    set(kind INTERFACE)
    add_library(scan_to_path_${name} INTERFACE)
  endif()
  target_include_directories(scan_to_path_${name} ${kind}
                             ${PROJECT_SOURCE_DIR}/include ${CMAKE_BINARY_DIR}/include)
  target_link_libraries(scan_to_path_${name} ${kind} ${ARG_USES} ${ARG_LINK})
  set_property(GLOBAL APPEND PROPERTY scan_to_path_links ${ARG_LINK})
endfunction()

# One shared library of all modules, for executables and nodelets.
function(scan_to_path_core_library)
  get_property(objects GLOBAL PROPERTY scan_to_path_objects)
  get_property(links GLOBAL PROPERTY scan_to_path_links)
  add_library(scan_to_path_core SHARED ${objects})
  target_include_directories(scan_to_path_core PUBLIC ${PROJECT_SOURCE_DIR}/include ${CMAKE_BINARY_DIR}/include)
  target_link_libraries(scan_to_path_core PUBLIC ${links})
  set_target_properties(scan_to_path_core PROPERTIES LINKER_LANGUAGE CXX)
endfunction()
