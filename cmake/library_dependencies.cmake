# The external libraries of the layers, with their names for find_package and the target
# that each defines. The build uses this list, and so does an installed balcony: a static library
# needs its dependencies at link time, and the Embree that it was compiled with.
set(BALCONY_LIBRARY_DEPENDENCIES
    "Threads"             # Threads::Threads
    "fmt 9"               # fmt::fmt
    "Imath 3.1"           # Imath::Imath
    "OpenEXR 3.1"         # OpenEXR::OpenEXR
    "OpenImageIO 2.4"     # OpenImageIO::OpenImageIO
    "TBB"                 # TBB::tbb
    "PNG 1.6"             # PNG::PNG
    "TurboJPEG"           # TurboJPEG::TurboJPEG
    "embree ${BALCONY_EMBREE_VERSION}"  # embree
    "hwy 1.0"             # hwy::hwy
    "SLEEF 3.5"           # SLEEF::sleef
    "nlohmann_json 3.11"  # nlohmann_json::nlohmann_json
    "yaml-cpp 0.7"        # yaml-cpp::yaml-cpp, before 0.8 yaml-cpp
    "PROJ 9.1"            # PROJ::proj
)
