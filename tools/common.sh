# Sourced by tools/demo, tools/test and others: from a bare machine to a current Release build in build/.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
install=yes # --no-install says no
rest=()     # the other arguments

# parse_arguments ARGUMENTS...: sets `install` and `rest`; --help prints what usage() says.
parse_arguments() {
    local argument
    for argument in "$@"; do
        case $argument in
            --help | -h)
                usage
                exit 0
                ;;
            --no-install) install=no ;;
            *) rest+=("$argument") ;;
        esac
    done
}

# install_packages [PACKAGE...]: what everything needs, and those besides.
install_packages() {
    if [[ $install == no ]]; then
        return
    fi
    if command -v apt-get >/dev/null; then
        "$root/tools/install-packages" "$@"
    else
        echo "No apt here: the libraries come from vcpkg.json (see the preset vcpkg); going on with what is installed."
    fi
}

# The cache is of this checkout and of a Release build, and the build files were written.
is_configured() {
    [[ -f $root/build/build.ninja ]] &&
        grep -sqxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$root/build/CMakeCache.txt" &&
        grep -sqx 'CMAKE_BUILD_TYPE:[A-Z]*=Release' "$root/build/CMakeCache.txt" &&
        ! grep -sqxE 'BUILD_TESTING:[A-Z]*=(OFF|NO|0|FALSE)' "$root/build/CMakeCache.txt"
}

# build TARGET...: Ninja repeats CMake and compiles only where something changed. SUNDER_PRESET names another preset than `default`
# for a folder that is not configured yet.
build() {
    if ! is_configured; then
        local preset=${SUNDER_PRESET-default}
        if [[ -n ${VCPKG_ROOT-} ]] && ! command -v apt-get >/dev/null; then
            preset=vcpkg
        fi
        (cd "$root" && cmake --fresh --preset "$preset" -B build)
    fi
    cmake --build "$root/build" --target "$@"
}

processors() {
    getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2
}
