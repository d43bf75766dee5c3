// SPDX-License-Identifier: Apache-2.0
#include "desk/secrets.hpp"

#include <algorithm>
#include <cctype>

namespace quadrat::desk {
namespace {

constexpr std::string_view kHidden = "•••";
constexpr std::size_t kShortest = 4;

bool is_space(char c) { return c == ' ' || c == '\t'; }
bool is_end(char c) { return is_space(c) || c == ',' || c == ';' || c == '"' || c == '\''; }

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

void hide(std::string& line, const std::string& secret) {
    if (secret.size() < kShortest) return;
    for (std::size_t at = line.find(secret); at != std::string::npos; at = line.find(secret, at + kHidden.size()))
        line.replace(at, secret.size(), kHidden);
}

// After "password=x" and "password: x"; "the password is read from a file" stays.
void hide_after(std::string& line, std::string_view word) {
    for (std::size_t at = in_small_letters(line).find(word); at != std::string::npos;
         at = in_small_letters(line).find(word, at)) {
        at += word.size();
        std::size_t from = at;
        while (from < line.size() && (line[from] == '"' || is_space(line[from]))) ++from;
        if (from >= line.size() || (line[from] != '=' && line[from] != ':')) continue;
        ++from;
        while (from < line.size() && (is_space(line[from]) || line[from] == '"' || line[from] == '\'')) ++from;
        std::size_t end = from;
        while (end < line.size() && !is_end(line[end])) ++end;
        line.replace(from, end - from, kHidden);
        at = from + kHidden.size();
    }
}

// "mqtt://user:password@host": up to the last "@" before the address ends.
void hide_in_addresses(std::string& line) {
    for (std::size_t at = line.find("://"); at != std::string::npos; at = line.find("://", at)) {
        at += 3;
        std::size_t end = at;
        while (end < line.size() && !is_space(line[end]) && line[end] != '/') ++end;
        const std::size_t sign = line.substr(at, end - at).rfind('@');
        if (sign == std::string::npos) continue;
        const std::size_t colon = line.substr(at, sign).find(':');
        if (colon == std::string::npos) continue;
        line.replace(at + colon + 1, sign - colon - 1, kHidden);
    }
}

}  // namespace

std::string without_secrets(std::string_view text, const std::vector<std::string>& secrets) {
    std::string line(text);
    for (const std::string& secret : secrets) hide(line, secret);
    for (const char* word : {"password", "passphrase", "passwd", "token", "secret"}) hide_after(line, word);
    hide_in_addresses(line);
    return line;
}

}  // namespace quadrat::desk
