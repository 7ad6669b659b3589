# Sets vtkTerrain_geographic_string_options: what compiles a source for the string ABI of GeographicLib.
# Empty if it is the one of this build; else that of libstdc++ which links. VTK's wheels use the old
# one, most packages of GeographicLib the new one.
include(CheckCXXSourceCompiles)
set(vtkTerrain_geographic_string_options "")
set(CMAKE_REQUIRED_LIBRARIES GeographicLib::GeographicLib)
set(test_source "#include <GeographicLib/GeoCoords.hpp>
#include <string>
int main(int argc, char** argv)
{
  return GeographicLib::GeoCoords(std::string(argv[argc - 1])).Zone();
}
")
check_cxx_source_compiles("${test_source}" VTKTERRAIN_SAME_STRING_ABI)
foreach (abi IN ITEMS 1 0)
  if (NOT VTKTERRAIN_SAME_STRING_ABI AND NOT vtkTerrain_geographic_string_options)
    set(CMAKE_REQUIRED_FLAGS "-U_GLIBCXX_USE_CXX11_ABI -D_GLIBCXX_USE_CXX11_ABI=${abi}")
    check_cxx_source_compiles("${test_source}" VTKTERRAIN_STRING_ABI_${abi})
    if (VTKTERRAIN_STRING_ABI_${abi})
      set(vtkTerrain_geographic_string_options
        "-U_GLIBCXX_USE_CXX11_ABI;-D_GLIBCXX_USE_CXX11_ABI=${abi}")
    endif ()
  endif ()
endforeach ()
unset(CMAKE_REQUIRED_FLAGS)
unset(CMAKE_REQUIRED_LIBRARIES)
unset(test_source)
