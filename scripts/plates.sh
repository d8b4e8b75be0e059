# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Functions for scripts that render plates. A plate is a folder plates/NN-name/ with
#   camera.cam    its camera, unless the plate file names another
#   README.md     a heading and a paragraph on what it shows
#   property.cpp  what it must show, measured
#   plate         lines of a key and its value; a # opens a comment:
#       scene    NAME [OPTION...]            what plates/build_scene writes
#       camera   FILE[:NAME]                 default: camera.cam
#       pinhole  FILE[:NAME]                 the ordinary view that its page compares with
#       map      FILE:NAME                   the camera whose magnification its page shows, if the
#                                            plate is a picture of several
#       arrows   FILE[:NAME] [OPTION...]     adds a camera as balcony draw writes it to the scene
#       povray   SCENE CAMERA [OPTION...]    the same through POV-Ray, on an original scene
#       render   [--OPTION VALUE...]         options for balcony render, each with a value
build=build/release

# plate_folder NUMBER: the folder of a plate, given as 2 or 02.
plate_folder() {
    compgen -G "plates/$(printf '%02d' "$((10#$1))")-*"
}

# plate_value FOLDER KEY: the value of a key in the plate file; empty if missing.
plate_value() {
    sed -n "s/[[:space:]]*#.*//; s/^$2[[:space:]]\{1,\}//p" "$1/plate"
}

# plate_size FOLDER: WIDTHxHEIGHT of its render options.
plate_size() {
    plate_value "$1" render | sed -n 's/.*--size \([0-9]\+x[0-9]\+\).*/\1/p'
}

# plate_title FOLDER: the heading of its README.
plate_title() {
    sed -n 's/^# *//p;T;q' "$1/README.md"
}

# plate_camera FOLDER [KEY]: its camera file, or that of another key, with its name if there is one.
plate_camera() {
    local camera
    camera=$(plate_value "$1" "${2:-camera}")
    camera=${camera:-$(plate_value "$1" camera)}
    camera=${camera%% *}
    realpath --relative-to=. --canonicalize-missing "$1/${camera:-camera.cam}"
}

# scene_file SCENE [OPTION...]: writes a scene, once for all plates that share it, and prints its path.
scene_file() {
    local file
    file="out/scenes/$(IFS=-; tr -cs 'a-z0-9_\n' - <<< "$*").glb"
    if [[ ! -e $file || $build/plates/build_scene -nt $file ]]; then
        mkdir -p out/scenes
        "$build/plates/build_scene" "$1" "$file" "${@:2}" >&2
    fi
    printf '%s\n' "$file"
}

# build_scene FOLDER: writes the scene of a plate and prints its path.
build_scene() {
    local words
    read -ra words <<< "$(plate_value "$1" scene)"
    scene_file "${words[@]}"
}

# arrows_option FOLDER: writes the arrows of the camera that stands in the plate's scene, and prints
# the option of balcony render for them; nothing without such a camera.
arrows_option() {
    local words file
    read -ra words <<< "$(plate_value "$1" arrows)"
    if [[ ${#words[@]} -gt 0 ]]; then
        file="out/scenes/$(basename "$1")-arrows.glb"
        mkdir -p out/scenes
        "$build/balcony" draw "$(plate_camera "$1" arrows)" -o "$file" --no-eye --no-toward \
            --no-frame --quiet "${words[@]:1}" >&2
        printf '%s\n' "--add $file"
    fi
}

# render_plate FOLDER PICTURE [OPTION...]: renders a plate; the options override its own.
render_plate() {
    local folder=$1 picture=$2 given=("${@:3}") own options=() scene i
    read -ra own <<< "$(plate_value "$folder" render) $(arrows_option "$folder")"
    for ((i = 0; i < ${#own[@]}; i += 2)); do
        if [[ " ${given[*]} " != *" ${own[i]} "* ]]; then
            options+=("${own[@]:i:2}")
        fi
    done
    scene=$(build_scene "$folder")
    mkdir -p "$(dirname "$picture")"
    if [[ " ${given[*]} " != *" --camera "* ]]; then
        options+=(--camera "$(plate_camera "$folder")")
    fi
    "$build/balcony" render "$scene" -o "$picture" "${options[@]}" "${given[@]}"
}

# render_hung_pictures [NAME...]: renders the pictures that hang in the scenes again, all of them
# without a name. Rows of plates/pictures/list: NAME SCENE [--OPTION] CAMERA [OPTION...]. The camera is
# a file beside the list, perhaps with :NAME, or a built-in one.
render_hung_pictures() {
    local words scene camera known=() name
    while read -ra words; do
        name=${words[0]}
        known+=("$name")
        if [[ $# -gt 0 && " $* " != *" $name "* ]]; then
            continue
        fi
        scene=("${words[1]}")
        words=("${words[@]:2}")
        while [[ ${words[0]} == --* ]]; do
            scene+=("${words[0]}")
            words=("${words[@]:1}")
        done
        camera=${words[0]}
        if [[ -e plates/pictures/${camera%%:*} ]]; then
            camera=plates/pictures/$camera
        fi
        "$build/balcony" render "$(scene_file "${scene[@]}")" --camera "$camera" \
            -o "plates/pictures/$name.jpg" "${words[@]:1}"
    done < <(grep -v '^#' plates/pictures/list)
    for name in "$@"; do
        if [[ " ${known[*]} " != *" $name "* ]]; then
            say "there is no picture '$name' in plates/pictures/list"
            return 2
        fi
    done
}
