// SPDX-License-Identifier: Apache-2.0
#include "display/window/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>

namespace quadrat::display {
namespace {

struct Pair {
    int token;
    Key key;
};
constexpr std::array kPairs{
    Pair{GLFW_KEY_A, Key::A},           Pair{GLFW_KEY_B, Key::B},
    Pair{GLFW_KEY_C, Key::C},           Pair{GLFW_KEY_D, Key::D},
    Pair{GLFW_KEY_F, Key::F},           Pair{GLFW_KEY_H, Key::H},
    Pair{GLFW_KEY_P, Key::P},           Pair{GLFW_KEY_Q, Key::Q},
    Pair{GLFW_KEY_R, Key::R},           Pair{GLFW_KEY_S, Key::S},
    Pair{GLFW_KEY_1, Key::One},         Pair{GLFW_KEY_2, Key::Two},
    Pair{GLFW_KEY_3, Key::Three},       Pair{GLFW_KEY_4, Key::Four},
    Pair{GLFW_KEY_KP_1, Key::One},      Pair{GLFW_KEY_KP_2, Key::Two},
    Pair{GLFW_KEY_KP_3, Key::Three},    Pair{GLFW_KEY_KP_4, Key::Four},
    Pair{GLFW_KEY_SPACE, Key::Space},   Pair{GLFW_KEY_ENTER, Key::Enter},
    Pair{GLFW_KEY_ESCAPE, Key::Escape}, Pair{GLFW_KEY_BACKSPACE, Key::Backspace},
    Pair{GLFW_KEY_TAB, Key::Tab},       Pair{GLFW_KEY_LEFT, Key::Left},
    Pair{GLFW_KEY_RIGHT, Key::Right},   Pair{GLFW_KEY_UP, Key::Up},
    Pair{GLFW_KEY_DOWN, Key::Down},     Pair{GLFW_KEY_F1, Key::F1},
    Pair{GLFW_KEY_F2, Key::F2},         Pair{GLFW_KEY_F5, Key::F5},
    Pair{GLFW_KEY_F11, Key::F11},       Pair{GLFW_KEY_F12, Key::F12},
};

}  // namespace

std::optional<Key> key_from_glfw(int token) {
    for (const Pair& pair : kPairs)
        if (pair.token == token) return pair.key;
    return std::nullopt;
}

}  // namespace quadrat::display
