# The pages of studio/ are bundled when their sources have changed, if Node.js and its packages are there
# (scripts/studio --setup). Otherwise they are left out: a build downloads nothing. The sources of
# Debian's packages have the files that would be generated (scripts/package).

# balcony_studio_page(VARIABLE)
#
# Sets a variable to a generated source file that defines studio::page_files(): the page of the studio.
macro(balcony_studio_page variable)
    balcony_bundle(${variable} page_files bundle.mjs page "The page of the studio")
endmacro()

# balcony_page_viewer(VARIABLE)
#
# The same for page::viewer(): what `balcony page` puts a scene into.
macro(balcony_page_viewer variable)
    balcony_bundle(${variable} viewer viewer.mjs viewer "The viewer of pages")
endmacro()

# balcony_bundle(VARIABLE NAME BUNDLER FOLDER MEANING)
#
# The source NAME.cpp is made of the template studio/NAME.cpp.in and of what the bundler writes into a
# folder of the build.
function(balcony_bundle variable name bundler folder meaning)
    set(page "${PROJECT_SOURCE_DIR}/studio")
    set(source "${PROJECT_BINARY_DIR}/studio/${name}.cpp")
    set(${variable} "${source}" PARENT_SCOPE)
    if(EXISTS "${page}/${name}.cpp")
        configure_file("${page}/${name}.cpp" "${source}" COPYONLY)
        return()
    endif()
    find_program(BALCONY_NODE node)
    mark_as_advanced(BALCONY_NODE)
    set(packages "${page}/node_modules/.package-lock.json")
    if(NOT BALCONY_NODE OR NOT EXISTS "${packages}")
        message(STATUS "${meaning} is left out; scripts/studio builds with it")
        configure_file("${page}/${name}.cpp.in" "${source}" COPYONLY)
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS "${page}/src/*.ts" "${page}/viewer/*" "${page}/*.mjs" "${page}/*.css"
        "${page}/*.html" "${page}/*.svg" "${page}/package-lock.json" "${page}/${name}.cpp.in"
        "${PROJECT_SOURCE_DIR}/editors/vscode/syntaxes/*.json")
    set(bundle "${PROJECT_BINARY_DIR}/studio/${folder}")
    add_custom_command(OUTPUT "${source}" VERBATIM
        COMMAND "${BALCONY_NODE}" "${page}/${bundler}" "${bundle}"
        COMMAND "${BALCONY_NODE}" "${page}/embed.mjs" "${bundle}" "${source}"
        DEPENDS ${sources} "${packages}"
        COMMENT "Bundling: ${meaning}")
endfunction()
