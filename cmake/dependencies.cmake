# Every library from outside, found in one place. docs/dependencies.md says what each is for;
# scripts/packages.txt names the Debian package that brings it. What an installed balcony needs is
# said once more in balconyConfig.cmake.in.
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")

find_package(Threads REQUIRED)
find_package(fmt 9 REQUIRED)                # fmt::fmt

# Debian's Imath lists a Python library that is packaged elsewhere and reports it missing each time.
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
find_package(Imath 3.1 REQUIRED)            # Imath::Imath
unset(CMAKE_MESSAGE_LOG_LEVEL)

find_package(OpenEXR 3.1 REQUIRED)          # OpenEXR::OpenEXR
find_package(OpenImageIO 2.4 REQUIRED)      # OpenImageIO::OpenImageIO
find_package(TBB REQUIRED COMPONENTS tbb)   # TBB::tbb
find_package(embree 3.13 REQUIRED)          # embree
find_package(assimp 5.2 REQUIRED)           # assimp::assimp
find_package(hwy 1.0 REQUIRED)              # hwy::hwy
find_package(SLEEF 3.5 REQUIRED)            # SLEEF::sleef
find_package(nlohmann_json 3.11 REQUIRED)   # nlohmann_json::nlohmann_json
find_package(CLI11 2.1 REQUIRED)            # CLI11::CLI11

if(BUILD_TESTING)
    find_package(GTest 1.12 REQUIRED)       # GTest::gtest_main
    find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
endif()
if(BALCONY_BENCH)
    find_package(benchmark 1.7 REQUIRED)    # benchmark::benchmark
endif()
