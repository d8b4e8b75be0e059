# Finds all external libraries. docs/dependencies.md explains the purpose of each;
# scripts/packages.txt lists the Debian packages.
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")

# Embree's package file refuses every request for another major version, so none is requested.
find_package(embree QUIET)
if(NOT embree_FOUND OR embree_VERSION VERSION_LESS 3.13 OR embree_VERSION VERSION_GREATER_EQUAL 5)
    message(FATAL_ERROR "Embree 4, or 3.13 or later, is needed, but found is: '${embree_VERSION}'. Install "
        "libembree-dev or your system's package of Embree, or set embree_DIR to where its "
        "embree-config.cmake is.")
endif()
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

find_package(Eigen3 3.4 REQUIRED)           # Eigen3::Eigen, headers of the layer solve
find_package(CLI11 2.1 REQUIRED)            # CLI11::CLI11
if(BUILD_TESTING)
    find_package(GTest 1.12 REQUIRED)       # GTest::gtest_main
    find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
endif()
