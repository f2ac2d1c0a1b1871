# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0

# Pictures of what rviz shows, without a screen, and the data of the figures.
find_package(Qt5 REQUIRED COMPONENTS Core Gui Widgets)
find_package(rviz REQUIRED)
find_library(OSMESA_LIBRARY OSMesa REQUIRED)

# rviz draws through OGRE, which speaks only to GLX and Xlib: the executable brings both, on top of OSMesa. OSMesa comes
# first on the link line, so that every library's OpenGL is OSMesa's; symbols are exported for OGRE's render system,
# which is a plugin. rviz_LIBRARIES names OpenGL's own library too, but only behind it.
file(GLOB snapshot_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/tools/snapshot/*.cpp)
add_executable(scan_to_path_snapshot ${snapshot_sources})
set_target_properties(scan_to_path_snapshot PROPERTIES OUTPUT_NAME snapshot ENABLE_EXPORTS ON)
target_include_directories(scan_to_path_snapshot PRIVATE ${PROJECT_SOURCE_DIR}/include)
target_include_directories(scan_to_path_snapshot SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${rviz_INCLUDE_DIRS} /usr/include/OGRE)
target_compile_definitions(scan_to_path_snapshot PRIVATE QT_NO_KEYWORDS)
target_link_libraries(scan_to_path_snapshot PRIVATE -Wl,--no-as-needed ${OSMESA_LIBRARY} -Wl,--as-needed
                      ${rviz_LIBRARIES} ${roscpp_LIBRARIES} Qt5::Widgets CLI11::CLI11 ${CMAKE_DL_LIBS})

# What the figures show, as standard messages. PCL is what their normals are compared with.
file(GLOB figure_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/tools/figures/*.cpp)
add_executable(scan_to_path_figure_scene ${figure_sources} src/tools/emulated_world.cpp)
set_target_properties(scan_to_path_figure_scene PROPERTIES OUTPUT_NAME figure_scene)
target_include_directories(scan_to_path_figure_scene PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(scan_to_path_figure_scene PRIVATE scan_to_path_ros)

install(TARGETS scan_to_path_snapshot RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS scan_to_path_figure_scene RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
