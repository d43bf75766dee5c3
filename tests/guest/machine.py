# SPDX-License-Identifier: Apache-2.0
"""The host's side of an emulated exhibit machine: power, screen, cable, buttons and a shell in it."""
import base64
import itertools
import json
import os
import select
import shutil
import signal
import socket
import struct
import subprocess
import threading
import time

# Five buttons in one byte, as the simplest encoder on USB sends them.
FIVE_BUTTONS = '05010905a1010509190129051500250175019505810275039501810' + '3c0'
# A CP2112 as the kernel's driver asks for it: eight lines, made a GPIO chip and polled every 40 ms.
CP2112 = ('0600ff0901a10115002600ff7508' +
          ''.join(f'85{number:02x}0901 95{size:02x}b102'.replace(' ', '')
                  for number, size in ((2, 4), (3, 1), (4, 2), (5, 2), (6, 13))) +
          '85130901953f8102' + '85140901953f9102' + 'c0')
CP2112_FEATURES = {2: '0200000000', 3: '0300', 5: '050c02', 6: '06000186a0020000ffff01000f00'}


class Qmp:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
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

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
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
    def __init__(self, image, folder, disk=None):
        """Switches it on. With `disk` it keeps what it writes there, as a power cut leaves it."""
        os.makedirs(folder, exist_ok=True)
        self.folder = folder
        if disk and not os.path.exists(disk):
            subprocess.run(['cp', '--sparse=always', '--reflink=auto', f'{image}/root.ext4', disk], check=True)
        at = {name: os.path.join(folder, name) for name in ('qmp', 'agent', 'vnc', 'serial.log', 'qemu.err')}
        for name in ('qmp', 'agent', 'vnc'):
            if os.path.exists(at[name]):
                os.unlink(at[name])
        drive = f'file={disk or image + "/root.ext4"},if=none,id=d0,format=raw,cache=writeback'
        self.began = time.time()
        self.process = subprocess.Popen(
            ['qemu-system-x86_64', '-M', 'q35,vmport=off', '-accel', 'tcg,thread=multi', '-cpu', 'max', '-smp', '2',
             '-m', '1536', '-nodefaults', '-no-user-config', '-kernel', f'{image}/vmlinuz', '-initrd',
             f'{image}/initrd', '-append',
             'console=ttyS0 quiet loglevel=4 mitigations=off nokaslr random.trust_cpu=on panic=-1 tsc=reliable '
             'systemd.show_status=0 vt.global_cursor_default=0',
             '-drive', drive + ('' if disk else ',snapshot=on'), '-device', 'virtio-blk-pci,drive=d0',
             '-device', 'virtio-rng-pci', '-device', 'virtio-serial-pci',
             '-chardev', f'socket,id=agent,path={at["agent"]},server=on,wait=off',
             '-device', 'virtserialport,chardev=agent,name=guest.0',
             '-device', 'virtio-gpu-pci,xres=640,yres=480', '-vnc', f'unix:{at["vnc"]}',
             '-serial', f'file:{at["serial.log"]}', '-qmp', f'unix:{at["qmp"]},server=on,wait=off', '-no-reboot'],
            stderr=open(at['qemu.err'], 'w'), stdin=subprocess.DEVNULL)
        while not (os.path.exists(at['qmp']) and os.path.exists(at['agent'])):
            if self.process.poll() is not None:
                raise RuntimeError(open(at['qemu.err']).read())
            time.sleep(0.02)
        time.sleep(0.1)
        self.qmp = Qmp(at['qmp'])
        self.agent = socket.socket(socket.AF_UNIX)
        self.agent.connect(at['agent'])
        self.buffer = b''
        self.numbers = itertools.count(1)
        self.cable = None
        self.chip = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.cut_power()

    # ---- the agent
    def message(self, timeout):
        if b'\n' not in self.buffer:
            if not select.select([self.agent], [], [], timeout)[0]:
                return None
            data = self.agent.recv(1 << 16)
            if not data:
                raise EOFError('the agent is gone')
            self.buffer += data
            if b'\n' not in self.buffer:
                return None
        line, self.buffer = self.buffer.split(b'\n', 1)
        return json.loads(line)

    def wait(self, timeout=180):
        """Until the agent is up; returns the seconds since the power came."""
        end = time.time() + timeout
        while time.time() < end:
            message = self.message(1)
            if message and 'up' in message:
                return time.time() - self.began
            if self.process.poll() is not None:
                raise RuntimeError('qemu ended: ' + open(f'{self.folder}/qemu.err').read())
        raise TimeoutError('no agent: ' + open(f'{self.folder}/serial.log', errors='replace').read()[-2000:])

    def ask(self, op, timeout=150, **words):
        number = next(self.numbers)
        self.agent.sendall((json.dumps({'op': op, 'id': number, **words}) + '\n').encode())
        end = time.time() + timeout
        while time.time() < end:
            message = self.message(0.5)
            if message and message.get('id') == number:
                if 'error' in message:
                    raise RuntimeError(message['error'])
                return message
        raise TimeoutError(op)

    def sh(self, command, timeout=120):
        return self.ask('sh', command=command, timeout=timeout)['out']

    def get(self, path):
        return base64.b64decode(self.ask('get', path=path)['bytes'])

    # ---- buttons
    def plug_gpio(self):
        self.chip = self.ask('hid', name='CP2112', vendor=0x10c4, product=0xea90, descriptor=CP2112,
                             features=CP2112_FEATURES)['hid']

    def lines(self, mask):
        self.ask('feature', hid=self.chip, number=3, bytes=f'03{mask:02x}')

    def press_line(self, line, seconds=0.3):
        self.lines(1 << line)
        time.sleep(seconds)
        self.lines(0)
        time.sleep(seconds)

    def plug_hid(self):
        return self.ask('hid', name='Five buttons', vendor=0x1209, product=1, descriptor=FIVE_BUTTONS)['hid']

    def press_hid(self, hid, button, seconds=0.2):
        self.ask('report', hid=hid, bytes=f'{1 << button:02x}')
        time.sleep(seconds)
        self.ask('report', hid=hid, bytes='00')
        time.sleep(seconds)

    # ---- screen and power
    def screenshot(self, path):
        self.qmp('screendump', filename=path, format='png')
        return path

    def screen(self, width, height):
        if not self.cable:
            self.cable = Cable(f'{self.folder}/vnc')
        self.cable.size(width, height)

    def cut_power(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
        self.process.wait()


def has_everything():
    """What is missing for a guest on this machine, or ''."""
    if not shutil.which('qemu-system-x86_64'):
        return 'qemu-system-x86_64 is not installed'
    return ''
