# Finds all external libraries. docs/dependencies.md explains the purpose of each;
# scripts/packages.txt lists the Debian packages.
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")

# balcony_find(NAME FIRST END PACKAGE): finds a version from FIRST to before END. The package files of
# these libraries refuse every request for another major version, so none is requested.
macro(balcony_find name first end package)
    find_package(${name} QUIET)
    if(NOT ${name}_FOUND OR ${name}_VERSION VERSION_LESS ${first} OR ${name}_VERSION VERSION_GREATER_EQUAL ${end})
        message(FATAL_ERROR "${name} ${first} or later, before ${end}, is needed, but found is: "
            "'${${name}_VERSION}'. Install ${package} or your system's package of it, or set ${name}_DIR to "
            "the folder of its CMake package.")
    endif()
endmacro()

balcony_find(embree 3.13 5 libembree-dev)
set(BALCONY_EMBREE_VERSION ${embree_VERSION})
target_compile_definitions(embree INTERFACE BALCONY_EMBREE=${embree_VERSION_MAJOR})

include("${CMAKE_CURRENT_LIST_DIR}/library_dependencies.cmake")

# Debian's Imath reports at each use that a Python library is packaged elsewhere; hence no STATUS.
foreach(dependency IN LISTS BALCONY_LIBRARY_DEPENDENCIES)
    string(REPLACE " " ";" dependency "${dependency}")
    set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
    find_package(${dependency} REQUIRED)
    unset(CMAKE_MESSAGE_LOG_LEVEL)
endforeach()

balcony_find(Eigen3 3.4 6 libeigen3-dev)    # Eigen3::Eigen, headers of the layer solve
find_package(tomlplusplus 3.3 REQUIRED)     # toml++/toml.h, headers of the layer dataset
find_package(CLI11 2.1 REQUIRED)            # CLI11::CLI11
find_package(Boost 1.74 REQUIRED CONFIG)    # Boost::headers, of the layer studio
# A module with a sanitizer is loaded by an interpreter without it, which takes the runtime of g++.
if(BALCONY_SANITIZE AND NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(BALCONY_PYTHON OFF)
endif()
if(BALCONY_PYTHON AND NOT CMAKE_CROSSCOMPILING)
    set(PYBIND11_FINDPYTHON ON)
    find_package(pybind11 2.10 REQUIRED CONFIG)  # pybind11_add_module, of the layer python
else()
    set(BALCONY_PYTHON OFF)
endif()
if(BUILD_TESTING)
    find_package(GTest 1.12 REQUIRED)       # GTest::gtest_main
    find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
endif()
