// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace quadrat::firmware_io {

// A text file that cannot be used: "FILE: what is wrong; what would be right".
struct TextError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A small text from outside, as app/base/text_file.hpp reads larger ones and in its words (one test feeds both); this
// room includes nothing of app/. Lines end with '\n' alone; a byte order mark is dropped. Throws TextError for UTF-16
// and UTF-32, for a NUL byte, for what is no UTF-8, for a line of more than 64 KiB, for what is larger, and where there
// is no such file.
std::string read_text(const std::filesystem::path& file, std::size_t limit_bytes);

}  // namespace quadrat::firmware_io
