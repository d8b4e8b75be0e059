# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Functions for scripts that render plates. A plate is a folder plates/NN-name/ with
#   camera.cam   its camera, unless the plate file names another
#   README.md    a heading and a paragraph on what it shows
#   plate        lines of a key and its value; a # opens a comment:
#       scene   PROGRAM [OPTION...]   a program in plates/ that writes the scene to a file
#       render  [--OPTION VALUE...]   options for balcony render, each with a value
build=build/release

# plate_folder NUMBER: the folder of a plate, given as 2 or 02.
plate_folder() {
    compgen -G "plates/$(printf '%02d' "$((10#$1))")-*"
}

# plate_value FOLDER KEY: the value of a key in the plate file; empty if missing.
plate_value() {
    sed -n "s/[[:space:]]*#.*//; s/^$2[[:space:]]\{1,\}//p" "$1/plate"
}

# plate_title FOLDER: the heading of its README.
plate_title() {
    sed -n 's/^# *//p;T;q' "$1/README.md"
}

# plate_program FOLDER: the program that writes its scene, also the name of a build target.
plate_program() {
    plate_value "$1" scene | cut -d ' ' -f 1
}

# plate_camera FOLDER: its camera file.
plate_camera() {
    local camera
    camera=$(plate_value "$1" camera)
    realpath --relative-to=. "$1/${camera:-camera.cam}"
}

# build_scene FOLDER: writes the scene of a plate, once for all plates that share it, and prints
# its path.
build_scene() {
    local words file
    read -ra words <<< "$(plate_value "$1" scene)"
    file="out/scenes/$(IFS=-; tr -cs 'a-z0-9_\n' - <<< "${words[*]}").glb"
    if [[ ! -e $file || $build/plates/${words[0]} -nt $file ]]; then
        mkdir -p out/scenes
        "$build/plates/${words[0]}" "$file" "${words[@]:1}" >&2
    fi
    printf '%s\n' "$file"
}

# render_plate FOLDER PICTURE [OPTION...]: renders a plate; the options override its own.
render_plate() {
    local folder=$1 picture=$2 given=("${@:3}") own options=() scene i
    read -ra own <<< "$(plate_value "$folder" render)"
    for ((i = 0; i < ${#own[@]}; i += 2)); do
        if [[ " ${given[*]} " != *" ${own[i]} "* ]]; then
            options+=("${own[@]:i:2}")
        fi
    done
    scene=$(build_scene "$folder")
    mkdir -p "$(dirname "$picture")"
    "$build/balcony" render "$scene" --camera "$(plate_camera "$folder")" -o "$picture" \
        "${options[@]}" "${given[@]}"
}
