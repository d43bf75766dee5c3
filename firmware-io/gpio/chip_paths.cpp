// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include "firmware-io/gpio/libgpiod.hpp"

namespace quadrat::firmware_io::gpio {

std::vector<std::string> chip_paths() {
    std::vector<std::string> paths;
    std::error_code error;
    for (std::filesystem::directory_iterator entry{"/dev", error}, end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        const bool is_chip = entry->path().filename().string().starts_with("gpiochip") && !entry->is_symlink(unknown) &&
                             entry->is_character_file(unknown);
        if (is_chip) paths.push_back(entry->path().string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace quadrat::firmware_io::gpio
