# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0

# Message names in the order of the alphabet, as the folders have them.
function(scan_to_path_names variable folder extension)
  file(GLOB files RELATIVE ${PROJECT_SOURCE_DIR}/${folder} CONFIGURE_DEPENDS
       ${PROJECT_SOURCE_DIR}/${folder}/*.${extension})
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

scan_to_path_names(messages msg msg)
scan_to_path_names(actions action action)
add_message_files(DIRECTORY msg FILES ${messages})
add_action_files(DIRECTORY action FILES ${actions})
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs std_msgs)

catkin_package(INCLUDE_DIRS include LIBRARIES scan_to_path_core scan_to_path_ros
               CATKIN_DEPENDS actionlib_msgs geometry_msgs message_runtime roscpp std_msgs trajectory_msgs)

# ROS headers warn under our options.
add_library(scan_to_path_catkin INTERFACE)
target_include_directories(scan_to_path_catkin SYSTEM INTERFACE ${catkin_INCLUDE_DIRS})
target_link_libraries(scan_to_path_catkin INTERFACE ${catkin_LIBRARIES})

# scan_to_path_ros_library(NAME FOLDER [LINK target…]): shared library of src/FOLDER/*.cpp on top of the core.
function(scan_to_path_ros_library name folder)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp)
  add_library(${name} SHARED ${sources})
  add_dependencies(${name} ${PROJECT_NAME}_generate_messages_cpp)
  target_link_libraries(${name} PUBLIC scan_to_path_core scan_to_path_catkin ${ARG_LINK})
  scan_to_path_join_sources(${name})
endfunction()

scan_to_path_ros_library(scan_to_path_ros ros)
scan_to_path_ros_library(scan_to_path_nodelets nodelets LINK scan_to_path_ros)
# The emulator scans what the command line's emulate scans.
target_sources(scan_to_path_nodelets PRIVATE ${PROJECT_SOURCE_DIR}/src/tools/emulated_world.cpp)
target_include_directories(scan_to_path_nodelets PRIVATE ${PROJECT_SOURCE_DIR}/src)

file(GLOB run_job_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/tools/run_job/*.cpp)
add_executable(scan_to_path_run_job ${run_job_sources} src/tools/progress_bar.cpp)
set_target_properties(scan_to_path_run_job PROPERTIES OUTPUT_NAME run_job)
target_include_directories(scan_to_path_run_job PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(scan_to_path_run_job PRIVATE scan_to_path_ros CLI11::CLI11)
