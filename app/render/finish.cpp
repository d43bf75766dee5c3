// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>

#include "render/renderer.hpp"

namespace quadrat::render {

void Renderer::finish() { glFinish(); }

}  // namespace quadrat::render
