# vtkterrain_add_test: see CMakeLists.txt beside this file.
set(vtkTerrain_test_modules "${vtkTerrain_vtk_components};${vtkTerrain_vtk_test_components}")
list(TRANSFORM vtkTerrain_test_modules PREPEND "VTK::")

# What tests share: the header vtkTerrainTesting.h, and main.
add_library(vtkTerrainTestSupport STATIC
  vtkTerrainTesting.cxx
  vtkTerrainTestingGL.cxx
  vtkTerrainTestingMain.cxx
  vtkTerrainTestingScene.cxx
  vtkTerrainTestingShader.cxx)
target_include_directories(vtkTerrainTestSupport
  PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}"
  PRIVATE "${PROJECT_SOURCE_DIR}/src")
target_compile_definitions(vtkTerrainTestSupport PUBLIC # as all that is precompiled
  VTKTERRAIN_SHADER_DIR="${PROJECT_SOURCE_DIR}/shaders")
target_link_libraries(vtkTerrainTestSupport
  PUBLIC
    vtkTerrain::Terrain
    ${vtkTerrain_test_modules}
    GTest::gtest
  PRIVATE
    vtkTerrainWarnings
    ${CMAKE_DL_LIBS})
# What nearly every test includes takes longer to read than the test itself; the same definitions are
# needed wherever it is used.
vtk_module_autoinit(TARGETS vtkTerrainTestSupport MODULES ${vtkTerrain_test_modules})
target_precompile_headers(vtkTerrainTestSupport PRIVATE
  <gtest/gtest.h> <glm/glm.hpp> <algorithm> <cmath> <functional> <random> <string> <vector>
  <vtkActor.h> <vtkCamera.h> <vtkDoubleArray.h> <vtkFloatArray.h> <vtkImageData.h> <vtkNew.h>
  <vtkOpenGLPolyDataMapper.h> <vtkOpenGLRenderWindow.h> <vtkPointData.h> <vtkPolyData.h>
  <vtkProperty.h> <vtkRenderer.h> <vtkSmartPointer.h>)
if (VTK_VERSION VERSION_LESS 9.4) # Since then the functions of OpenGL come with VTK::glad.
  target_link_libraries(vtkTerrainTestSupport PUBLIC OpenGL::OpenGL)
endif ()

function (vtkterrain_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "CORE;IMAGE;DATA;OPTIMIZED;DRIVER" "" "WINDOWS")
  add_executable(${name} ${name}.cxx)
  target_link_libraries(${name} PRIVATE
    vtkTerrainTestSupport vtkTerrainWarnings
    GDAL::GDAL GeographicLib::GeographicLib glm::glm)
  if (arg_CORE)
    target_link_libraries(${name} PRIVATE vtkTerrainCore)
  endif ()
  target_precompile_headers(${name} REUSE_FROM vtkTerrainTestSupport)
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
  # Of what most of these tests take, Mesa's compiler takes most: a third to a half less so.
  if (NOT arg_OPTIMIZED)
    list(APPEND environment "GALLIVM_PERF=nopt")
  endif ()
  foreach (window IN LISTS arg_WINDOWS)
    add_test(NAME ${name}-${window} COMMAND ${name})
    set_tests_properties(${name}-${window} PROPERTIES
      LABELS image SKIP_RETURN_CODE 77 TIMEOUT 300
      ENVIRONMENT "${environment};VTK_DEFAULT_OPENGL_WINDOW=${class_${window}}")
  endforeach ()
  if (arg_DRIVER) # llvmpipe's filter takes wrong texels where it is anisotropic
    add_test(NAME ${name}-driver COMMAND ${name})
    set_tests_properties(${name}-driver PROPERTIES
      LABELS driver SKIP_RETURN_CODE 77 TIMEOUT 300
      ENVIRONMENT "${environment};VTK_DEFAULT_OPENGL_WINDOW=${class_egl};VTKTERRAIN_DRIVER=graphics,isotropic,fetch")
  endif ()
endfunction ()
