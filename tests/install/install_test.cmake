# Installs the build to a separate prefix, then builds and runs a program that uses only the
# prefix.
set(prefix "${FOLDER}/prefix")
set(consumer "${FOLDER}/consumer")
file(REMOVE_RECURSE "${prefix}" "${consumer}")

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "failed (${result}): ${command}")
    endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/consumer" -B "${consumer}" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run("${CMAKE_COMMAND}" --build "${consumer}")
run("${consumer}/consumer")
run("${consumer}/consumer_of_cameras")
run("${prefix}/bin/balcony" --version)

# Exactly the public headers are installed.
file(GLOB_RECURSE ours RELATIVE "${PUBLIC_HEADERS}" "${PUBLIC_HEADERS}/*")
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT ours STREQUAL installed)
    message(FATAL_ERROR "installed headers: ${installed}\npublic headers: ${ours}")
endif()
