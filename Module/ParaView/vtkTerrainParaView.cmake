# The ParaView plugin: finds ParaView, whose package brings the VTK that it was built with, and adds the
# plugin's module to those that are built.
# Components are named, because ParaView's package else asks for Qt.
find_package(ParaView REQUIRED
  COMPONENTS ProcessXML RemotingApplication RemotingViews WrapClientServer)
list(APPEND vtkTerrain_module_files "${CMAKE_CURRENT_LIST_DIR}/Views/vtk.module")
list(APPEND vtkTerrain_module_names vtkTerrain::ParaViewViews)

# To be called when the modules are there.
function (vtkterrain_build_paraview_plugin)
  set(_paraview_plugin_default_TerrainPlugin ON)
  paraview_plugin_scan(
    PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Module/ParaView/Plugin/paraview.plugin"
    PROVIDES_PLUGINS plugins
    REQUIRES_MODULES modules)
  paraview_plugin_build(
    PLUGINS ${plugins}
    AUTOLOAD ${plugins}
    PLUGINS_FILE_NAME "terrain.plugins.xml"
    RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
endfunction ()
