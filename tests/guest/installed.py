#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""installed.py IMAGE FOLDER: a machine set up, read from only, crashed, updated and given a new identity as the guide says,
and every command of the guide that needs a machine (tests/journeys/guide_commands.txt)."""
import os
import re
import sys
import time

from machine import Machine, PATIENCE

image, folder = sys.argv[1:]
os.makedirs(folder, exist_ok=True)
began = time.time()
here = os.path.dirname(os.path.abspath(__file__))
disk, stick = f'{folder}/installed.ext4', f'{folder}/stick.img'


def say(text):
    print(f'[{time.time() - began:.0f} s] {text}', flush=True)


class Installed(Machine):
    def __init__(self):
        super().__init__(image, f'{folder}/installed', disk, stick, 'root=/dev/vda ro')

    def type(self, command, statuses=(0,)):
        """As staff type it, in the folder they copied; what it said."""
        done = self.ask('sh', timeout=PATIENCE / 2, command=f'cd /root/quadrat && {command}')
        assert done['status'] in statuses, f'{command} ended with {done["status"]}:\n{done["out"]}'
        with open(f'{folder}/guide.log', 'a') as log:
            log.write(f'$ {command}\n{done["out"]}\n')
        return done['out']

    def reboots(self):
        """The machine goes down by itself; the test switches on the next one."""
        self.ask('sh', command='(sleep 1; exec sudo reboot) >/dev/null 2>&1 &', timeout=60)
        end = time.time() + PATIENCE
        while self.process.poll() is None:
            assert time.time() < end, f'it does not go down: {self.said()[-2000:]}'
            time.sleep(0.2)

    def wait(self):
        """Until it has started all it starts: the agent answers before any disk is mounted."""
        seconds = super().wait()
        end = time.time() + PATIENCE
        while self.sh('systemctl is-system-running').strip() not in ('running', 'degraded'):
            assert time.time() < end, self.sh('systemctl list-jobs')
            time.sleep(1)
        return seconds

    def is_only_read(self):
        return self.sh('findmnt -n -o SOURCE /').strip() == 'overlayroot'

    def main_pid(self, unit):
        return self.sh(f'systemctl show -p MainPID --value {unit}').strip()

    def runs(self, unit='quadrat'):
        end = time.time() + PATIENCE
        while self.sh(f'systemctl is-active {unit}').strip() != 'active':
            assert time.time() < end, self.sh(f'systemctl status {unit}; journalctl -u {unit} -n 50')
            time.sleep(1)


def installs():
    # The disk is /dev/vda here, and the stick /dev/vdb.
    command = 'sudo deploy/install --data /dev/sda --format --read-only'.replace('/dev/sda', '/dev/vdb') + \
        ' --binary build/bin/quadrat'
    with Installed() as machine:
        say(f'booted in {machine.wait():.0f} s')
        machine.type('sudo timedatectl set-timezone Europe/Berlin')
        assert 'Berlin' in machine.sh('readlink /etc/localtime')
        machine.sh('timedatectl set-timezone Etc/UTC')
        would = machine.type(command + ' --dry-run')
        assert 'would make a partition on /dev/vdb' in would, would
        assert 'Done.' in machine.type(command)
        assert 'already' in machine.type(command, (2,)), 'it would format twice'
        again = machine.type('sudo deploy/install --data LABEL=quadrat-data --read-only --binary build/bin/quadrat')
        assert again == 'Everything is as it should be.\n', again
        machine.reboots()
    say('installed, on a stick that was made and formatted')


def crashes():
    with Installed() as machine:
        machine.wait()
        assert machine.is_only_read(), machine.sh('findmnt')
        machine.type('touch /root/memory-takes-it')
        for place, source in (('/var/lib/quadrat', '/dev/vdb1'), ('/var/log/journal', '/.machine/journal'),
                              ('/var/lib/systemd/coredump', '/.machine/coredump')):
            assert source in machine.sh(f'findmnt -n -o SOURCE {place}'), f'{place}: ' + machine.sh('findmnt; systemctl --failed')
        assert machine.sh('stat -c %U /var/lib/quadrat /var/lib/quadrat/.machine/journal').split() == ['quadrat', 'root']
        machine.runs()
        machine.type('sudo cp /etc/quadrat/quadrat.toml /run/quadrat.toml')
        machine.sh('echo "# kept" >>/run/quadrat.toml; echo gone >/etc/gone; logger of the first day')
        machine.type('sudo overlayroot-chroot cp /run/quadrat.toml /etc/quadrat/quadrat.toml')
        machine.type('sudo overlayroot-chroot ln -sf /usr/share/zoneinfo/Europe/Berlin /etc/localtime')
        pid = machine.main_pid('quadrat')
        machine.sh(f'kill -SEGV {pid}')
        end = time.time() + PATIENCE
        while 'present' not in machine.sh('coredumpctl list --no-pager /usr/bin/quadrat'):
            assert time.time() < end, 'no crash was kept: ' + machine.sh('coredumpctl list; ls -l /var/lib/systemd/coredump')
            time.sleep(1)
        machine.runs()
        machine.sh('journalctl --sync')
    say('crashed, and its plug was pulled')


def remembers():
    with Installed() as machine:
        machine.wait()
        assert machine.sh('cat /etc/gone') != 'gone\n'
        assert 'Berlin' in machine.sh('readlink /etc/localtime')
        assert '# kept' in machine.sh('tail -n 1 /etc/quadrat/quadrat.toml')
        assert 'of the first day' in machine.sh('journalctl -b -1')
        assert 'present' in machine.sh('coredumpctl list --no-pager /usr/bin/quadrat')
        machine.runs()
        crash = machine.sh('quadrat doctor --only service')
        assert 'coredumpctl info' in crash, crash
        tries_the_guides_commands(machine)
        machine.type('cp build/quadrat_*.deb /run/quadrat.deb')
        machine.type('sudo overlayroot-chroot dpkg --force-confold -i /run/quadrat.deb')
        machine.type("""sudo overlayroot-chroot sed -i 's/^overlayroot=.*/overlayroot="disabled"/' /etc/overlayroot.local.conf""")
        machine.reboots()
    say('remembered both, was updated, and opened')


def tries_the_guides_commands(machine):
    machine.until('the four of round 1 are on the screen|taking up visit')
    count = 0
    for line in open(f'{here}/../journeys/guide_commands.txt'):
        row = re.match(r'machine ([\d,]+) \| (.+)', line)
        if row:
            machine.type(row[2], [int(status) for status in row[1].split(',')])
            if 'start quadrat' in row[2]:
                machine.runs()
            count += 1
    say(f'{count} commands of the guide')


def is_updated_and_closed():
    with Installed() as machine:
        machine.wait()
        assert not machine.is_only_read()
        assert 'installed' in machine.sh("dpkg-query -W -f '${Status}' quadrat")
        machine.runs()
        machine.type('systemctl start quadrat-fleet')
        before = {unit: machine.main_pid(unit) for unit in ('quadrat', 'quadrat-fleet')}
        assert '0' not in before.values(), before
        machine.type('dpkg --force-confold -i build/quadrat_*.deb')
        for unit, pid in before.items():
            machine.runs(unit)
            assert machine.main_pid(unit) != pid, f'{unit} still runs as before'
        say('a newer package started exhibit and fleet anew')
        identity = machine.sh('cat /etc/machine-id; md5sum /etc/ssh/ssh_host_ed25519_key.pub')
        machine.type('rm -f /etc/machine-id /var/lib/dbus/machine-id /etc/ssh/ssh_host_*')
        machine.type('systemd-machine-id-setup')
        machine.type('ssh-keygen -A')
        new = machine.sh('cat /etc/machine-id; md5sum /etc/ssh/ssh_host_ed25519_key.pub')
        assert len(new.split()) == 3 and not set(new.split()[:2]) & set(identity.split()[:2]), f'{identity} {new}'
        machine.type('sudo deploy/install --data LABEL=quadrat-data --read-only' + ' --binary build/bin/quadrat')
        machine.reboots()
    say('opened, given a new identity, and closed')
    with Installed() as machine:
        machine.wait()
        assert machine.is_only_read()
        machine.runs()
    say('runs closed again')


for path in (disk, stick, f'{folder}/guide.log'):
    if os.path.exists(path):
        os.unlink(path)
with open(stick, 'wb') as file:
    file.truncate(1 << 30)
try:
    installs()
    crashes()
    remembers()
    is_updated_and_closed()
    os.unlink(disk)
    os.unlink(stick)
except (AssertionError, TimeoutError, RuntimeError, EOFError) as error:
    say(f'FAILED: {error}')
    sys.exit(1)
say('everything as it should be')
