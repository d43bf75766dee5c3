// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace quadrat::base {

// The whole file. Throws InputError naming the file when it cannot be read or is larger than limit_bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit_bytes = 64U << 20U);

// Replaces path by bytes, whole or not at all: written beside it, flushed to the disk, then renamed.
// Throws InputError naming the file, also where what is there is no file.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// Throws InputError naming the file where write_file could not leave one: its folder is missing or closed to us, or
// what is there is no file. Asked before long work, so that its result is not lost.
void require_writable(const std::filesystem::path& path);

// The ending that decides a file's format, in small letters: ".png" of "Now.PNG", "" where there is none.
std::string ending_of(const std::filesystem::path& path);

// Throws InputError unless the name has one of these endings ("now.jpg: a shot is written as .png"), or where
// require_writable does: asked before work begins.
void require_ending(const std::filesystem::path& path, std::initializer_list<std::string_view> endings,
                    std::string_view what);

}  // namespace quadrat::base
