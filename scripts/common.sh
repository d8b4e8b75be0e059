# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# The common start of all scripts: strict mode, the repository as working folder, --help.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
}

# The help of a script is the comment at its top.
for argument in "$@"; do
    if [[ $argument == --help || $argument == -h ]]; then
        awk 'NR > 4 && !/^#/ { exit } NR > 4 { sub(/^# ?/, ""); print }' "scripts/$(basename "$0")"
        exit 0
    fi
done
