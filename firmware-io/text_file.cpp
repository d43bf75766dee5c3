// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

namespace quadrat::firmware_io {
namespace {

// CRLF, and CR alone where there is no other line end, become LF.
std::string with_line_ends(std::string_view text) {
    const bool has_newlines = text.find('\n') != std::string_view::npos;
    std::string lines;
    lines.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r')
            lines += text[i];
        else if (!has_newlines)
            lines += '\n';
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            lines += '\r';
    }
    return lines;
}

}  // namespace

std::string read_text(const std::filesystem::path& file, std::size_t limit_bytes) {
    const std::string name = file.string();
    std::error_code error;
    // Asked before it is opened: who opens a pipe waits until somebody writes into it.
    if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
        throw TextError{name + ": is not a file; name a readable text file"};
    std::ifstream stream{file, std::ios::binary};
    if (!stream) throw TextError{name + ": cannot read: " + std::strerror(errno)};
    if (std::filesystem::file_size(file, error) > limit_bytes)
        throw TextError{name + ": larger than " + std::to_string(limit_bytes) + " bytes; a text is short"};
    const std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
    std::string_view text = bytes;
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw TextError{name + ": is UTF-16 text; save it as UTF-8 (in Windows Notepad: Save as, Encoding: UTF-8)"};
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (const auto at = text.find('\0'); at != std::string_view::npos) {
        const auto before = text.substr(0, at);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const auto newline = before.rfind('\n');
        const auto byte = at - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
        throw TextError{name + ":" + std::to_string(line) + ": byte " + std::to_string(byte) +
                        " is NUL, which no text has: the file is damaged, or none of text"};
    }
    return with_line_ends(text);
}

}  // namespace quadrat::firmware_io
