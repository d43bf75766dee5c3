// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/image.hpp"

namespace quadrat::render {

// What is asked and said, for who does not read.
enum class Pictogram {
    Tree,
    Land,      // a mountain and a hill
    Sky,       // a cloud before the sun
    Press,     // a finger on a button
    Sprout,    // something grows
    Clock,     // time runs out
    Frame,     // a landscape in its frame
    Speech,    // what do you call it?
    Language,  // a globe
    Slider,
    House,   // take it home
    Moon,    // closed
    Family,  // a tree of pictures
    Person,
    Back,   // an arrow
    Mark,   // what goes from choice to choice
    Sound,  // a loudspeaker
    Print,  // a printer
    Done,   // a tick
};
inline constexpr int kPictograms = 19;

// White, filled, on clear ground, RGBA premultiplied, with the halo that letters have.
mesh::Image pictogram(Pictogram which, int size_px);

}  // namespace quadrat::render
