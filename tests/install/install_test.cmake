# Installs the build to a separate prefix, then builds and runs a program that uses only the
# prefix.
set(prefix "${FOLDER}/prefix")
set(consumer "${FOLDER}/consumer")
set(example "${FOLDER}/example")
set(rays "${FOLDER}/rays")
file(REMOVE_RECURSE "${prefix}" "${consumer}" "${example}" "${rays}")

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "failed (${result}): ${command}")
    endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")

function(build source folder)
    run("${CMAKE_COMMAND}" -S "${source}" -B "${folder}" -G "${GENERATOR}"
        "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
        -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
    run("${CMAKE_COMMAND}" --build "${folder}")
endfunction()

build("${CMAKE_CURRENT_LIST_DIR}/consumer" "${consumer}")
run("${consumer}/consumer")
run("${consumer}/consumer_of_cameras")
run("${consumer}/consumer_of_images")

# The command finds its modules wherever the prefix is.
set(moved "${FOLDER}/moved")
file(REMOVE_RECURSE "${moved}")
file(RENAME "${prefix}" "${moved}")
file(WRITE "${moved}/scene.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
run("${moved}/bin/balcony" render "${moved}/scene.obj" --size 8x8 -s 1 -q -o "${moved}/picture.jpg")
run("${moved}/bin/balcony" check robin)
file(REMOVE "${moved}/scene.obj" "${moved}/picture.jpg")
file(RENAME "${moved}" "${prefix}")

# The example has a stage of its own. Its picture has a line for each row, light and dark in it.
build("${EXAMPLES}/own_stage" "${example}")
execute_process(COMMAND "${example}/own_stage" RESULT_VARIABLE result OUTPUT_VARIABLE picture)
string(REGEX MATCHALL "[^\n]+\n" lines "${picture}")
list(LENGTH lines line_count)
if(NOT result EQUAL 0 OR NOT line_count EQUAL 16 OR NOT picture MATCHES "@" OR
   NOT picture MATCHES "   ")
    message(FATAL_ERROR "own_stage (${result}) draws:\n${picture}")
endif()

# The other example prints six numbers for each pixel, or what is wrong.
build("${EXAMPLES}/rays" "${rays}")
execute_process(COMMAND "${rays}/rays" panorama RESULT_VARIABLE result OUTPUT_VARIABLE numbers)
string(REGEX MATCHALL "[^ \n]+ [^ \n]+ [^ \n]+ [^ \n]+ [^ \n]+ [^ \n]+\n" lines "${numbers}")
list(LENGTH lines line_count)
if(NOT result EQUAL 0 OR NOT line_count EQUAL 2304)
    message(FATAL_ERROR "rays (${result}) prints ${line_count} rays:\n${numbers}")
endif()
execute_process(COMMAND "${rays}/rays" panrama RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 1 OR NOT said MATCHES "panorama")
    message(FATAL_ERROR "rays (${result}) says of a mistyped camera:\n${said}")
endif()

# Another finds a camera by the corners of a facade.
set(solve "${FOLDER}/solve")
file(REMOVE_RECURSE "${solve}")
build("${EXAMPLES}/solve" "${solve}")
execute_process(COMMAND "${solve}/solve" RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0 OR NOT said MATCHES "fov = [0-9.]+ \\+- [0-9.]+\n" OR NOT said MATCHES "missed by 0")
    message(FATAL_ERROR "solve (${result}) says:\n${said}")
endif()

# The last example renders a picture and a turn. A second run continues the turn: nothing is left.
set(render "${FOLDER}/render")
file(REMOVE_RECURSE "${render}")
build("${EXAMPLES}/render" "${render}")
file(WRITE "${render}/scene.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n")
foreach(expected IN ITEMS "3 frames, 0 of an earlier run" "0 frames, 3 of an earlier run")
    execute_process(COMMAND "${render}/render" WORKING_DIRECTORY "${render}"
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result EQUAL 0 OR NOT said MATCHES "64 x 32 pixels of panorama" OR
       NOT said MATCHES "the point is at \\([0-9.]+, [0-9.]+\\)" OR
       NOT said MATCHES "fov 2: " OR NOT said MATCHES "yaw 1: " OR
       NOT said MATCHES "${expected}" OR NOT EXISTS "${render}/picture.exr" OR
       NOT EXISTS "${render}/turn.03.exr")
        message(FATAL_ERROR "render (${result}) says:\n${said}")
    endif()
endforeach()

# The manual, the completion of shells and the files of editors are there.
foreach(file IN ITEMS
        share/man/man1/balcony.1 share/man/man1/balcony-render.1
        share/bash-completion/completions/balcony share/zsh/site-functions/_balcony
        share/fish/vendor_completions.d/balcony.fish
        share/vim/vimfiles/syntax/balcony.vim share/nvim/site/ftdetect/balcony.vim
        share/balcony/editors/vscode/package.json)
    if(NOT EXISTS "${prefix}/${file}")
        message(FATAL_ERROR "${file} is not installed")
    endif()
endforeach()

# All public headers are there, and no others.
file(GLOB_RECURSE ours RELATIVE "${PUBLIC_HEADERS}" "${PUBLIC_HEADERS}/*")
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT ours STREQUAL installed)
    message(FATAL_ERROR "installed headers: ${installed}\npublic headers: ${ours}")
endif()
