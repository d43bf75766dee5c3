#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""boots.py FIRMWARE DISK FOLDER BOOT: a machine with UEFI and this disk is switched on: it becomes who the file on its boot
partition (mtools' BOOT) says, closes its disk, starts again by itself, and the exhibit is on its screen. Then its plug is
pulled, and it comes up once more."""
import os
import re
import subprocess
import sys
import time

from machine import PATIENCE

firmware, disk, folder, boot = sys.argv[1:]
began = time.time()


def say(text):
    print(f'[{time.time() - began:.0f} s] {text}', flush=True)


class Pc:
    def __init__(self, name):
        self.log = f'{folder}/{name}.log'
        variables = f'{folder}/variables.fd'
        if not os.path.exists(variables):
            subprocess.run(['cp', firmware.replace('_CODE', '_VARS'), variables], check=True)
        if os.path.exists(self.log):
            os.unlink(self.log)
        # As tests/guest/machine.py has it, but for who boots: its firmware.
        self.process = subprocess.Popen(
            ['qemu-system-x86_64', '-M', 'q35,vmport=off', '-accel', 'tcg,thread=multi', '-cpu', 'Nehalem', '-smp', '2', '-m',
             '1536', '-nodefaults', '-no-user-config',
             '-drive', f'if=pflash,format=raw,readonly=on,file={firmware}', '-drive', f'if=pflash,format=raw,file={variables}',
             '-drive', f'file={disk},if=none,id=d0,format=raw,cache=writeback', '-device', 'virtio-blk-pci,drive=d0,bootindex=0',
             '-device', 'virtio-rng-pci', '-device', 'virtio-gpu-pci,xres=320,yres=240', '-display', 'none', '-device',
             'usb-ehci', '-serial', f'file:{self.log}'], stdin=subprocess.DEVNULL, stderr=open(f'{folder}/qemu.err', 'w'))

    def said(self):
        with open(self.log, 'rb') as file:
            return file.read().decode(errors='replace').replace('\r', '')

    def until(self, what):
        end = time.time() + PATIENCE
        while time.time() < end:
            assert self.process.poll() is None, 'qemu ended: ' + open(f'{folder}/qemu.err').read()
            if os.path.exists(self.log) and re.search(what, self.said()):
                return
            time.sleep(0.5)
        raise AssertionError(f'"{what}" was not said within {PATIENCE} s; it said at last:\n{self.said()[-4000:]}')

    def cut_power(self):
        self.process.kill()
        self.process.wait()


def on_boot(name):
    return subprocess.run(['mtype', '-i', boot, f'::/{name}'], check=True, capture_output=True).stdout.decode()


def in_root(path):
    start = re.search(r'start= *(\d+).*0FC63DAF', subprocess.run(['sfdisk', '--dump', disk], check=True, capture_output=True,
                                                                 text=True).stdout)[1]
    return subprocess.run(['debugfs', '-R', f'cat {path}', f'{disk}?offset={int(start) * 512}'], check=True,
                          capture_output=True).stdout.decode(errors='replace')


pc = Pc('first')
try:
    pc.until(r'Linux version|systemd\[1\]')
    say('the firmware started Debian')
    pc.until('quadrat-first-boot.*passphrase: kept')
    pc.until('room for what visitors did: (7[0-9]{2}|8[0-9]{2}) MB')
    say('it was told who it is')
    # Its unit has started when its first landscapes are on the screen.
    pc.until('Started quadrat.service')
    say('it started again by itself, and the exhibit is on its screen')
    # The disk is closed: what is on it has not changed since.
    pc.cut_power()
    answer = on_boot('quadrat-answer.txt')
    for line in ('name: foyer-2', 'zone: Europe/Berlin', 'language: de', 'passphrase: kept'):
        assert line in answer, answer
    assert 'sentence' not in on_boot('quadrat-setup.txt'), 'the passphrase still lies there'
    assert in_root('/etc/hostname') == 'foyer-2\n', in_root('/etc/hostname')
    assert 'language = "de"' in in_root('/etc/quadrat/quadrat.toml')
    assert 'overlayroot="tmpfs' in in_root('/etc/overlayroot.local.conf')
    pc = Pc('second')
    pc.until('foyer-2')
    pc.until('Started quadrat.service')
    say('its plug was pulled, and it came up again')
    assert 'quadrat-first-boot: name' not in pc.said(), 'it asked twice'
except AssertionError as error:
    say(f'FAILED: {error}')
    sys.exit(1)
finally:
    pc.cut_power()
say('everything as it should be')
