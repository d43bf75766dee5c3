// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

namespace quadrat::benches {

// A folder that goes when this does. Throws std::runtime_error where none can be made.
struct Scratch {
    std::filesystem::path path;
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

}  // namespace quadrat::benches
