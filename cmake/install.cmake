# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
include(GNUInstallDirs)

install(TARGETS scan_to_path_core LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS scan_to_path_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/scan_to_path DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${CMAKE_BINARY_DIR}/include/scan_to_path/common/version.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scan_to_path/common)
install(DIRECTORY config urdf DESTINATION ${CMAKE_INSTALL_DATADIR}/scan_to_path)
set_target_properties(scan_to_path_cli PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

if(WITH_ROS)
  # Where roslaunch, pluginlib and rosrun look for them.
  install(TARGETS scan_to_path_ros scan_to_path_nodelets scan_to_path_rviz LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  install(TARGETS scan_to_path_run_job RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  install(FILES nodelet_plugins.xml rviz_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
  install(DIRECTORY launch rviz DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
  install(DIRECTORY include/scan_to_path_ros DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  set_target_properties(scan_to_path_run_job PROPERTIES INSTALL_RPATH "$ORIGIN/../../${CMAKE_INSTALL_LIBDIR}")
  set_target_properties(scan_to_path_ros scan_to_path_nodelets scan_to_path_rviz PROPERTIES
                        INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif()
