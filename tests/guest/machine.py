# SPDX-License-Identifier: Apache-2.0
"""The host's side of an emulated exhibit machine: power, screen, cable, buttons, what it says, and a shell in it.

Waits end when what is waited for has happened. Their limits are for a machine that has stopped: a slow one, and a busy
host, only take longer."""
import base64
import itertools
import json
import os
import re
import select
import socket
import struct
import subprocess
import threading
import time

PATIENCE = 1800

# Five buttons in one byte, as the simplest encoder on USB sends them.
FIVE_BUTTONS = '05010905a101050919012905150025017501950581027503950181' + '03c0'
# A CP2112 as the kernel's driver asks for it: eight lines, made a GPIO chip and polled every 40 ms.
CP2112 = ('0600ff0901a10115002600ff7508' +
          ''.join(f'85{number:02x}090195{size:02x}b102' for number, size in ((2, 4), (3, 1), (4, 2), (5, 2), (6, 13))) +
          '85130901953f8102' + '85140901953f9102' + 'c0')
CP2112_FEATURES = {2: '0200000000', 3: '0300', 5: '050c02', 6: '06000186a0020000ffff01000f00'}

# Six keys at most, as a keyboard sends them to a BIOS; and a bit for each key, in a report with the number 2.
BOOT_KEYBOARD = ('05010906a101050719e029e71500250175019508810295017508810195067508150025650507190029658100c0')
BITMAP_KEYBOARD = '05010906a1018502050719e029e715002501750195088102190029771500250175019578' + '8102c0'
# Sixteen buttons, the first of which has the number that means "none".
BOX_FROM_0 = '05010904a101050919002910150025017501951081' + '02c0'
# What xpad makes of a pad in X-input mode.
XPAD_KEYS = [0x130, 0x131, 0x133, 0x134, 0x136, 0x137, 0x13a, 0x13b, 0x13c, 0x13d, 0x13e]
XPAD_AXES = {0: (-32768, 32767), 1: (-32768, 32767), 2: (0, 255), 3: (-32768, 32767), 4: (-32768, 32767), 5: (0, 255),
             16: (-1, 1), 17: (-1, 1)}


def connected(path, is_alive):
    while is_alive():
        try:
            connection = socket.socket(socket.AF_UNIX)
            connection.connect(path)
            return connection
        except OSError:
            time.sleep(0.02)
    raise RuntimeError('qemu ended')


class Qmp:
    def __init__(self, connection):
        self.socket = connection
        self.file = self.socket.makefile('rw')
        json.loads(self.file.readline())
        self('qmp_capabilities')

    def __call__(self, command, **arguments):
        self.file.write(json.dumps({'execute': command, 'arguments': arguments}) + '\n')
        self.file.flush()
        while True:
            answer = json.loads(self.file.readline() or '{"error": "qemu is gone"}')
            if 'event' in answer:
                continue
            if 'error' in answer:
                raise RuntimeError(answer['error'])
            return answer['return']


class Cable:
    """A VNC client that only says how large its window is: 0 by 0 is a cable that was pulled."""

    def __init__(self, connection):
        self.socket = connection
        self.read(12)
        self.socket.sendall(b'RFB 003.008\n')
        self.read(self.read(1)[0])
        self.socket.sendall(b'\1')
        self.read(4)
        self.socket.sendall(b'\1')
        self.read(20)
        self.read(struct.unpack('>I', self.read(4))[0])
        raw, extended_desktop_size = 0, -308
        self.socket.sendall(struct.pack('>BxH', 2, 2) + struct.pack('>ii', raw, extended_desktop_size))
        self.socket.sendall(struct.pack('>BBHHHH', 3, 0, 0, 0, 1, 1))
        threading.Thread(target=self.drain, daemon=True).start()

    def read(self, count):
        data = b''
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            if not more:
                raise EOFError
            data += more
        return data

    def drain(self):
        try:
            while self.socket.recv(65536):
                pass
        except OSError:
            pass

    def size(self, width, height):
        self.socket.sendall(struct.pack('>BxHHBx', 251, width, height, 1) +
                            struct.pack('>IHHHHI', 0, 0, 0, width, height, 0))


class Machine:
    def __init__(self, image, folder, disk=None, second_disk=None, words=''):
        """Switches it on. With `disk` it keeps what it writes there, as a power cut leaves it. `words` are added to the
        kernel's."""
        os.makedirs(folder, exist_ok=True)
        self.folder = folder
        if disk and not os.path.exists(disk):
            subprocess.run(['cp', '--sparse=always', '--reflink=auto', f'{image}/root.ext4', disk], check=True)
        at = {name: os.path.join(folder, name) for name in ('qmp', 'agent', 'vnc', 'serial.log', 'qemu.err')}
        for path in at.values():
            if os.path.exists(path):
                os.unlink(path)
        drive = f'file={disk or image + "/root.ext4"},if=none,id=d0,format=raw,cache=writeback'
        self.began = time.time()
        # Its journal comes out of the serial line: whoever listens takes no time from it. A processor without AVX: with
        # QEMU 7.2's emulated one, what LLVM 19 makes of shaders in Debian 13 ends in SIGSEGV, and on a real one it does not.
        self.process = subprocess.Popen(
            ['qemu-system-x86_64', '-M', 'q35,vmport=off', '-accel', 'tcg,thread=multi', '-cpu', 'Nehalem', '-smp', '2',
             '-m', '1536', '-nodefaults', '-no-user-config', '-kernel', f'{image}/vmlinuz', '-initrd',
             f'{image}/initrd', '-append',
             'console=ttyS0 quiet loglevel=4 mitigations=off nokaslr random.trust_cpu=on panic=-1 tsc=reliable '
             'systemd.show_status=0 vt.global_cursor_default=0 systemd.journald.forward_to_console=1 '
             'systemd.journald.max_level_console=info ' + words,
             '-drive', drive + ('' if disk else ',snapshot=on'), '-device', 'virtio-blk-pci,drive=d0',
             *(['-drive', f'file={second_disk},if=none,id=d1,format=raw,cache=writeback', '-device',
                'virtio-blk-pci,drive=d1'] if second_disk else []),
             '-device', 'virtio-rng-pci', '-device', 'virtio-serial-pci',
             '-chardev', f'socket,id=agent,path={at["agent"]},server=on,wait=off',
             '-device', 'virtserialport,chardev=agent,name=guest.0',
             '-device', 'virtio-gpu-pci,xres=320,yres=240', '-vnc', f'unix:{at["vnc"]}',
             '-serial', f'file:{at["serial.log"]}', '-qmp', f'unix:{at["qmp"]},server=on,wait=off', '-no-reboot'],
            stderr=open(at['qemu.err'], 'w'), stdin=subprocess.DEVNULL)
        self.agent = connected(at['agent'], self.is_alive)
        self.qmp = Qmp(connected(at['qmp'], self.is_alive))
        self.buffer = b''
        self.numbers = itertools.count(1)
        self.cable = None
        self.chip = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.cut_power()

    def is_alive(self):
        if self.process.poll() is None:
            return True
        raise RuntimeError('qemu ended: ' + open(f'{self.folder}/qemu.err').read())

    # ---- what it says
    def said(self, since=0):
        """What came out of its serial line after so many characters."""
        with open(f'{self.folder}/serial.log', 'rb') as file:
            file.seek(since)
            return file.read().decode(errors='replace').replace('\r', '')

    def so_far(self):
        return os.path.getsize(f'{self.folder}/serial.log')

    def until(self, what, since=0):
        """Until it says it; returns what it said since then."""
        end = time.time() + PATIENCE
        while self.is_alive() and time.time() < end:
            text = self.said(since)
            if re.search(what, text):
                return text
            time.sleep(0.25)
        raise TimeoutError(f'"{what}" was not said within {PATIENCE} s; it said at last:\n{self.said()[-4000:]}')

    # ---- the agent
    def message(self):
        if b'\n' not in self.buffer:
            if not select.select([self.agent], [], [], 0.5)[0]:
                return None
            data = self.agent.recv(1 << 16)
            if not data:
                raise EOFError('the agent is gone')
            self.buffer += data
            if b'\n' not in self.buffer:
                return None
        line, self.buffer = self.buffer.split(b'\n', 1)
        return json.loads(line)

    def wait(self):
        """Until the agent is up; returns the seconds since the power came."""
        end = time.time() + PATIENCE
        while self.is_alive() and time.time() < end:
            if 'up' in (self.message() or {}):
                return time.time() - self.began
        raise TimeoutError('no agent: ' + self.said()[-4000:])

    def ask(self, op, **words):
        number = next(self.numbers)
        self.agent.sendall((json.dumps({'op': op, 'id': number, **words}) + '\n').encode())
        end = time.time() + PATIENCE
        while self.is_alive() and time.time() < end:
            message = self.message()
            if message and message.get('id') == number:
                if 'error' in message:
                    raise RuntimeError(f'{op}: {message["error"]}')
                return message
        raise TimeoutError(f'{op} {words}')

    def sh(self, command):
        return self.ask('sh', command=command, timeout=PATIENCE / 2)['out']

    def get(self, path):
        return base64.b64decode(self.ask('get', path=path)['bytes'])

    # ---- buttons
    def plug_gpio(self):
        self.chip = self.ask('hid', name='CP2112', vendor=0x10c4, product=0xea90, descriptor=CP2112,
                             features=CP2112_FEATURES)['hid']

    def lines(self, mask):
        """Which lines are closed; returns when the chip's driver has read it more than once."""
        self.ask('show', hid=self.chip, number=3, bytes=f'03{mask:02x}', times=4, timeout=PATIENCE / 2)

    def plug_hid(self):
        return self.ask('hid', name='Five buttons', vendor=0x1209, product=1, descriptor=FIVE_BUTTONS)['hid']

    def plug(self, name, vendor, product, descriptor, port):
        return self.ask('hid', name=name, vendor=vendor, product=product, descriptor=descriptor, port=port)['hid']

    def plug_x_input_pad(self):
        return self.ask('pad', name='Microsoft X-Box 360 pad', vendor=0x45e, product=0x28e, keys=XPAD_KEYS,
                        axes=XPAD_AXES, port='usb-guest-3/input0')['hid']

    def press_and_let_go(self, hid, button):
        """Both in one breath, so that no stall of the host makes a long press of it."""
        self.ask('report', hid=hid, reports=[f'{1 << button:02x}', '00'])

    # ---- screen and power
    def screenshot(self, path):
        """As a plain PPM."""
        self.qmp('screendump', filename=path)
        return path

    def screen(self, width, height):
        if not self.cable:
            self.cable = Cable(connected(f'{self.folder}/vnc', self.is_alive))
        self.cable.size(width, height)

    def cut_power(self):
        self.process.kill()
        self.process.wait()
