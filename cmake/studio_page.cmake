# balcony_studio_page(VARIABLE)
#
# Sets a variable to a generated source file that defines studio::page_files(). It has the page of studio/,
# bundled when its sources have changed, if Node.js and its packages are there (scripts/studio --setup),
# and no files otherwise: a build downloads nothing. The sources of Debian's packages have the file itself
# (scripts/package).
function(balcony_studio_page variable)
    set(page "${PROJECT_SOURCE_DIR}/studio")
    set(source "${PROJECT_BINARY_DIR}/studio/page_files.cpp")
    set(${variable} "${source}" PARENT_SCOPE)
    if(EXISTS "${page}/page_files.cpp")
        configure_file("${page}/page_files.cpp" "${source}" COPYONLY)
        return()
    endif()
    find_program(BALCONY_NODE node)
    mark_as_advanced(BALCONY_NODE)
    set(packages "${page}/node_modules/.package-lock.json")
    if(NOT BALCONY_NODE OR NOT EXISTS "${packages}")
        message(STATUS "The page of the studio is left out; scripts/studio builds with it")
        configure_file("${page}/page_files.cpp.in" "${source}" COPYONLY)
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS "${page}/src/*.ts" "${page}/*.mjs" "${page}/*.css" "${page}/*.html"
        "${page}/*.svg" "${page}/package-lock.json" "${page}/page_files.cpp.in"
        "${PROJECT_SOURCE_DIR}/editors/vscode/syntaxes/*.json")
    add_custom_command(OUTPUT "${source}" VERBATIM
        COMMAND "${BALCONY_NODE}" "${page}/bundle.mjs" "${PROJECT_BINARY_DIR}/studio/page"
        COMMAND "${BALCONY_NODE}" "${page}/embed.mjs" "${PROJECT_BINARY_DIR}/studio/page" "${source}"
        DEPENDS ${sources} "${packages}"
        COMMENT "Bundling the page of the studio")
endfunction()
