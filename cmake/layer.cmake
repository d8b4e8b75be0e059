# balcony_layer(NAME [NOT_INSTALLED] [LIGHTLY_OPTIMISED]
#               SOURCES file... [USES layer...] [PRIVATE library...])
#
# One static library for one folder of src/. USES names the layers below that it may include;
# PRIVATE names external libraries. The parts of the command that have layers of their own are
# NOT_INSTALLED: other programs do not use them. Layers whose time is spent in those below are
# LIGHTLY_OPTIMISED. tests/architecture has the table of allowed dependencies.
function(balcony_layer name)
    cmake_parse_arguments(layer "NOT_INSTALLED;LIGHTLY_OPTIMISED" "" "SOURCES;USES;PRIVATE" ${ARGN})
    set(target balcony_${name})
    add_library(${target} STATIC ${layer_SOURCES})
    add_library(balcony::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    target_include_directories(${target}
        PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
               $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:balcony_options>)
    foreach(used IN LISTS layer_USES)
        target_link_libraries(${target} PUBLIC balcony_${used})
    endforeach()
    target_link_libraries(${target} PRIVATE ${layer_PRIVATE})
    if(layer_LIGHTLY_OPTIMISED)
        balcony_optimise_lightly(${target})
        balcony_use_precompiled_headers(${target} light_layer)
    else()
        balcony_use_precompiled_headers(${target} layer)
    endif()
    balcony_group_sources(${target})
    if(NOT layer_NOT_INSTALLED)
        set_property(GLOBAL APPEND PROPERTY BALCONY_LAYERS ${target})
    endif()
endfunction()
