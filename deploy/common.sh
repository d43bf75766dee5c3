# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What deploy/run and deploy/test share: Debian's packages, the configuration, the build. Sourced, never run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cores=$(nproc)
# A compiler process of this code takes up to 1.5 GB: a box with little memory builds with fewer at once.
memory_jobs=$(awk '/MemAvailable/ {n = int($2 / 1500000); print (n < 1 ? 1 : n)}' /proc/meminfo 2>/dev/null || echo 1)
jobs=$((cores < memory_jobs ? cores : memory_jobs))
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros

say() { printf '%s\n' "$*"; }
die() {
    printf 'quadrat: %s\n' "$*" >&2
    exit 2
}

# packages_missing SET...: the packages of these sets that are not installed.
packages_missing() {
    local wanted sets
    sets=$(printf '%s|' "$@")
    wanted=$(awk -v sets="^(${sets%|})$" '!/^#/ && $1 ~ sets {print $2}' "$root/deploy/packages")
    local name
    for name in $wanted; do
        dpkg-query -W -f '${db:Status-Status}\n' "$name" 2>/dev/null | grep -qx installed || printf '%s ' "$name"
    done
}

# install_packages SET...: quiet when nothing is missing.
install_packages() {
    command -v dpkg-query >/dev/null || die "this is not Debian: install what deploy/packages names by hand, then run cmake yourself (README.md, \"By hand\")"
    local missing as_root=()
    missing=$(packages_missing "$@")
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
            as_root=(sudo)
        else
            die "these Debian packages are missing and need root to install: run as root: apt-get install ${missing% }"
        fi
    fi
    say "Installing from Debian: ${missing% }"
    local log
    log=$(mktemp)
    # shellcheck disable=SC2086  # a list of names
    if ! { "${as_root[@]}" apt-get update -q && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
           apt-get install -y -q --no-install-recommends $missing; } </dev/null >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        rm -f "$log"
        die "apt-get could not install them (its last words are above); check the network and /etc/apt/sources.list"
    fi
    rm -f "$log"
}

# configure_and_build FOLDER TARGET... -- CMAKE_ARGUMENT...: ends as the build ends, also where the caller asks whether
# it did ("if", "||"): the shell goes on after a failure then.
configure_and_build() {
    local folder=$1 targets=() log lock ended=0
    shift
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        targets+=("$1")
        shift
    done
    [ $# -gt 0 ] && shift
    mkdir -p "$folder"
    # Two builds at a time in one folder spoil each other's files.
    exec {lock}>"$folder/building.lock"
    if ! flock --nonblock "$lock"; then
        say "Another build is at work in $folder: waiting for it."
        flock "$lock"
    fi
    log=$folder/configure.log
    if ! cmake -S "$root" -B "$folder" -G Ninja "$@" >"$log" 2>&1; then
        tail -n 25 "$log" >&2
        die "cmake could not configure $folder (its last words are above)"
    fi
    local status='[%f/%t] '
    [ -t 1 ] || status='[%p] '
    NINJA_STATUS=$status cmake --build "$folder" --parallel "$jobs" ${targets[@]+--target "${targets[@]}"} || ended=$?
    exec {lock}>&-
    return $ended
}
