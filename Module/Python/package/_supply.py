# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the package takes from where it runs: VTK, GDAL, OpenGL. Versions are told apart here alone."""
import ctypes
import functools
import glob
import importlib.util
import os
import sys
import warnings

from . import _built_with

# Packages that bring GDAL, and a module of each that is linked to it.
_BRINGERS_OF_GDAL = {"rasterio": "_base", "pyogrio": "_ogr", "osgeo": "_gdal"}
# What VTK's windows open; any of them will do.
_EGL, _OSMESA = "libEGL.so.1", ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so")
_REMEDY = "VTK ends the process when it is to draw: install libEGL and a driver (Debian: libegl1 libgl1-mesa-dri)"
# Tries EGL's devices in a process of its own: what a driver loads and opens there is gone with it.
_TRY_EGL = """
import ctypes
pointer, number = ctypes.c_void_p, ctypes.c_int
egl = ctypes.CDLL("libEGL.so.1")
egl.eglGetProcAddress.restype = pointer
def function(name, result, *arguments):
    return ctypes.CFUNCTYPE(result, *arguments)(egl.eglGetProcAddress(name))
devices, count = (pointer * 64)(), number()
function(b"eglQueryDevicesEXT", number, number, pointer, pointer)(64, devices, ctypes.byref(count))
display = function(b"eglGetPlatformDisplayEXT", pointer, number, pointer, pointer)
initialize = function(b"eglInitialize", number, pointer, pointer, pointer)
EGL_PLATFORM_DEVICE_EXT = 0x313F
works = any(initialize(display(EGL_PLATFORM_DEVICE_EXT, device, None), None, None) for device in devices[:count.value])
print("works" if works else "no device")
"""
_LONGEST_TRY = 30  # seconds


def check_vtk():
    """Raises an ImportError that names the remedy if Python's VTK is not the one built for."""
    wanted = _built_with.VTK_SERIES
    major, minor = wanted.split(".")
    remedy = f"pip install 'vtk>={wanted},<{major}.{int(minor) + 1}', or build vtkterrain for the VTK there is"
    try:
        from vtkmodules import vtkCommonCore
    except ImportError as error:
        raise ImportError(f"vtkterrain needs VTK {wanted}, Python cannot import any ({error}): "
                          f"{remedy}") from error
    version = vtkCommonCore.vtkVersion.GetVTKVersion()
    if version.split(".")[:2] != [major, minor]:
        raise ImportError(f"vtkterrain {_built_with.VERSION} is built for VTK {wanted}, Python imports "
                          f"{version} from {os.path.dirname(vtkCommonCore.__file__)}: {remedy}")


def _files_that_bring_gdal():
    """Extension modules linked to GDAL: of packages that are imported first, else that are installed."""
    for package in sorted(_BRINGERS_OF_GDAL, key=lambda name: name not in sys.modules):
        try:
            spec = importlib.util.find_spec(package)
        except (ImportError, ValueError):
            continue
        for folder in (spec.submodule_search_locations or []) if spec else []:
            yield from sorted(glob.glob(os.path.join(glob.escape(folder), _BRINGERS_OF_GDAL[package] + ".*.so")))


def offer_gdal(reader):
    """Names the GDALs of Python's packages to the module, which loads one when it needs it."""
    for path in _files_that_bring_gdal():
        reader.AddGDAL(path)


def find_geoids():
    """Tells GeographicLib of the grids in this Python's own share/, as conda and venvs have it."""
    folder = os.path.join(sys.prefix, "share", "GeographicLib")
    if os.path.isdir(os.path.join(folder, "geoids")) and "GEOGRAPHICLIB_GEOID_PATH" not in os.environ:
        os.environ.setdefault("GEOGRAPHICLIB_DATA", folder)


def _can_load(library):
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


@functools.cache
def _why_no_driver():
    """Why none of EGL's devices works; empty if one does, or if that cannot be tried."""
    import subprocess  # takes its time, and few need it

    try:
        tried = subprocess.run([sys.executable, "-S", "-I", "-c", _TRY_EGL], capture_output=True, text=True,
                               stdin=subprocess.DEVNULL, check=False, timeout=_LONGEST_TRY)
    except (OSError, subprocess.SubprocessError, ValueError):
        return ""
    return f"libEGL finds no driver of OpenGL, and {_REMEDY}" if tried.stdout == "no device\n" else ""


def why_no_opengl(with_driver=True):
    """Why VTK could draw nothing here, in a sentence that names the remedy; empty if it can.

    ``with_driver`` also tries the driver, once in a process, which takes a tenth of a second.
    """
    if os.environ.get("DISPLAY") or any(map(_can_load, _OSMESA)):
        return ""
    if not _can_load(_EGL):
        return f"there is neither a display nor libEGL nor OSMesa, and {_REMEDY}"
    return _why_no_driver() if with_driver else ""


def warn_without_opengl(with_driver=True, stacklevel=3):
    """Says so before VTK's own window can end the process."""
    reason = why_no_opengl(with_driver)
    if reason:
        warnings.warn(reason, RuntimeWarning, stacklevel=stacklevel)
