// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace quadrat::base {

// The whole file. Throws InputError naming the file when it cannot be read or is larger than limit_bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit_bytes = 64U << 20U);

// Replaces path by bytes, whole or not at all: written beside it, flushed to the disk, then renamed.
// Throws InputError naming the file, also where what is there is no file.
void write_file(const std::filesystem::path& path, std::string_view bytes);
// The same, or on standard output where the path is "-".
void print_or_write_file(const std::filesystem::path& path, std::string_view bytes);

// The same as write_file() for a writer that needs a path of its own (a picture library, say). The temporary path keeps
// the extension; when write throws, nothing is left behind.
void write_file_by(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path& temporary)>& write);

// What was written to a file, and what was moved within a folder, is on the disk then. Both throw InputError naming it.
void flush_file(const std::filesystem::path& path);
void flush_folder(const std::filesystem::path& folder);

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
