// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <atomic>
#include <cstddef>

#include "base/owned.hpp"

// GL names, each deleted once, on the context's thread.
namespace quadrat::render::gl {

// How many there are: what grows from hour to hour is lost.
class LiveObjects {
  public:
    static std::size_t count() { return count_.load(std::memory_order_relaxed); }
    static void taken() { count_.fetch_add(1, std::memory_order_relaxed); }
    static void left() { count_.fetch_sub(1, std::memory_order_relaxed); }

  private:
    inline static std::atomic<std::size_t> count_{0};
};

struct DeleteBuffer : LiveObjects {
    void operator()(GLuint name) const noexcept { glDeleteBuffers(1, &name); }
};
struct DeleteTexture : LiveObjects {
    void operator()(GLuint name) const noexcept { glDeleteTextures(1, &name); }
};
struct DeleteRenderbuffer : LiveObjects {
    void operator()(GLuint name) const noexcept { glDeleteRenderbuffers(1, &name); }
};
struct DeleteVertexArray : LiveObjects {
    void operator()(GLuint name) const noexcept { glDeleteVertexArrays(1, &name); }
};
struct DeleteShader : LiveObjects {
    void operator()(GLuint name) const noexcept { glDeleteShader(name); }
};
struct DeleteProgram : LiveObjects {
    void operator()(GLuint name) const noexcept { glDeleteProgram(name); }
};

using BufferName = base::Owned<GLuint, DeleteBuffer>;
using TextureName = base::Owned<GLuint, DeleteTexture>;
using RenderbufferName = base::Owned<GLuint, DeleteRenderbuffer>;
using VertexArrayName = base::Owned<GLuint, DeleteVertexArray>;
using ShaderName = base::Owned<GLuint, DeleteShader>;
using ProgramName = base::Owned<GLuint, DeleteProgram>;

}  // namespace quadrat::render::gl
