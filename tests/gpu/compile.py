# SPDX-License-Identifier: Apache-2.0
"""compile.py FOLDER x.vert+x.frag[*SAMPLES]…: links each pair and draws a triangle with it, with so many samples a pixel, so that
the driver compiles what it would draw with; its statistics come out by V3D_DEBUG=shaderdb. Nothing but ctypes: it runs in a system that was only unpacked."""
import ctypes
import os
import sys

egl, gl = ctypes.CDLL('libEGL.so.1'), ctypes.CDLL('libGLESv2.so.2')
pointer = ctypes.c_void_p
egl.eglGetPlatformDisplay.restype, egl.eglGetPlatformDisplay.argtypes = pointer, [ctypes.c_uint, pointer, pointer]
egl.eglInitialize.argtypes = [pointer] * 3
egl.eglChooseConfig.argtypes = [pointer, pointer, pointer, ctypes.c_int, pointer]
egl.eglCreateContext.restype, egl.eglCreateContext.argtypes = pointer, [pointer] * 4
egl.eglMakeCurrent.argtypes = [pointer] * 4
SURFACELESS, OPENGL_ES, NONE = 0x31DD, 0x30A0, 0x3038
VERTEX_SHADER, FRAGMENT_SHADER, COMPILE_STATUS, LINK_STATUS = 0x8B31, 0x8B30, 0x8B81, 0x8B82
TEXTURE_2D, RGBA8, ARRAY_BUFFER, UNIFORM_BUFFER, FRAMEBUFFER = 0x0DE1, 0x8058, 0x8892, 0x8A11, 0x8D40
RENDERBUFFER, COLOUR = 0x8D41, 0x8CE0


def name_from(generate):
    name = ctypes.c_uint()
    generate(1, ctypes.byref(name))
    return name


def texture(side):
    gl.glBindTexture(TEXTURE_2D, name := name_from(gl.glGenTextures))
    gl.glTexStorage2D(TEXTURE_2D, 1, RGBA8, side, side)
    return name


def is_good(ask, thing, what):
    value = ctypes.c_int()
    ask(thing, what, ctypes.byref(value))
    return value.value


def said(ask, thing):
    text = ctypes.create_string_buffer(8192)
    ask(thing, len(text), None, text)
    return text.value.decode(errors='replace')


def context():
    display = egl.eglGetPlatformDisplay(SURFACELESS, None, None)
    if not egl.eglInitialize(display, None, None):
        sys.exit('EGL does not start')
    egl.eglBindAPI(OPENGL_ES)
    configs, count = (pointer * 1)(), ctypes.c_int()
    egl.eglChooseConfig(display, (ctypes.c_int * 5)(0x3040, 0x40, 0x3033, 0, NONE), configs, 1, ctypes.byref(count))
    made = egl.eglCreateContext(display, configs[0] if count.value else None, None, (ctypes.c_int * 5)(0x3098, 3, 0x30FB, 1, NONE))
    if not made or not egl.eglMakeCurrent(display, None, None, made):
        sys.exit('no OpenGL ES 3.1')


def program_of(folder, names):
    program = gl.glCreateProgram()
    for kind, name in zip((VERTEX_SHADER, FRAGMENT_SHADER), names):
        shader = gl.glCreateShader(kind)
        with open(os.path.join(folder, name), 'rb') as file:
            gl.glShaderSource(shader, 1, ctypes.byref(ctypes.c_char_p(file.read())), None)
        gl.glCompileShader(shader)
        if not is_good(gl.glGetShaderiv, shader, COMPILE_STATUS):
            sys.exit(f'{name}: {said(gl.glGetShaderInfoLog, shader)}')
        gl.glAttachShader(program, shader)
    gl.glLinkProgram(program)
    if not is_good(gl.glGetProgramiv, program, LINK_STATUS):
        sys.exit(f'{names}: {said(gl.glGetProgramInfoLog, program)}')
    return program


def bind_target(samples):
    gl.glBindFramebuffer(FRAMEBUFFER, name_from(gl.glGenFramebuffers))
    if samples == 1:
        gl.glFramebufferTexture2D(FRAMEBUFFER, COLOUR, TEXTURE_2D, texture(64), 0)
        return
    gl.glBindRenderbuffer(RENDERBUFFER, colour := name_from(gl.glGenRenderbuffers))
    gl.glRenderbufferStorageMultisample(RENDERBUFFER, samples, RGBA8, 64, 64)
    gl.glFramebufferRenderbuffer(FRAMEBUFFER, COLOUR, RENDERBUFFER, colour)
    if gl.glCheckFramebufferStatus(FRAMEBUFFER) != 0x8CD5:
        sys.exit(f'no target of {samples} samples a pixel')


def draw_with(folder, pair, samples):
    context()
    bind_target(samples)
    gl.glViewport(0, 0, 64, 64)
    gl.glBindVertexArray(name_from(gl.glGenVertexArrays))
    gl.glBindBuffer(ARRAY_BUFFER, name_from(gl.glGenBuffers))
    gl.glBufferData(ARRAY_BUFFER, ctypes.c_ssize_t(4096), None, 0x88E4)
    for attribute in range(16):
        gl.glEnableVertexAttribArray(attribute)
        gl.glVertexAttribPointer(attribute, 4, 0x1406, 0, 0, None)
    gl.glBindBuffer(UNIFORM_BUFFER, uniforms := name_from(gl.glGenBuffers))
    gl.glBufferData(UNIFORM_BUFFER, ctypes.c_ssize_t(65536), None, 0x88E4)
    for binding in range(4):
        gl.glBindBufferBase(UNIFORM_BUFFER, binding, uniforms)
    for unit in range(4):
        gl.glActiveTexture(0x84C0 + unit)
        texture(16)
    gl.glUseProgram(program_of(folder, pair.split('+')))
    gl.glDrawArrays(4, 0, 3)
    gl.glFlush()


# A process a pair: a device that does nothing finishes nothing, and a second draw might wait for the first.
for pair in sys.argv[2:]:
    print('PAIR', pair, flush=True)
    child = os.fork()
    if child == 0:
        name, _, samples = pair.partition('*')
        draw_with(sys.argv[1], name, int(samples or 1))
        os._exit(0)  # the driver's own end is not what is looked at
    if os.waitpid(child, 0)[1] != 0:
        sys.exit(1)
