// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "render/gl/handles.hpp"
#include "shaders/sources.hpp"

namespace quadrat::render::gl {

// A vertex and a fragment shader, linked. Throws InputError naming the shader's file and line and what the driver said.
class Program {
  public:
    Program(const shaders::Source& vertex, const shaders::Source& fragment);
    Program(std::string_view vertex_name, std::string_view fragment_name)
        : Program(shaders::source(vertex_name), shaders::source(fragment_name)) {}

    // While wires are on: the same vertices in one colour.
    void use() const;
    GLuint name() const { return name_.get(); }

  private:
    ProgramName name_;
    shaders::Source vertex_;
    mutable std::unique_ptr<Program> wired_;  // made when it is first asked for
};

// The driver's "2:14(5): error: …" as "shaders/common/haze.glsl:14(5): error: …"; other lines as they are.
std::string with_file_names(std::string_view driver_log, const shaders::Source& source);

}  // namespace quadrat::render::gl
