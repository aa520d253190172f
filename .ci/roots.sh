# Sourced by what CI does in a clean system: another release of Debian, or this one without what was installed here.
# shellcheck shell=bash
# Needs root, and debootstrap.

# The address that this machine gets its own Debian packages from.
debian_mirror() {
    apt-get indextargets --format '$(REPO_URI) $(CODENAME)' 'Created-By: Packages' |
        awk -v codename="$(. /etc/os-release && echo "$VERSION_CODENAME")" '$2 == codename { print $1; exit }'
}

make_first() { # CODENAME FOLDER
    local codename=$1 folder=$2
    rm -rf "$folder"
    mkdir -p "$folder"
    debootstrap --variant=minbase "$codename" "$folder" "$(debian_mirror)" >"$folder.log" 2>&1 || {
        tail -n 20 "$folder.log"
        return 1
    }
    # The machine's own settings of apt, a proxy's address among them. No service is started, nothing is fsynced.
    cp -rL /etc/apt/apt.conf.d/. "$folder/etc/apt/apt.conf.d/" || return 1
    rm -f "$folder"/etc/apt/apt.conf.d/*{packagekit,PackageKit,postgresql}*
    printf '#!/bin/sh\nexit 101\n' >"$folder/usr/sbin/policy-rc.d"
    chmod +x "$folder/usr/sbin/policy-rc.d"
    echo force-unsafe-io >"$folder/etc/dpkg/dpkg.cfg.d/quick"
    touch "$folder/made"
}

# make_root CODENAME FOLDER: a minimal system of that release, such as `trixie`, unless it is there. A second one is a copy.
make_root() {
    local codename=$1 folder=$2 first=build/roots/$1
    [[ ! -e $folder/made ]] || return 0
    mkdir -p build/roots
    # Two may ask for it at once.
    (
        flock 9
        [[ -e $first/made ]] || make_first "$codename" "$first"
    ) 9>"$first.lock" || return 1
    rm -rf "$folder"
    mkdir -p "$(dirname "$folder")"
    cp -a "$first" "$folder"
}

# in_root FOLDER CHECKOUT COMMAND...: runs it there in /sunder, which is CHECKOUT of this machine. What it mounts is gone
# with it, and so is what it left running.
in_root() {
    local folder=$1 checkout=$2
    shift 2
    mkdir -p "$folder/sunder"
    # shellcheck disable=SC2016 # for the shell that is started
    unshare --mount --pid --fork --kill-child sh -euc '
        folder=$1 checkout=$2
        shift 2
        mount --make-rprivate /
        mount --bind "$checkout" "$folder/sunder"
        mount -t proc proc "$folder/proc"
        mount --rbind /dev "$folder/dev"
        [ ! -e /etc/resolv.conf ] || cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
        [ ! -e /etc/hosts ] || cp -L /etc/hosts "$folder/etc/hosts"
        exec chroot "$folder" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 CI="${CI-}" \
            sh -c "cd /sunder && exec \"\$@\"" sh "$@"
    ' sh "$folder" "$checkout" "$@"
}
