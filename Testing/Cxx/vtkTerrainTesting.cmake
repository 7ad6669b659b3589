# vtkterrain_add_test: see CMakeLists.txt beside this file.
set(vtkTerrain_test_modules "${vtkTerrain_vtk_components};${vtkTerrain_vtk_test_components}")
list(TRANSFORM vtkTerrain_test_modules PREPEND "VTK::")

# What tests share: the header vtkTerrainTesting.h, and main.
add_library(vtkTerrainTestSupport STATIC
  vtkTerrainTesting.cxx
  vtkTerrainTestingMain.cxx
  vtkTerrainTestingScene.cxx
  vtkTerrainTestingShader.cxx)
target_include_directories(vtkTerrainTestSupport PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(vtkTerrainTestSupport
  PUBLIC
    vtkTerrain::Terrain
    ${vtkTerrain_test_modules}
    GTest::gtest
  PRIVATE
    vtkTerrainWarnings
    ${CMAKE_DL_LIBS})
if (VTK_VERSION VERSION_LESS 9.4) # Since then the functions of OpenGL come with VTK::glad.
  target_link_libraries(vtkTerrainTestSupport PUBLIC OpenGL::OpenGL)
endif ()

function (vtkterrain_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "CORE;IMAGE;DATA" "" "WINDOWS")
  add_executable(${name} ${name}.cxx)
  target_link_libraries(${name} PRIVATE
    vtkTerrainTestSupport vtkTerrainWarnings
    GDAL::GDAL GeographicLib::GeographicLib glm::glm)
  if (arg_CORE)
    target_link_libraries(${name} PRIVATE vtkTerrainCore)
  endif ()
  vtk_module_autoinit(TARGETS ${name} MODULES ${vtkTerrain_test_modules})
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
