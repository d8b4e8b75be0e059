# Finds all external libraries. docs/dependencies.md explains the purpose of each;
# scripts/packages.txt lists the Debian packages.
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
include("${CMAKE_CURRENT_LIST_DIR}/library_dependencies.cmake")

# Debian's Imath reports at each use that a Python library is packaged elsewhere; hence no STATUS.
foreach(dependency IN LISTS BALCONY_LIBRARY_DEPENDENCIES)
    string(REPLACE " " ";" dependency "${dependency}")
    set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
    find_package(${dependency} REQUIRED)
    unset(CMAKE_MESSAGE_LOG_LEVEL)
endforeach()

find_package(CLI11 2.1 REQUIRED)            # CLI11::CLI11
if(BUILD_TESTING)
    find_package(GTest 1.12 REQUIRED)       # GTest::gtest_main
    find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
endif()
