# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# For scripts that need a Debian system of its own.

# system_folder NAME: where scripts/try-on keeps a system, its build folder and its ccache.
system_folder() {
    printf '%s/%s\n' "${BALCONY_SYSTEMS:-${XDG_CACHE_HOME:-$HOME/.cache}/balcony/systems}" "$1"
}

# debian_system SUITE TARGET OPTION...: makes one by mmdebstrap, from the package source of this
# machine.
debian_system() {
    local source options=()
    source=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Label: Debian' | head -n 1)
    mapfile -t options < <(apt-config dump | grep -E '^Acquire::(http|https|Check)' | sed 's/^/--aptopt=/')
    mmdebstrap "${options[@]}" "${@:3}" "$1" "$2" "${source:-http://deb.debian.org/debian}"
}
