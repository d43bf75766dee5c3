// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/text_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

namespace quadrat::firmware_io {
namespace {

constexpr std::size_t kLongestLine = 64u << 10;

[[noreturn]] void refuse_encoding(const std::string& name, const std::string& encoding) {
    throw TextError{name + ": is " + encoding +
                    " text; save it as UTF-8 (in Windows Notepad: Save as, Encoding: UTF-8)"};
}

// Half of plain text's bytes are NUL in UTF-16, and all of them stand on one side.
bool looks_like_utf16(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 256);
    std::size_t nuls[2] = {0, 0};
    for (std::size_t i = 0; i < start.size(); ++i) nuls[i % 2] += start[i] == '\0';
    const std::size_t most = std::max(nuls[0], nuls[1]);
    return bytes.size() % 2 == 0 && most > 0 && std::min(nuls[0], nuls[1]) == 0 && 4 * most >= start.size();
}

void refuse_foreign(std::string_view bytes, const std::string& name) {
    using namespace std::string_view_literals;
    // UTF-32 first: its mark begins with that of UTF-16.
    if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv)) refuse_encoding(name, "UTF-32");
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff") || looks_like_utf16(bytes))
        refuse_encoding(name, "UTF-16");
}

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

// How many bytes the character at the start of the text takes, by Unicode's table 3-7; 0 where there is none.
std::size_t character_bytes(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint32_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    if (length == 0 || length > text.size()) return 0;
    std::uint32_t code = first & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0u) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::array<std::uint32_t, 3> kLeast{0x80, 0x800, 0x10000};  // below it, the form is too long
    const bool is_character = code >= kLeast[length - 2] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return is_character ? length : 0;
}

std::string in_hex(char c) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const auto byte = static_cast<std::uint8_t>(c);
    return {'0', 'x', kDigits[byte >> 4], kDigits[byte & 0xfu]};
}

void check_line(std::string_view line, const std::string& place) {
    if (line.size() > kLongestLine)
        throw TextError{place + ": this line has " + std::to_string(line.size()) + " bytes; a line has " +
                        std::to_string(kLongestLine) + " at most: is this the right file?"};
    const auto byte = [&](std::size_t at) { return place + ": byte " + std::to_string(at + 1) + " is "; };
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '\0')
            throw TextError{byte(at) + "NUL, which no text has: the file is damaged, or none of text"};
        const std::size_t length = character_bytes(line.substr(at));
        if (length == 0)
            throw TextError{byte(at) + "not UTF-8 (" + in_hex(line[at]) +
                            "); save the file as UTF-8, not as ANSI or Latin-1"};
        at += length;
    }
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
    refuse_foreign(bytes, name);
    std::string_view marked = bytes;
    if (marked.starts_with("\xef\xbb\xbf")) marked.remove_prefix(3);
    std::string text = with_line_ends(marked);
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        check_line(std::string_view{text}.substr(begin, end - begin), name + ":" + std::to_string(++number));
        begin = end + 1;
    }
    return text;
}

}  // namespace quadrat::firmware_io
