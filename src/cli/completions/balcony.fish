# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# Completion of balcony for fish. Without an installation: source balcony.fish

function __balcony_complete
    set -l words (commandline -opc) (commandline -ct)
    $words[1] complete $words[2..] 2>/dev/null
end

complete -c balcony -f -a '(__balcony_complete)'
