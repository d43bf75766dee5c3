#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What an exhibit goes through, on an emulated machine: exhibit.py IMAGE FOLDER [CUTS]. Screenshots and the exhibit's
journal stay in FOLDER; ends with 1 and one line where something is not as it should be."""
import os
import random
import re
import struct
import sys
import time
import zlib

from machine import Machine

image, folder = sys.argv[1], sys.argv[2]
cuts = int(sys.argv[3]) if len(sys.argv) > 3 else 3
os.makedirs(folder, exist_ok=True)
began = time.time()


def say(text):
    print(f'[{time.time() - began:5.0f} s] {text}', flush=True)


def colours(path):
    """How many colours a plain PNG holds: a console has a handful, a landscape hundreds."""
    data = open(path, 'rb').read()
    at, packed = 8, b''
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        chunk = data[at + 8:at + 8 + length]
        at += 12 + length
        if kind == b'IHDR':
            width, height, _, colour = struct.unpack('>IIBB', chunk[:10])
        if kind == b'IDAT':
            packed += chunk
    step = {2: 3, 6: 4}[colour]
    raw, stride, before, seen = zlib.decompress(packed), width * step, bytearray(width * step), set()
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, up, corner = (row[x - step] if x >= step else 0), before[x], (before[x - step] if x >= step else 0)
            if kind == 1:
                row[x] = row[x] + left & 255
            elif kind == 2:
                row[x] = row[x] + up & 255
            elif kind == 3:
                row[x] = row[x] + (left + up >> 1) & 255
            elif kind == 4:
                guess = left + up - corner
                a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
                row[x] = row[x] + (left if a <= b and a <= c else up if b <= c else corner) & 255
        seen.update(bytes(row[x:x + 3]) for x in range(0, stride, step))
        before = row
    return len(seen)


class Exhibit(Machine):
    def journal(self):
        return self.sh('journalctl -u quadrat -b --no-pager -o cat')

    def until(self, what, timeout=180, after=0):
        """Until the journal says it, in what came after so many lines; returns the text since then."""
        end = time.time() + timeout
        while time.time() < end:
            text = '\n'.join(self.journal().splitlines()[after:])
            if re.search(what, text):
                return text
            time.sleep(0.5)
        raise AssertionError(f'"{what}" was not said within {timeout} s; the journal ends:\n{self.journal()[-3000:]}')

    def lines_so_far(self):
        return len(self.journal().splitlines())

    def picture(self, name, least):
        """A screenshot from outside; what is on it must be a picture."""
        end, found = time.time() + 60, 0
        path = f'{folder}/{name}.png'
        while time.time() < end:
            found = colours(self.screenshot(path))
            if found >= least:
                say(f'{name}.png: {found} colours')
                return
            time.sleep(1)
        raise AssertionError(f'{name}.png has {found} colours, and should have {least}')


def one_day():
    with Exhibit(image, f'{folder}/day') as machine:
        say(f'booted in {machine.wait():.0f} s')
        machine.plug_gpio()
        hid = machine.plug_hid()
        machine.until('the four of round 1 are on the screen', 240)
        say('the first four are on the screen')
        machine.picture('attract', 60)
        machine.until('GPIO lines A=')
        for line, name in ((0, 'A'), (1, 'B'), (2, 'C'), (3, 'D')):
            machine.press_line(line)
            machine.until(f'press {name} at', 30)
        machine.until('a visit begins')
        machine.until('the four of round 2 are on the screen')
        say('a round was played through GPIO')
        machine.picture('round-2', 60)

        for button, name in ((1, 'B'), (2, 'C'), (3, 'D')):
            so_far = machine.lines_so_far()
            machine.press_hid(hid, button)
            machine.until(f'press {name} at', 30, so_far)
        machine.until('the four of round 3 are on the screen')
        say('a round was played through HID')
        for _ in range(5):
            machine.ask('unplug', hid=hid)
            so_far = machine.lines_so_far()
            hid = machine.plug_hid()
            machine.until(r'Five buttons 1209:0001', 30, so_far)
        so_far = machine.lines_so_far()
        machine.press_hid(hid, 0)
        text = machine.until('press A at', 30, so_far)
        assert text.count('press ') == 1, f'presses were invented: {text}'
        say('unplugged and plugged in five times, and it works')

        health = machine.get('/run/quadrat/health.json').decode()
        assert '"mode": "usual"' in health, health
        owner = machine.sh('ps -o user= -C quadrat').split()
        assert owner == ['quadrat'], f'it runs as {owner}'

        so_far = machine.lines_so_far()
        machine.sh('kill -STOP $(systemctl show -p MainPID --value quadrat)')
        frozen = time.time()
        machine.until('taking up visit 1 at round 3', 180, so_far)
        assert 'watchdog' in machine.sh('journalctl -b -u quadrat --no-pager | grep -i watchdog').lower()
        assert machine.sh('systemctl show -p NRestarts --value quadrat').strip() == '1'
        machine.until('the four of round 3 are on the screen', 180, so_far)
        say(f'hung, ended by the watchdog, and back in round 3 after {time.time() - frozen:.0f} s')
        machine.picture('after-hang', 60)

        machine.screen(800, 600)
        time.sleep(2)
        so_far = machine.lines_so_far()
        machine.screen(0, 0)
        machine.until('screen: ', 60, so_far)
        so_far = machine.lines_so_far()
        machine.screen(800, 600)
        machine.until('shows again', 90, so_far)
        say('the screen was unplugged and plugged in')
        machine.picture('after-replug', 60)
        with open(f'{folder}/journal.txt', 'w') as file:
            file.write(machine.journal())


def power_cuts():
    """Whatever the moment, the generation that was on the screen is there again; the one in flight may be too."""
    disk, shown, chance = f'{folder}/disk.ext4', 0, random.Random(1)
    if os.path.exists(disk):
        os.unlink(disk)
    for cut in range(cuts):
        with Exhibit(image, f'{folder}/cut', disk) as machine:
            machine.wait()
            hid = machine.plug_hid()
            if shown:
                text = machine.until(r'taking up visit \d+ at round \d+', 240)
                taken = int(re.search(r'at round (\d+)', text).group(1))
                assert shown <= taken <= shown + 1, f'round {shown} was shown, and it goes on with round {taken}'
            machine.until(r'the four of round \d+ are on the screen', 240)
            machine.until('Five buttons', 60)
            end = time.time() + chance.uniform(4, 12)
            while time.time() < end:
                machine.press_hid(hid, chance.randrange(4), 0.15)
            rounds = re.findall(r'the four of round (\d+) are on the screen', machine.journal())
            if 'a visit begins' in machine.journal() or shown:
                shown = int(rounds[-1])
            machine.cut_power()
            say(f'power cut {cut + 1} of {cuts} in round {shown}')
    os.unlink(disk)


try:
    one_day()
    power_cuts()
except (AssertionError, TimeoutError, RuntimeError, EOFError) as error:
    say(f'FAILED: {error}')
    sys.exit(1)
say('everything as it should be')
