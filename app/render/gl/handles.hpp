// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include "base/owned.hpp"

// GL names, each deleted once, on the context's thread.
namespace quadrat::render::gl {

struct DeleteBuffer {
    void operator()(GLuint name) const noexcept { glDeleteBuffers(1, &name); }
};
struct DeleteTexture {
    void operator()(GLuint name) const noexcept { glDeleteTextures(1, &name); }
};
struct DeleteVertexArray {
    void operator()(GLuint name) const noexcept { glDeleteVertexArrays(1, &name); }
};
struct DeleteShader {
    void operator()(GLuint name) const noexcept { glDeleteShader(name); }
};
struct DeleteProgram {
    void operator()(GLuint name) const noexcept { glDeleteProgram(name); }
};

using BufferName = base::Owned<GLuint, DeleteBuffer>;
using TextureName = base::Owned<GLuint, DeleteTexture>;
using VertexArrayName = base::Owned<GLuint, DeleteVertexArray>;
using ShaderName = base::Owned<GLuint, DeleteShader>;
using ProgramName = base::Owned<GLuint, DeleteProgram>;

}  // namespace quadrat::render::gl
