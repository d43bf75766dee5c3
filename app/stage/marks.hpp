// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/renderer.hpp"

namespace quadrat::stage {

// How thick one line of a mark is on a picture of this height: the whole mark is seven of them, which from three metres
// on a screen of 24 inches is 9 arcminutes, nearly twice what an eye has to tell apart to read.
float mark_line_px(int height_px);

// A frame within the place, for what is marked: dark, its colour, white, dark. The white between the dark is seen on
// any picture and in any colour vision. Around a whole quarter it has white brackets in its corners, as nothing else
// has.
enum class Corners { Plain, Bracketed };
void add_mark(render::Frame& frame, const render::Rect& place, const glm::vec3& colour, Corners corners,
              float corner_px = 0);

// Where a mark covers nothing of this place; it reaches so far beyond it.
render::Rect around(const render::Frame& frame, const render::Rect& place);
int mark_reach_px(int height_px);

}  // namespace quadrat::stage
