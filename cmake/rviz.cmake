# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0

# The displays and the panel, as plugins of rviz.
find_package(rviz REQUIRED)
find_package(Qt5 REQUIRED COMPONENTS Widgets)

scan_to_path_ros_library(scan_to_path_rviz rviz LINK scan_to_path_ros Qt5::Widgets ${rviz_LIBRARIES})
target_include_directories(scan_to_path_rviz PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_include_directories(scan_to_path_rviz SYSTEM PUBLIC ${rviz_INCLUDE_DIRS})
# ROS has names that Qt's keywords would turn into something else.
target_compile_definitions(scan_to_path_rviz PUBLIC QT_NO_KEYWORDS)
# rviz names all of OGRE and OpenGL; a program without a screen brings its own OpenGL.
target_link_options(scan_to_path_rviz PRIVATE LINKER:--as-needed,--no-undefined)
