#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""updates.py IMAGE FOLDER OLD WORKS FAILS: a machine with version OLD takes WORKS, though its plug is pulled before that is
put in place and while it is; and goes back to it from FAILS, though its plug is pulled then too. Whenever it comes up it has
one whole version, and the exhibit runs in the end."""
import os
import re
import sys
import time

from machine import Machine, PATIENCE

image, folder, old, works, fails = sys.argv[1:]
began = time.time()
disk = f'{folder}/updated.ext4'
KEPT = '/var/lib/quadrat-update'


def say(text):
    print(f'[{time.time() - began:.0f} s] {text}', flush=True)


class Updated(Machine):
    def __init__(self, repository):
        super().__init__(image, f'{folder}/updated', disk, f'{folder}/{repository}.img')
        self.wait()
        self.sh('mount -o ro /dev/vdb /srv')

    def comes(self, command, what):
        """Until the command says it. Asked often: the plug is to be pulled in a certain moment."""
        end = time.time() + PATIENCE
        while (told := self.sh(command).strip()) != what:
            assert time.time() < end, (f'{command} says {told}, not {what}: ' +
                                       self.sh(f'cat {KEPT}/trial {KEPT}/dpkg.log; journalctl -u quadrat-update -n 30 --no-pager'))
            time.sleep(0.1)

    def version(self):
        return self.sh("dpkg-query -W -f '${Version} ${db:Status-Status}' quadrat").strip()

    def is_settled(self, version):
        """No trial is under way, one whole version is there, and its first landscapes are on the screen."""
        self.comes(f'test -e {KEPT}/trial || echo no', 'no')
        assert self.version() == f'{version} installed', self.version()
        assert self.sh('dpkg --audit') == '', self.sh('dpkg --audit')
        self.comes('systemctl is-active quadrat', 'active')


def is_set_up():
    with Updated('works') as machine:
        machine.is_settled(old)
        machine.sh('cp /srv/quadrat.sources /etc/apt/sources.list.d/; cp /srv/quadrat.gpg /usr/share/keyrings/')
        # An emulated processor takes its time to be well.
        machine.sh('mkdir -p /etc/systemd/system/quadrat-update.service.d; printf "[Service]\\nTimeoutStartSec=infinity\\nEnvironment='
                   'QUADRAT_UPDATE_PATIENCE=3000 QUADRAT_UPDATE_WELL_FOR=10\\n" '
                   '>/etc/systemd/system/quadrat-update.service.d/emulated.conf; systemctl enable quadrat-update-resume; sync')
        machine.sh('systemctl daemon-reload; systemctl start --no-block quadrat-update')
        # Said once the note of it is on the disk: of one that is only in memory, a cut leaves nothing to go on with.
        machine.until(re.escape(f'{works} comes'))
    say(f'{works} was fetched, and the plug was pulled')


def is_cut_off_while_it_is_installed():
    with Updated('works') as machine:
        assert machine.version().split()[0] in (old, works), machine.version()
        # By itself it goes on, and dpkg is at work when its states are not those of rest.
        machine.comes("dpkg-query -W -f '${db:Status-Status}' quadrat | grep -qx installed && "
                      f"[ \"$(dpkg-query -W -f '${{Version}}' quadrat)\" = '{old}' ] && echo rest || echo work", 'work')
        found = machine.version()
    say(f'the plug was pulled while dpkg had it as "{found}"')


def is_updated():
    with Updated('works') as machine:
        machine.is_settled(works)
        said = machine.sh('journalctl -u quadrat-update --no-pager')
        assert f'{works} is well' in said, said
    say(f'{works} runs, and is well')


def goes_back():
    with Updated('fails') as machine:
        machine.is_settled(works)
        machine.sh('systemctl start --no-block quadrat-update')
        machine.comes(f'head -n 1 {KEPT}/trial 2>/dev/null', 'back')
    say(f'{fails} does not run; the plug was pulled on the way back')
    with Updated('fails') as machine:
        machine.is_settled(works)
        assert machine.sh(f'cat {KEPT}/refused').split() == [fails]
        machine.sh('systemctl start quadrat-update')
        assert machine.version() == f'{works} installed', 'it is not tried twice'
    say(f'{works} runs again, and {fails} is not tried twice')


if os.path.exists(disk):
    os.unlink(disk)
try:
    is_set_up()
    is_cut_off_while_it_is_installed()
    is_updated()
    goes_back()
    os.unlink(disk)
except (AssertionError, TimeoutError, RuntimeError, EOFError) as error:
    say(f'FAILED: {error}')
    sys.exit(1)
say('everything as it should be')
