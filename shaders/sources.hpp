// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string_view>

// GLSL ES 3.10, compiled into the binary with every #include already in place.
namespace quadrat::shaders {

struct Source {
    std::string_view name;                    // "water.frag"
    std::string_view text;                    // #line directives number the files below
    std::span<const std::string_view> files;  // by that number; from the repository's root
};

std::span<const Source> sources();

// Asserts that there is one of this name.
const Source& source(std::string_view name);

}  // namespace quadrat::shaders
