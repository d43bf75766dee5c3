#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What an exhibit goes through, on an emulated machine: exhibit.py IMAGE FOLDER CUTS. Screenshots and what the machine
said stay in FOLDER; ends with 1 and one line where something is not as it should be."""
import json
import os
import random
import re
import struct
import sys
import time
import zlib

from machine import BITMAP_KEYBOARD, BOOT_KEYBOARD, BOX_FROM_0, FIVE_BUTTONS, PATIENCE, Machine

image, folder, cuts = sys.argv[1], sys.argv[2], int(sys.argv[3])
os.makedirs(folder, exist_ok=True)
began = time.time()

LEAST_COLOURS = 100  # of a landscape, in each quarter of the screen; a console has a handful
GUARD_S = 0.7  # longer than the exhibit's own, in which a second press is not taken for an answer


def say(text):
    print(f'[{time.time() - began:5.0f} s] {text}', flush=True)


def read_ppm(path):
    with open(path, 'rb') as file:
        assert file.readline() == b'P6\n'
        width, height = map(int, file.readline().split())
        file.readline()
        return width, height, file.read()


def write_png(path, width, height, pixels):
    rows = b''.join(b'\0' + pixels[y * width * 3:(y + 1) * width * 3] for y in range(height))
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n')
        for kind, body in ((b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)),
                           (b'IDAT', zlib.compress(rows)), (b'IEND', b'')):
            file.write(struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body)))


def colours(width, height, pixels):
    """How many there are in each quarter."""
    quarters = [set(), set(), set(), set()]
    half = width * 3 // 2 // 3 * 3
    for y in range(height):
        row = pixels[y * width * 3:(y + 1) * width * 3]
        for side, part in enumerate((row[:half], row[half:])):
            quarters[y * 2 // height * 2 + side].update(zip(part[::3], part[1::3], part[2::3]))
    return [len(quarter) for quarter in quarters]


class Exhibit(Machine):
    def picture(self, name):
        """A screenshot from outside; what is on it must be four landscapes."""
        end, found = time.time() + PATIENCE / 10, []
        while time.time() < end:
            width, height, pixels = read_ppm(self.screenshot(f'{self.folder}/screen.ppm'))
            write_png(f'{folder}/{name}.png', width, height, pixels)
            found = colours(width, height, pixels)
            if min(found) >= LEAST_COLOURS:
                say(f'{name}.png: {width}x{height}, {found} colours')
                return
        raise AssertionError(f'{name}.png has {found} colours in its quarters, and should have {LEAST_COLOURS} in each')

    def press(self, name, close, open_):
        """One press, and the log's one line of it."""
        since = self.so_far()
        close()
        text = self.until(f'press {name} at', since)
        open_()
        time.sleep(GUARD_S)
        assert text.count('press ') == 1, f'one press of {name} was heard as\n{text}'

    def press_line(self, line):
        self.press('ABCD'[line], lambda: self.lines(1 << line), lambda: self.lines(0))

    def press_hid(self, hid, button):
        self.press('ABCD'[button], lambda: self.press_and_let_go(hid, button), lambda: None)

    def press_by(self, name, hid, *reports):
        self.press(name, lambda: self.ask('report', hid=hid, reports=list(reports)), lambda: None)

    def plug_wired_buttons(self):
        since = self.so_far()
        self.plug_gpio()
        self.until('buttons: HID device', since)  # is what is still missing

    def plug_encoder(self):
        """The buttons on USB; returns when the exhibit listens to them."""
        since = self.so_far()
        hid = self.plug_hid()
        self.until(r'buttons: GPIO lines A=.*Five buttons 1209:0001', since)
        time.sleep(GUARD_S)  # what is pressed while it is plugged in is not a press
        return hid

    def shows_round(self, number, since=0):
        return self.until(f'the four of round {number} are on the screen', since)


def boots_and_shows(machine):
    say(f'booted in {machine.wait():.0f} s')
    machine.shows_round(1)
    say('the first four are on the screen')
    machine.picture('attract')
    owner = machine.sh('ps -o user= -C quadrat').split()
    assert owner == ['quadrat'], f'it runs as {owner}'


def clock_source(machine):
    return json.loads(machine.get('/run/quadrat/health.json'))['clock']['source']


def hears_that_its_clock_is_synchronised(machine):
    """Shut in as the service is. Health is a minute old at most."""
    end = time.time() + PATIENCE
    while (source := clock_source(machine)) != 'synchronised':
        assert time.time() < end, f'the kernel\'s clock is synchronised, and the source in health is "{source}"'
        time.sleep(1)
    say('health says that the clock is synchronised')


def plays_a_round_through_gpio(machine):
    machine.plug_wired_buttons()
    for line in range(4):
        machine.press_line(line)
    text = machine.shows_round(2)
    assert text.count('a visit begins') == 1, text
    say('a round was played through GPIO')
    machine.picture('round-2')


def plays_a_round_through_hid(machine):
    hid = machine.plug_encoder()
    for button in (1, 2, 3):
        machine.press_hid(hid, button)
    machine.shows_round(3)
    say('a round was played through HID')
    return hid


def is_unplugged_five_times(machine, hid):
    since = machine.so_far()
    for _ in range(5):
        gone = machine.so_far()
        machine.ask('unplug', hid=hid)
        machine.until('buttons: .*was unplugged', gone)
        hid = machine.plug_encoder()
    assert 'press ' not in machine.said(since), f'presses were invented: {machine.said(since)}'
    machine.press_hid(hid, 0)
    say('unplugged and plugged in five times: no press was invented, and it works')


def hangs(machine):
    health = machine.get('/run/quadrat/health.json').decode()
    assert '"mode": "usual"' in health, health
    since, frozen = machine.so_far(), time.time()
    machine.sh('kill -STOP $(systemctl show -p MainPID --value quadrat)')
    machine.until('quadrat.service: Watchdog timeout', since)
    machine.until('taking up visit 1 at round 3', since)
    machine.shows_round(3, since)
    restarts = machine.sh('systemctl show -p NRestarts --value quadrat').strip()
    assert restarts == '1', f'it was started again {restarts} times'
    say(f'hung, ended by the watchdog, and back in round 3 after {time.time() - frozen:.0f} s')
    machine.picture('after-hang')


def loses_its_screen(machine):
    def modes():
        return machine.sh('cat /sys/class/drm/card*-Virtual-1/status /sys/class/drm/card*-Virtual-1/modes').split()

    def resize(width, height, is_so):
        machine.screen(width, height)
        end = time.time() + PATIENCE
        while not is_so(modes()):
            assert time.time() < end, f'the cable said {width}x{height}, and the kernel says {modes()}'
            time.sleep(0.2)

    resize(400, 300, lambda said: '400x300' in said[1:2])  # the first size that is told counts as no news
    since = machine.so_far()
    resize(0, 0, lambda said: said[0] == 'disconnected')
    machine.until('screen: .*no screen', since)
    since = machine.so_far()
    resize(400, 300, lambda said: said[0] == 'connected')
    machine.until('screen: shows again', since)
    say('the screen was unplugged and plugged in')
    machine.picture('after-replug')


def x_input(kind, code, value):
    return struct.pack('<HHi', kind, code, value).hex()


def hears_boards_as_they_are_sold(machine):
    """A board of three interfaces, a box that counts from 0, a pad in X-input mode, a board in keyboard mode."""
    since = machine.so_far()
    inputs = '["hid:d209:0420", "hid:1209:0002", "evdev:045e:028e", "evdev:04d9:a0cd"]'
    machine.sh('cp /etc/quadrat/quadrat.toml /root/usual.toml')
    machine.sh(f"sed -i 's/^inputs = .*/inputs = {inputs}/' /etc/quadrat/quadrat.toml && systemctl restart quadrat")
    machine.shows_round(r'\d+', since)
    since = machine.so_far()
    machine.plug('Encoder', 0xd209, 0x420, FIVE_BUTTONS, 'usb-guest-1/input0')
    keys = machine.plug('Encoder', 0xd209, 0x420, BOOT_KEYBOARD, 'usb-guest-1/input1')
    bits = machine.plug('Encoder', 0xd209, 0x420, BITMAP_KEYBOARD, 'usb-guest-1/input2')
    box = machine.plug('Box', 0x1209, 2, BOX_FROM_0, 'usb-guest-2/input0')
    pad = machine.plug_x_input_pad()
    board = machine.plug('Keyboard board', 0x4d9, 0xa0cd, BOOT_KEYBOARD, 'usb-guest-4/input0')
    machine.until('buttons: (.*Encoder d209:0420){3}.*Box.*X-Box 360.*Keyboard board', since)
    time.sleep(GUARD_S)  # what is pressed while it is plugged in is not a press
    nothing = '00' * 8
    machine.press_by('B', keys, '0000050000000000', nothing)
    machine.press_by('C', bits, '0200' + '40' + '00' * 14, '02' + '00' * 16)
    say('a board of three interfaces is heard, keys in six bytes and in bits')
    machine.press_by('A', box, '0100', '0000')
    machine.press_by('D', box, '0800', '0000')
    say('a box that counts from 0 has a first button')
    machine.press_by('B', pad, x_input(1, 0x131, 1), x_input(1, 0x131, 0))
    machine.press_by('C', pad, x_input(3, 17, 1), x_input(3, 17, 0))
    machine.press_by('D', pad, x_input(3, 0, -32768), x_input(3, 0, 0))
    say('a pad in X-input mode is heard: its buttons, hat and stick')
    machine.press_by('A', board, '0000040000000000', nothing)
    gone = machine.so_far()
    machine.ask('unplug', hid=pad)
    machine.until('buttons: .*045e:028e was unplugged', gone)
    gone = machine.so_far()
    pad = machine.plug_x_input_pad()
    machine.until(r'buttons: .*X-Box 360 pad 045e:028e\)(?! cannot be opened)', gone)  # once udev has given it away
    time.sleep(GUARD_S)
    machine.press_by('A', pad, x_input(1, 0x130, 1), x_input(1, 0x130, 0))
    say('a board in keyboard mode is heard by the kernel\'s own driver; the pad is unplugged and comes back')
    found = machine.sh('quadrat doctor --only buttons --config /etc/quadrat/quadrat.toml')
    assert 'X-Box 360' in found and '/dev/input/event' in found, found
    machine.sh('cp /root/usual.toml /etc/quadrat/quadrat.toml && sync')


def last_shown(machine):
    """The visit and the round last seen. One that cannot be taken up, for other settings, is followed by the next."""
    visit = round_shown = 0
    for taken, number, begun in re.findall(r'taking up visit (\d+) at|the four of round (\d+) are on|info (a visit begins)',
                                           machine.said()):
        visit = int(taken) if taken else visit + bool(begun)
        round_shown = int(number) if number else round_shown
    return visit, round_shown


def one_day(disk):
    """At its end the plug is pulled; returns the visit and round last seen."""
    with Exhibit(image, f'{folder}/day', disk) as machine:
        boots_and_shows(machine)
        before = clock_source(machine)
        assert before != 'synchronised', 'nobody has synchronised it yet'
        say(f'before it is synchronised, its clock is vouched for by "{before}"')
        machine.ask('synchronise')
        plays_a_round_through_gpio(machine)
        hid = plays_a_round_through_hid(machine)
        is_unplugged_five_times(machine, hid)
        hears_that_its_clock_is_synchronised(machine)
        hangs(machine)
        loses_its_screen(machine)
        hears_boards_as_they_are_sold(machine)
        return last_shown(machine)


def one_evening(machine, shown, chance):
    """Visitors who press whatever they like until the plug is pulled; returns the visit and round last seen."""
    machine.wait()
    machine.plug_wired_buttons()
    hid = machine.plug_encoder()
    start = machine.shows_round(r'\d+')
    taken = re.search(r'taking up visit (\d+) at round (\d+)', start)
    assert taken, f'{shown} was shown, and it begins anew:\n{start}'
    visit, number = map(int, taken.groups())
    assert (visit, number) in (shown, (shown[0], shown[1] + 1)), f'{shown} was shown, and now {taken.group()}'
    end = time.time() + chance.uniform(0, 12)
    while time.time() < end:
        machine.press_and_let_go(hid, chance.randrange(4))
        time.sleep(chance.uniform(0.1, GUARD_S))
    machine.cut_power()
    return last_shown(machine)


def power_cuts(disk, shown):
    """Whatever the moment, the generation that was on the screen is there again; the one in flight may be too."""
    chance = random.Random(1)
    for cut in range(cuts):
        with Exhibit(image, f'{folder}/cut', disk) as machine:
            shown = one_evening(machine, shown, chance)
        say(f'power cut {cut + 1} of {cuts}, visit {shown[0]} in round {shown[1]}')


# The evenings go on with the day's disk: what shaders were compiled to is on it, which takes an emulated processor a minute.
disk = f'{folder}/disk.ext4'
if os.path.exists(disk):
    os.unlink(disk)
try:
    power_cuts(disk, one_day(disk))
    os.unlink(disk)
except (AssertionError, TimeoutError, RuntimeError, EOFError) as error:
    say(f'FAILED: {error}')
    sys.exit(1)
say('everything as it should be')
