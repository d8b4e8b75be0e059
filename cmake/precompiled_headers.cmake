# External headers that most files include are compiled once, not for every file. A file
# still includes what it uses, so that everything compiles without them (BALCONY_PCH=OFF).

# balcony_precompiled_headers(NAME HEADERS header... [LINKS library...] [POSITION_INDEPENDENT]
#                             [LIGHTLY_OPTIMISED])
#
# Defines a set of headers from the libraries in LINKS. Targets that use a set are compiled
# with its flags: POSITION_INDEPENDENT as all layers are, or not, as programs are. g++ 14 rejects
# headers that were precompiled with another level of optimisation.
function(balcony_precompiled_headers name)
    cmake_parse_arguments(set "POSITION_INDEPENDENT;LIGHTLY_OPTIMISED" "" "HEADERS;LINKS" ${ARGN})
    if(BALCONY_PCH)
        set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}_headers.cpp")
        file(CONFIGURE OUTPUT "${source}" CONTENT "")
        add_library(${name}_headers OBJECT "${source}")
        target_link_libraries(${name}_headers PRIVATE balcony_options ${set_LINKS})
        target_precompile_headers(${name}_headers PRIVATE ${set_HEADERS})
        if(set_POSITION_INDEPENDENT)
            set_target_properties(${name}_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
        endif()
        if(set_LIGHTLY_OPTIMISED)
            balcony_optimise_lightly(${name}_headers)
        endif()
    endif()
endfunction()

# balcony_use_precompiled_headers(TARGET NAME): the target uses that set.
function(balcony_use_precompiled_headers target name)
    if(BALCONY_PCH)
        target_precompile_headers(${target} REUSE_FROM ${name}_headers)
        # The definitions must match, or the compiler rejects the set.
        target_compile_definitions(${target} PRIVATE
            $<TARGET_PROPERTY:${name}_headers,COMPILE_DEFINITIONS>)
    endif()
endfunction()

set(standard_headers <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <filesystem>
    <functional> <limits> <map> <memory> <numbers> <optional> <set> <span> <string> <string_view>
    <utility> <variant> <vector>)
set(layer_headers ${standard_headers} <fmt/format.h> <Imath/ImathBox.h> <Imath/ImathColor.h>
    <Imath/ImathMatrix.h> <Imath/ImathVec.h>)

balcony_precompiled_headers(layer POSITION_INDEPENDENT
    HEADERS ${layer_headers}
    LINKS fmt::fmt Imath::Imath)
balcony_precompiled_headers(light_layer POSITION_INDEPENDENT LIGHTLY_OPTIMISED
    HEADERS ${layer_headers}
    LINKS fmt::fmt Imath::Imath)
if(BUILD_TESTING)
    balcony_precompiled_headers(test LIGHTLY_OPTIMISED
        HEADERS ${layer_headers} <fstream> <random> <gtest/gtest.h>
        LINKS fmt::fmt Imath::Imath GTest::gtest)
endif()
