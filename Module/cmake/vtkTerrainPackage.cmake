# The installed CMake package: find_package(vtkTerrain) gives the target vtkTerrain::Terrain.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/vtkTerrain")
set(package_build_dir "${PROJECT_BINARY_DIR}/module/${package_dir}")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/vtkTerrainConfig.cmake.in"
  "${package_build_dir}/vtkTerrainConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(
  "${package_build_dir}/vtkTerrainConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(FILES
    "${package_build_dir}/vtkTerrainConfig.cmake"
    "${package_build_dir}/vtkTerrainConfigVersion.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindGeographicLib.cmake"
  DESTINATION "${package_dir}")
