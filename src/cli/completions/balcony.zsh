#compdef balcony
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Completion of balcony for zsh. Without an installation: put it as _balcony into a folder of $fpath

_balcony() {
    local line word
    local -a ended open ended_text open_text
    for line in "${(@f)$(_call_program words $words[1] complete "${(@q)words[2,CURRENT-1]}" "${(q)PREFIX}")}"; do
        word=${line%%$'\t'*}
        [[ -n $word ]] || continue
        if [[ $word == *[/:=] ]]; then
            open+=("$word")
            open_text+=("$word  ${line#*$'\t'}")
        else
            ended+=("$word")
            ended_text+=("$word  ${line#*$'\t'}")
        fi
    done
    compadd -l -d ended_text -a ended
    compadd -S '' -l -d open_text -a open
}

_balcony "$@"
