# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Completion of balcony for bash. Without an installation: source balcony.bash

_balcony() {
    local words=() word line prefix i
    # Bash splits words at ':' and '='.
    for ((i = 1; i <= COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        if [[ ${#words[@]} -gt 0 && ($word == [:=]* || ${words[-1]} == *[:=]) ]]; then
            words[-1]+=$word
        else
            words+=("$word")
        fi
    done
    prefix=${words[-1]%"${words[-1]##*[:=]}"}
    COMPREPLY=()
    while IFS= read -r line; do
        word=${line%%$'\t'*}
        COMPREPLY+=("$(printf '%q' "${word#"$prefix"}")")
    done < <("${COMP_WORDS[0]}" complete "${words[@]}" 2>/dev/null)
    if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *[/:=] ]]; then
        compopt -o nospace
    fi
}
complete -F _balcony balcony
