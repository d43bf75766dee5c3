# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# The partition of what visitors did, for deploy/install: looked at before anything is done, made and formatted only when
# told. Sourced, never run. Reads what was asked for: data, format, force, target.

data_label=quadrat-data
smallest_room_MB=256

# fact NAME DEVICE: TYPE, FSTYPE, LABEL or PTTYPE; nothing where there is none. Where udev has not looked at the device,
# what its first bytes say, if we may read them.
fact() {
    local found name=$1
    found=$({ lsblk --nodeps --noheadings --output "$name" "$2" 2>/dev/null || true; } | sed -n '1s/^ *//; 1s/ *$//; 1p')
    case $name in TYPE) ;; FSTYPE) name=TYPE ;& *)
        [ -n "$found" ] || found=$(blkid --probe --output value --match-tag "$name" "$2" 2>/dev/null || true) ;;
    esac
    echo "$found"
}
is_whole_disk() { case $(fact TYPE "$1") in disk | loop) ;; *) return 1 ;; esac; }
mounts_of() { lsblk --noheadings --output MOUNTPOINTS "$1" 2>/dev/null | sed 's/^ *//; /^$/d' || true; }
# device_named LABEL=x|UUID=x|PARTUUID=x|/dev/x: the device; nothing: there is none here.
device_named() {
    case $1 in
        /dev/*) [ -z "$(fact TYPE "$1")" ] || echo "$1" ;;
        *) { blkid -t "$1" -o device 2>/dev/null || true; } | sed -n 1p ;;
    esac
}

# complaints_about_data: a line for each reason not to use --data as it was given.
complaints_about_data() {
    case $data in
        /dev/?* | LABEL=?* | UUID=?* | PARTUUID=?*) ;;
        *) echo "--data $data: write a device, as lsblk names it (/dev/sda3), or LABEL=$data_label"; return ;;
    esac
    local device
    device=$(device_named "$data")
    if [ -z "$device" ]; then
        # Another machine's partition need not be here, if it has a name that is its own everywhere.
        if [ -n "$target" ] && [ "$format" = no ]; then case $data in *=*) return ;; esac; fi
        echo "--data $data: there is no such device; lsblk -o NAME,SIZE,FSTYPE,LABEL shows those there are"
    elif [ "$format" = yes ]; then complaints_about_formatting "$device"; else complaints_about_using "$device"; fi
}
complaints_about_using() {
    local device=$1 holds label where
    holds=$(fact FSTYPE "$device") label=$(fact LABEL "$device") where=$(mounts_of "$device" | grep -vx '/var/lib/quadrat' || true)
    if is_whole_disk "$device" && [ -z "$holds" ]; then
        echo "--data $data: this is a whole disk; name one of its partitions, or add --format to make one in its free room"
    elif [ -z "$holds" ]; then echo "--data $data: holds no file system; add --format to make one"
    elif [ "$holds" != ext4 ]; then
        echo "--data $data: holds $holds, and ext4 is needed; --format --force makes it anew, and deletes what is on it"
    elif [ "$data" = "$device" ] && [ "$label" != $data_label ]; then
        echo "--data $data: its label is \"$label\"; if it is the right one: e2label $device $data_label"
    elif has_mount_elsewhere "$where"; then echo "--data $data: is in use as ${where%%$'\n'*}; name another partition"; fi
}
# The journal and crashes are mounts of ours.
has_mount_elsewhere() { printf '%s\n' "$1" | grep -qv -e '^$' -e '^/var/log/journal$' -e '^/var/lib/systemd/coredump$'; }
complaints_about_formatting() {
    local device=$1 holds where other
    holds=$(fact FSTYPE "$device") where=$(mounts_of "$device")
    other=$(device_named LABEL=$data_label)
    local tool
    for tool in mkfs.ext4:e2fsprogs sfdisk:fdisk partx:util-linux; do
        command -v "${tool%:*}" >/dev/null || echo "--format needs ${tool%:*}: apt-get install ${tool#*:}"
    done
    case $data in /dev/*) ;; *) echo "--format needs a device, as lsblk names it (/dev/sda3), and not $data"; return ;; esac
    if [ -n "$other" ] && [ "$other" != "$device" ]; then
        echo "--format: $other has the label $data_label already; use it with --data LABEL=$data_label, or: e2label $other \"\""
    elif is_whole_disk "$device" && [ -n "$(fact PTTYPE "$device")" ]; then complaints_about_room "$device"
    elif [ -n "$where" ]; then
        echo "--format: $device is in use as ${where%%$'\n'*}; name another partition"
    elif [ -n "$holds" ] && [ "$force" = no ]; then
        echo "--format: $device holds a file system ($holds); --force deletes what is on it"
    fi
}
# The largest free room of a disk in MB, as sfdisk lists it: "start end sectors size".
free_room_MB() {
    LC_ALL=C sfdisk --list-free --quiet "$1" 2>/dev/null |
        awk '$3 ~ /^[0-9]+$/ && $3 > most {most = $3} END {print int(most * 512 / 1000000)}'
}
complaints_about_room() {
    local room
    room=$(free_room_MB "$1")
    [ "${room:-0}" -ge $smallest_room_MB ] ||
        echo "--format: $1 has ${room:-0} MB without a partition, and $smallest_room_MB are needed; name one of its partitions, make another smaller, or use a USB stick"
}

partitions_of() { lsblk --list --noheadings --paths --output NAME,TYPE "$1" | awk '$2 == "part" {print $1}' | sort; }
make_partition() { # DISK
    local disk=$1
    if [ -z "$(fact PTTYPE "$disk")" ]; then
        quietly wipefs --all "$disk" || die "--format: wipefs cannot clear $disk; is it write-protected?"
        printf 'label: gpt\n,,L\n' | quietly sfdisk --quiet "$disk" || die "--format: sfdisk cannot write $disk; is it write-protected?"
    else
        # The disk may be the one that runs: its other partitions stay as they are.
        printf ',,L\n' | quietly sfdisk --quiet --append --no-reread "$disk" || die "--format: sfdisk cannot add a partition to $disk"
    fi
    quietly partx --update "$disk" || true # the kernel may have seen it by itself
    ! command -v udevadm >/dev/null || quietly udevadm settle || true
}
make_file_system() { # DEVICE
    local device=$1 before
    if is_whole_disk "$device"; then
        before=$(if [ -n "$(fact PTTYPE "$device")" ]; then partitions_of "$device"; fi)
        make_partition "$device"
        device=$(comm -13 <(printf '%s\n' "$before") <(partitions_of "$device"))
        [ -n "$device" ] || die "--format: $1 shows no new partition, though one was made; reboot, and name it with --data"
    fi
    mkfs.ext4 -q -F -L $data_label -m 1 "$device" >/dev/null || die "--format: mkfs.ext4 cannot make a file system on $device"
}

# What /etc/fstab says of it. A partition that is broken or gone stops nothing (nofail); a fresh one is there before its
# owner is set. With it the journal and crashes outlive the night.
data_lines() {
    local how=noatime,nodev,nosuid,noexec,nofail,x-systemd.device-timeout=5s,errors=remount-ro source=$data
    case $source in /dev/*) source=LABEL=$data_label ;; esac
    local after=nofail,x-systemd.requires=quadrat-evidence.service,x-systemd.requires-mounts-for=/var/lib/quadrat
    echo "$source /var/lib/quadrat ext4 $how,x-systemd.before=systemd-tmpfiles-setup.service 0 2"
    echo "/var/lib/quadrat/.machine/journal /var/log/journal none bind,$after 0 0"
    echo "/var/lib/quadrat/.machine/coredump /var/lib/systemd/coredump none bind,$after 0 0"
}

# ---- a Raspberry Pi's firmware partition: FAT, which a plug that is pulled damages while it is written
firmware_line='^([^#[:space:]]+[[:space:]]+/boot/firmware[[:space:]]+[^[:space:]]+[[:space:]]+)([^[:space:]]+)'
firmware_is_writable() {
    grep -qE "$firmware_line" "$target/etc/fstab" 2>/dev/null &&
        ! grep -E "$firmware_line" "$target/etc/fstab" | awk '{print "," $4 ","}' | grep -q ',ro,'
}
protect_firmware() {
    mkdir -p "$memo"
    : >"$memo/firmware-was-writable"
    sed -i -E "s|$firmware_line|\\1\\2,ro|" "$target/etc/fstab"
}
unprotect_firmware() { sed -i -E "/$(printf '%s' "$firmware_line" | sed 's|/|\\/|g')/ s|,ro([[:space:]])|\\1|" "$target/etc/fstab"; }
