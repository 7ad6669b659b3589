# The module's contents and its target. Lists are sorted; one line a file.
include("${VTK_DIR}/vtkEncodeString.cmake")
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)

set(classes
  vtkOpenGLTerrainMapper
  vtkTerrainActor
  vtkTerrainCoarseMesh
  vtkTerrainColors
  vtkTerrainDepthPass
  vtkTerrainDetailSource
  vtkTerrainDrape
  vtkTerrainGeoTransform
  vtkTerrainGeoid
  vtkTerrainGeoreference
  vtkTerrainGlobe
  vtkTerrainGraticule
  vtkTerrainHierarchy
  vtkTerrainHorizon
  vtkTerrainImageWarp
  vtkTerrainLook
  vtkTerrainMesh
  vtkTerrainMinMaxPyramid
  vtkTerrainOutputFile
  vtkTerrainPeaks
  vtkTerrainPicker
  vtkTerrainRasterReader
  vtkTerrainReproject
  vtkTerrainScaleBar
  vtkTerrainSource
  vtkTerrainStrips
  vtkTerrainValues
  vtkTerrainViewpoint
  vtkTerrainViewshed
)

# Private to the module: one line a file, by rooms.
set(private_sources
  data/ColorDocument
  data/ColorPresets
  data/GlobePaths
  data/GlobeSurface
  data/HierarchyHeights
  data/ImageSurface
  data/MeshOutput
  data/ObserverPlaces
  data/PathBuilder
  data/StripsOutput
  parts/ActorInput
  parts/ActorRelief
  parts/ActorSurface
  parts/AssemblyPart
  parts/ColorsOfRaster
  parts/DrapePicture
  parts/MapperExtract
  parts/RasterReaderLevels
  place/GeoreferencePrepare
  place/GlobeHeights
  place/GroundPlaces
  place/ImageWarp
  place/PlacedRaster
  place/ReprojectPlan
  raster/CoordinateSystem
  raster/FolderFiles
  raster/GDALTable
  raster/GridCoordinates
  raster/GridResample
  raster/HeldFiles
  raster/InputFiles
  raster/PointText
  raster/PreparedFile
  raster/RasterArray
  raster/RasterBeside
  raster/RasterFile
  raster/RasterHeights
  raster/RasterHoles
  raster/RasterIntake
  raster/RasterMask
  raster/RasterMessages
  raster/RasterOpen
  raster/RasterPiece
  raster/RasterPlace
  raster/RasterRecord
  raster/RasterReference
  raster/RasterRemedies
  raster/RasterRepairs
  raster/RasterSanity
  raster/RasterSamples
  raster/RasterTile
  raster/RasterTileAlone
  raster/RasterTileRead
  raster/RasterTileSource
  raster/RasterTiles
  raster/RasterUnits
  raster/ReaderPlan
  raster/SystemAxes
  raster/TileOverlaps
  render/ComputeProgram
  render/ComputeTexture
  render/DetailTexture
  render/Driver
  render/Features
  render/Globe
  render/ModelCamera
  render/Lights
  render/Paint
  render/Prepass
  render/ProgramGuard
  render/Proxy
  render/PyramidTexture
  render/Scene
  render/ShaderText
  render/ShadowBoundsTexture
  render/SkyTexture
  render/SlopeTexture
  render/SurfaceProgram
  render/SurfaceTextures
  render/Technique
  render/TileTextures
  render/UniformPasser
  render/View
)

set(private_headers
)

# Windows without a display; VTK 9.4 and later have their own.
set(window_libraries "")
if (VTK_VERSION VERSION_LESS 9.4)
  set(window_libraries OpenGL::EGL OpenGL::OpenGL ${CMAKE_DL_LIBS})
  list(APPEND classes
    vtkTerrainEGLRenderWindow
    vtkTerrainOSMesaRenderWindow
    vtkTerrainOffscreenRenderWindow
    vtkTerrainRenderWindowFactory)
  list(APPEND private_sources
    windows/EGLContext
    windows/GLContext
    windows/OSMesaContext)
endif ()

set(shaders
  vtkTerrainBeam
  vtkTerrainBeamCS
  vtkTerrainCast
  vtkTerrainColor
  vtkTerrainColumns
  vtkTerrainDistance
  vtkTerrainGlobeLines
  vtkTerrainGlobeTrace
  vtkTerrainGradient
  vtkTerrainHeights
  vtkTerrainLight
  vtkTerrainLightCS
  vtkTerrainOutlook
  vtkTerrainPyramid
  vtkTerrainRay
  vtkTerrainSearch
  vtkTerrainSighting
  vtkTerrainSightingCS
  vtkTerrainSky
  vtkTerrainSurface
  vtkTerrainTileTrace
  vtkTerrainTiles
  vtkTerrainTrace
  vtkTerrainView
)

# VTK-free algorithms: an object library, so that the unit tests link it without the module.
set(core
  colors/ColorFile
  colors/ColorScheme
  colors/ColorText
  files/OutputFile
  globe/GlobeAnchor
  globe/GlobeGrid
  globe/GlobeReference
  grid/HeightUnits
  grid/Relief
  grid/RoundNumbers
  landscape/DetailNoise
  landscape/ProceduralTerrain
  landscape/StreamErosion
  mesh/CoarseMesh
  mesh/CoarseMeshSurface
  mesh/GreedyMesh
  mesh/GreedyTile
  mesh/MeshError
  place/Ellipsoid
  place/Geodesics
  place/GeographicText
  place/GeoidGrid
  place/GridReference
  place/SceneFrame
  place/SunPosition
  rays/HeightSearch
  rays/Horizon
  rays/LaneKernels
  rays/LaneKernelsPlain
  rays/PixelRays
  rays/QueryWalk
  rays/RayPackets
  rays/RayQuery
  rays/ReferenceRayCaster
  rays/Viewshed
  strips/BaseSteepness
  strips/DetailHierarchy
  strips/HierarchyBands
  strips/HierarchyBuild
  strips/HierarchyFile
  strips/HierarchyLayout
  strips/HierarchyNesting
  strips/HierarchyTile
  strips/MappedFile
  strips/Refinement
  strips/RefinementInput
  strips/RefinementPlain
  strips/RefinementSelection
  surface/HeightSlopes
  surface/LevelSamples
  surface/MemoryTiles
  surface/MinMaxPyramid
  surface/Peaks
  surface/PreparedTiles
  surface/RepeatedTiles
  surface/TileFile
  surface/TileFileWrite
  surface/TilePool
  surface/TilePyramid
  surface/TileReduction
  surface/TileResidency
  surface/TileSelection
  surface/TileTail
)
# Their results are the same bits on every machine: no fused multiply-add.
set(core_without_contraction
  landscape/DetailNoise
  landscape/ProceduralTerrain
  landscape/StreamErosion
)
# Loops that are compiled for kinds of processors and chosen at run time (core/rays/LaneKernels.h).
set(core_lanes_options -O3 -ffp-contract=off -fno-math-errno)
set(core_lanes_avx2_options -mavx2)
set(core_lanes_avx512_options -mavx512f -mprefer-vector-width=512)
# Its procedures recurse with triangles of a few numbers, which are slower gathered in vectors.
set(core_without_vectors
  strips/Refinement
)
# They pass std::string to GeographicLib, and are compiled for its string ABI.
set(core_with_geographic_strings
  place/GeographicText
  place/GeoidGrid
)

set(sources ${private_sources})
list(TRANSFORM sources APPEND ".cxx")
foreach (shader IN LISTS shaders)
  vtk_encode_string(INPUT "${root}/shaders/${shader}.glsl"
    HEADER_OUTPUT header SOURCE_OUTPUT source)
  list(APPEND sources "${source}")
  list(APPEND private_headers "${header}")
endforeach ()

set(has_lanes_x86 OFF)
if (CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(has_lanes_x86 ON)
  list(APPEND core rays/LaneKernelsAvx2 rays/LaneKernelsAvx512)
endif ()

if (core)
  list(TRANSFORM core PREPEND "${root}/src/core/")
  list(TRANSFORM core APPEND ".cxx")
  add_library(vtkTerrainCore OBJECT ${core})
  set_target_properties(vtkTerrainCore PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden)
  target_include_directories(vtkTerrainCore PUBLIC "${root}/src")
  target_link_libraries(vtkTerrainCore PUBLIC
    glm::glm GeographicLib::GeographicLib vtkTerrainWarnings)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    list(TRANSFORM core_without_contraction PREPEND "${root}/src/core/")
    list(TRANSFORM core_without_contraction APPEND ".cxx")
    set_source_files_properties(${core_without_contraction}
      PROPERTIES COMPILE_OPTIONS "-ffp-contract=off")
    set_source_files_properties("${root}/src/core/rays/LaneKernelsPlain.cxx"
      PROPERTIES COMPILE_OPTIONS "${core_lanes_options}")
    if (has_lanes_x86)
      set_source_files_properties("${root}/src/core/rays/LaneKernelsAvx2.cxx"
        PROPERTIES COMPILE_OPTIONS "${core_lanes_options};${core_lanes_avx2_options}")
      set_source_files_properties("${root}/src/core/rays/LaneKernelsAvx512.cxx"
        PROPERTIES COMPILE_OPTIONS "${core_lanes_options};${core_lanes_avx512_options}")
      set_source_files_properties("${root}/src/core/rays/LaneKernels.cxx"
        PROPERTIES COMPILE_DEFINITIONS TERRAIN_LANES_X86 SKIP_UNITY_BUILD_INCLUSION ON)
    endif ()
    list(TRANSFORM core_without_vectors PREPEND "${root}/src/core/")
    list(TRANSFORM core_without_vectors APPEND ".cxx")
    set_source_files_properties(${core_without_vectors}
      PROPERTIES COMPILE_OPTIONS "-fno-tree-slp-vectorize")
  endif ()
  list(TRANSFORM core_with_geographic_strings PREPEND "${root}/src/core/")
  list(TRANSFORM core_with_geographic_strings APPEND ".cxx")
  set_source_files_properties(${core_with_geographic_strings}
    PROPERTIES COMPILE_OPTIONS "${vtkTerrain_geographic_string_options}")
  list(APPEND sources "$<TARGET_OBJECTS:vtkTerrainCore>")
endif ()

vtk_module_add_module(vtkTerrain::Terrain
  CLASSES ${classes}
  SOURCES ${sources}
  PRIVATE_HEADERS ${private_headers})
vtk_module_link(vtkTerrain::Terrain
  PRIVATE
    "$<BUILD_INTERFACE:vtkTerrainWarnings>"
    "$<BUILD_INTERFACE:glm::glm>"
    "$<BUILD_INTERFACE:nlohmann_json::nlohmann_json>"
    GeographicLib::GeographicLib
    ${CMAKE_DL_LIBS}
    ${window_libraries})
# GDAL is found at run time (raster/GDALTable.h). What the table lacks must not wait till then.
target_include_directories(Terrain PRIVATE
  "$<TARGET_PROPERTY:GDAL::GDAL,INTERFACE_INCLUDE_DIRECTORIES>")
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_link_options(Terrain PRIVATE LINKER:-z,defs)
endif ()
# Reading VTK's headers takes longer than compiling what uses them.
target_precompile_headers(Terrain PRIVATE
  <glm/glm.hpp> <algorithm> <array> <cmath> <functional> <string> <vector>
  <vtkDoubleArray.h> <vtkFieldData.h> <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h>
  <vtkInformationVector.h> <vtkNew.h> <vtkObjectFactory.h> <vtkOpenGLPolyDataMapper.h>
  <vtkOpenGLRenderWindow.h> <vtkPointData.h> <vtkPolyData.h> <vtkRenderer.h> <vtkSmartPointer.h>
  <vtkStreamingDemandDrivenPipeline.h> <vtkTextureObject.h>)
if (VTK_VERSION VERSION_LESS 9.4)
  # A program that names no symbol of the module still gets its windows: the linker must neither
  # drop the library (--as-needed) nor, in a static build, the file that registers the windows.
  vtk_module_link(vtkTerrain::Terrain
    INTERFACE
      "-Wl,--undefined=vtkTerrainRenderWindowFactoryLinked,--push-state,--no-as-needed"
      "$<TARGET_FILE:vtkTerrain::Terrain>"
      "-Wl,--pop-state")
endif ()
