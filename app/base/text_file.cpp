// SPDX-License-Identifier: Apache-2.0
#include "base/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/utf8.hpp"

namespace quadrat::base {
namespace {

struct Mark {
    std::string_view bytes;
    std::string_view encoding;
};
// UTF-32 first: its mark begins with that of UTF-16.
constexpr Mark kForeign[] = {{std::string_view("\xFF\xFE\0\0", 4), "UTF-32"},
                             {std::string_view("\0\0\xFE\xFF", 4), "UTF-32"},
                             {"\xFF\xFE", "UTF-16"},
                             {"\xFE\xFF", "UTF-16"}};
constexpr std::string_view kOwnMark = "\xEF\xBB\xBF";

// Half of plain text's bytes are NUL in UTF-16, and all of them stand on one side.
bool looks_like_utf16(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 256);
    std::size_t nuls[2] = {0, 0};
    for (std::size_t i = 0; i < start.size(); ++i) nuls[i % 2] += start[i] == '\0';
    const std::size_t most = std::max(nuls[0], nuls[1]);
    return bytes.size() % 2 == 0 && most > 0 && std::min(nuls[0], nuls[1]) == 0 && 4 * most >= start.size();
}

// Windows ends a line by CR LF; a tool that did so twice leaves CR CR LF. Elsewhere a CR is a character of its line.
void make_line_ends_ours(std::string& text) {
    const bool has_line_feeds = text.find('\n') != std::string::npos;
    if (!has_line_feeds) {
        std::ranges::replace(text, '\r', '\n');
        return;
    }
    std::size_t to = 0;
    for (const char c : text) {
        if (c == '\n')
            while (to > 0 && text[to - 1] == '\r') --to;
        text[to++] = c;
    }
    text.resize(to);
}

void check_line(std::string_view line, std::string_view place, std::size_t limit_bytes) {
    if (line.size() > limit_bytes)
        throw InputError(fmt::format("{}: this line has {} bytes; a line has {} at most: is this the right file?",
                                     place, line.size(), limit_bytes));
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '\0')
            throw InputError(fmt::format("{}: byte {} is NUL, which no text has: the file is damaged, or none of text",
                                         place, at + 1));
        const std::size_t length = utf8_length(line.substr(at));
        if (length == 0)
            throw InputError(
                fmt::format("{}: byte {} is not UTF-8 (0x{:02X}); save the file as UTF-8, not as ANSI or Latin-1",
                            place, at + 1, static_cast<unsigned char>(line[at])));
        at += length;
    }
}

}  // namespace

std::string trouble_of_encoding(std::string_view bytes) {
    std::string_view encoding = looks_like_utf16(bytes) ? "UTF-16" : "";
    const auto* const mark = std::ranges::find_if(kForeign, [&](const Mark& m) { return bytes.starts_with(m.bytes); });
    if (mark != std::end(kForeign)) encoding = mark->encoding;
    if (encoding.empty()) return "";
    return fmt::format("is {} text; save it as UTF-8 (in Windows Notepad: Save as, Encoding: UTF-8)", encoding);
}

std::string text_from(std::string bytes, std::string_view source, const TextLimits& limits) {
    if (bytes.size() > limits.bytes)
        throw InputError(fmt::format("{}: has {} bytes; {} are the most: is this the right file?", source, bytes.size(),
                                     limits.bytes));
    if (const std::string trouble = trouble_of_encoding(bytes); !trouble.empty())
        throw InputError(fmt::format("{}: {}", source, trouble));
    while (std::string_view(bytes).starts_with(kOwnMark)) bytes.erase(0, kOwnMark.size());
    make_line_ends_ours(bytes);
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < bytes.size();) {
        const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
        check_line(std::string_view(bytes).substr(begin, end - begin), fmt::format("{}:{}", source, ++number),
                   limits.line_bytes);
        begin = end + 1;
    }
    return bytes;
}

std::string read_text(const std::filesystem::path& path, const TextLimits& limits) {
    return text_from(read_file(path, limits.bytes), path.string(), limits);
}

}  // namespace quadrat::base
