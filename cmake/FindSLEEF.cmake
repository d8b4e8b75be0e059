# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Finds SLEEF, which Debian ships without a CMake package. Defines SLEEF_FOUND, SLEEF_VERSION and
# the target SLEEF::sleef. Installed beside balcony's own package file, which needs it too.
find_path(SLEEF_INCLUDE_DIR NAMES sleef.h)
find_library(SLEEF_LIBRARY NAMES sleef)
mark_as_advanced(SLEEF_INCLUDE_DIR SLEEF_LIBRARY)

# The header defines its version as three macros.
if(SLEEF_INCLUDE_DIR)
    set(SLEEF_VERSION "")
    foreach(part IN ITEMS MAJOR MINOR PATCHLEVEL)
        file(STRINGS "${SLEEF_INCLUDE_DIR}/sleef.h" line REGEX "#define SLEEF_VERSION_${part} +[0-9]+")
        string(REGEX MATCH "[0-9]+$" number "${line}")
        list(APPEND SLEEF_VERSION "${number}")
    endforeach()
    list(JOIN SLEEF_VERSION "." SLEEF_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SLEEF
    REQUIRED_VARS SLEEF_LIBRARY SLEEF_INCLUDE_DIR
    VERSION_VAR SLEEF_VERSION)

if(SLEEF_FOUND AND NOT TARGET SLEEF::sleef)
    add_library(SLEEF::sleef UNKNOWN IMPORTED)
    set_target_properties(SLEEF::sleef PROPERTIES
        IMPORTED_LOCATION "${SLEEF_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${SLEEF_INCLUDE_DIR}")
endif()
