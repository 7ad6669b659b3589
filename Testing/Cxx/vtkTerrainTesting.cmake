# vtkterrain_add_test: see CMakeLists.txt beside this file.
function (vtkterrain_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "IMAGE;DATA" "" "WINDOWS")
  add_executable(${name} ${name}.cxx)
  target_link_libraries(${name} PRIVATE
    vtkTerrain::Terrain vtkTerrainWarnings GDAL::GDAL GTest::gtest_main ${vtkTerrain_test_libraries})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/Testing/Cxx")
  set(environment
    "VTKTERRAIN_DATA_DIR=${VTKTERRAIN_DATA_DIR}"
    "VTKTERRAIN_BASELINE_DIR=${PROJECT_SOURCE_DIR}/Testing/Data/Baseline"
    "VTKTERRAIN_TEST_OUTPUT_DIR=${PROJECT_BINARY_DIR}/Testing/Temporary")
  if (NOT arg_IMAGE)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES
      LABELS pipeline SKIP_RETURN_CODE 77 TIMEOUT 300 ENVIRONMENT "${environment}")
    return()
  endif ()
  if (NOT arg_WINDOWS)
    set(arg_WINDOWS egl osmesa)
  endif ()
  set(class_egl vtkEGLRenderWindow)
  set(class_osmesa vtkOSOpenGLRenderWindow)
  foreach (window IN LISTS arg_WINDOWS)
    add_test(NAME ${name}-${window} COMMAND ${name})
    set_tests_properties(${name}-${window} PROPERTIES
      LABELS image SKIP_RETURN_CODE 77 TIMEOUT 300
      ENVIRONMENT "${environment};VTK_DEFAULT_OPENGL_WINDOW=${class_${window}}")
  endforeach ()
endfunction ()
