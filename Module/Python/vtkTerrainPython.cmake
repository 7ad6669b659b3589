# Decides whether the module is wrapped for Python. Sets vtkTerrain_wrap_python; if it is on, then also
# Python3_EXECUTABLE, to an interpreter that imports VTK in the version that the module is built with.
set(VTKTERRAIN_WRAP_PYTHON AUTO CACHE STRING
  "Make the Python package vtkterrain: ON, OFF, or AUTO where all that it takes is found")
set_property(CACHE VTKTERRAIN_WRAP_PYTHON PROPERTY STRINGS AUTO ON OFF)

# Sets the variable named by result to why an interpreter cannot use the module; empty if it can.
# pip builds with a PYTHONPATH that hides installed packages: what -E does without is tried as well.
function (vtkterrain_why_not_interpreter interpreter result)
  set(failure ON)
  foreach (option IN ITEMS -B -E)
    if (failure)
      execute_process(
        COMMAND "${interpreter}" ${option} -c
          "import numpy; from vtkmodules.vtkCommonCore import vtkVersion; print(vtkVersion().GetVTKVersion())"
        RESULT_VARIABLE failure
        OUTPUT_VARIABLE version
        ERROR_VARIABLE error
        OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_STRIP_TRAILING_WHITESPACE)
    endif ()
  endforeach ()
  set(why_not "")
  if (failure)
    string(REGEX REPLACE ".*\n" "" error "${error}")
    set(why_not "${interpreter} cannot import VTK and numpy (${error})")
  elseif (NOT version VERSION_EQUAL VTK_VERSION)
    set(why_not "${interpreter} imports VTK ${version}, the module is built with ${VTK_VERSION}")
  endif ()
  set(${result} "${why_not}" PARENT_SCOPE)
endfunction ()

set(vtkTerrain_why_not_python "")
if (NOT VTKTERRAIN_WRAP_PYTHON)
  set(vtkTerrain_why_not_python "VTKTERRAIN_WRAP_PYTHON is off")
elseif (NOT BUILD_SHARED_LIBS)
  set(vtkTerrain_why_not_python "it takes shared libraries (BUILD_SHARED_LIBS)")
elseif (NOT COMMAND vtk_module_wrap_python OR
    NOT (TARGET VTK::WrapPython OR TARGET VTKCompileTools::WrapPython))
  set(vtkTerrain_why_not_python
    "the VTK in ${VTK_DIR} has no tools for wrapping; an SDK of VTK that was built with VTK_WRAP_PYTHON has them (Debian: libvtk9-dev, python3-vtk9)")
endif ()

# The first of these that imports the right VTK: on Debian, python3 in the path may be another one
# than that of the package python3-vtk9.
if (NOT vtkTerrain_why_not_python AND NOT Python3_EXECUTABLE)
  set(why_not_any "")
  foreach (interpreter IN ITEMS python3 /usr/bin/python3)
    find_program(vtkTerrain_python_candidate "${interpreter}")
    if (NOT Python3_EXECUTABLE AND vtkTerrain_python_candidate)
      vtkterrain_why_not_interpreter("${vtkTerrain_python_candidate}" why_not)
      if (NOT why_not)
        set(Python3_EXECUTABLE "${vtkTerrain_python_candidate}" CACHE FILEPATH "Python interpreter")
      endif ()
      list(APPEND why_not_any "${why_not}")
    endif ()
    unset(vtkTerrain_python_candidate CACHE)
  endforeach ()
  if (NOT Python3_EXECUTABLE)
    list(JOIN why_not_any "; " vtkTerrain_why_not_python)
  endif ()
elseif (NOT vtkTerrain_why_not_python)
  vtkterrain_why_not_interpreter("${Python3_EXECUTABLE}" vtkTerrain_why_not_python)
endif ()
if (NOT vtkTerrain_why_not_python)
  find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
  if (NOT Python3_FOUND)
    set(vtkTerrain_why_not_python
      "the headers of ${Python3_EXECUTABLE} are missing (Debian: python3-dev)")
  endif ()
endif ()

set(vtkTerrain_wrap_python ON)
if (vtkTerrain_why_not_python)
  set(vtkTerrain_wrap_python OFF)
  if (VTKTERRAIN_WRAP_PYTHON AND NOT VTKTERRAIN_WRAP_PYTHON STREQUAL "AUTO")
    message(FATAL_ERROR "vtkTerrain cannot be wrapped for Python: ${vtkTerrain_why_not_python}")
  endif ()
  message(STATUS "Not wrapped for Python: ${vtkTerrain_why_not_python}")
else ()
  message(STATUS "Wrapped for Python: ${Python3_EXECUTABLE}")
  find_package(VTK REQUIRED COMPONENTS Python WrappingPythonCore)
endif ()
