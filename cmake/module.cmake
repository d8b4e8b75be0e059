# balcony_module(NAME FILE SOURCES file... LOADER loader file PRIVATE library... LAYER layer)
#
# A module FILE-VERSION.so that programs load with their first call, and the objects of its loader. The
# version is part of the name, since a module fits only the programs that it was built with. It is
# beside the command where that was built, and in a folder of libraries where it is installed.
function(balcony_module name file)
    cmake_parse_arguments(module "" "LAYER" "SOURCES;LOADER;PRIVATE" ${ARGN})
    add_library(${name} MODULE ${module_SOURCES})
    target_include_directories(${name} PRIVATE
        "${PROJECT_SOURCE_DIR}/src" "${PROJECT_SOURCE_DIR}/include")
    target_link_libraries(${name} PRIVATE ${module_PRIVATE} balcony_options)
    # The command has its own copy of the layers below; only the entry is visible.
    target_link_options(${name} PRIVATE -Wl,--exclude-libs,ALL)
    set_target_properties(${name} PROPERTIES
        PREFIX "" OUTPUT_NAME ${file}-${PROJECT_VERSION}
        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
    install(TARGETS ${name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/balcony")

    list(POP_FRONT module_LOADER loader)
    add_library(${loader} OBJECT ${module_LOADER})
    set_target_properties(${loader} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    file(RELATIVE_PATH folder
        "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}/balcony")
    target_compile_definitions(${loader} PRIVATE
        BALCONY_MODULE="$<TARGET_FILE_NAME:${name}>" BALCONY_MODULE_FOLDER="${folder}")
    target_link_libraries(${loader}
        PUBLIC ${module_LAYER} PRIVATE balcony_options ${CMAKE_DL_LIBS})
endfunction()
