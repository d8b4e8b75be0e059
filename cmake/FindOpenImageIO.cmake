# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Finds OpenImageIO and defines OpenImageIO_FOUND, OpenImageIO_VERSION and the target
# OpenImageIO::OpenImageIO. Replaces the CMake package of Debian's libopenimageio-dev, which
# requires a viewer (and with it Qt) and OpenCV's headers without depending on their packages.
# Installed with balcony's own package file, which needs it too.
find_path(OpenImageIO_INCLUDE_DIR NAMES OpenImageIO/imageio.h)
find_library(OpenImageIO_LIBRARY NAMES OpenImageIO)
find_library(OpenImageIO_UTIL_LIBRARY NAMES OpenImageIO_Util)
mark_as_advanced(OpenImageIO_INCLUDE_DIR OpenImageIO_LIBRARY OpenImageIO_UTIL_LIBRARY)

# The header defines its version as three macros.
if(OpenImageIO_INCLUDE_DIR)
    set(OpenImageIO_VERSION "")
    foreach(part IN ITEMS MAJOR MINOR PATCH)
        file(STRINGS "${OpenImageIO_INCLUDE_DIR}/OpenImageIO/oiioversion.h" line
            REGEX "#define OIIO_VERSION_${part} +[0-9]+")
        string(REGEX MATCH "[0-9]+$" number "${line}")
        list(APPEND OpenImageIO_VERSION "${number}")
    endforeach()
    list(JOIN OpenImageIO_VERSION "." OpenImageIO_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO
    REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_UTIL_LIBRARY OpenImageIO_INCLUDE_DIR
    VERSION_VAR OpenImageIO_VERSION)

if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
        IMPORTED_LOCATION "${OpenImageIO_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${OpenImageIO_UTIL_LIBRARY};Imath::Imath")
endif()
