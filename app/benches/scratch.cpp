// SPDX-License-Identifier: Apache-2.0
#include "benches/scratch.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace quadrat::benches {

Scratch::Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "quadrat-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder could be made in " + name);
    path = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

}  // namespace quadrat::benches
