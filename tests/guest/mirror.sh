# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What the scripts of tests/guest share: the mirror that this machine installs from. Sourced, never run.
export PATH=$PATH:/sbin:/usr/sbin
mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null || true; } |
    grep -oE 'https?://[^ ]+/debian/?( |$)' | sed 's# *$##; s#/$##; q')
[ -n "$mirror" ] || { echo "guest: no Debian mirror in /etc/apt" >&2; exit 77; }
key=/usr/share/keyrings/debian-archive-keyring.gpg

# make_root SUITE FOLDER PACKAGE,PACKAGE...: that Debian in a folder.
make_root() {
    env -u APT_CONFIG mmdebstrap --quiet --variant=minbase --mode=root --include="$3" \
        --aptopt='Acquire::Languages "none"' --dpkgopt='path-exclude=/usr/share/doc/*' \
        --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
        "$1" "$2" "deb [signed-by=$key] $mirror $1 main" </dev/null
}
