// SPDX-License-Identifier: Apache-2.0
#include "genome/scene_code.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "genome/code_layout_texts.hpp"
#include "genome/json_text.hpp"

namespace quadrat::genome {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
constexpr int kLetterBits = 5;
constexpr int kRealBits = 8;
constexpr int kSeedBits = 64;
constexpr int kChecksumBits = 32;
constexpr std::size_t kShortest = 20;  // letters of what can be taken for a code at all

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// Most significant bit first.
class BitWriter {
  public:
    void write(std::uint64_t value, int bits) {
        for (int i = bits - 1; i >= 0; --i, ++count_) {
            if (count_ % 8 == 0) bytes_.push_back(0);
            bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | ((value >> i & 1U) << (7 - count_ % 8)));
        }
    }
    const Bytes& bytes() const { return bytes_; }

  private:
    Bytes bytes_;
    std::size_t count_ = 0;
};

class BitReader {
  public:
    explicit BitReader(const Bytes& bytes) : bytes_(bytes) {}
    std::uint64_t read(int bits) {
        std::uint64_t value = 0;
        for (int i = 0; i < bits; ++i, ++at_) value = value << 1U | (bytes_[at_ / 8] >> (7 - at_ % 8) & 1U);
        return value;
    }

  private:
    const Bytes& bytes_;
    std::size_t at_ = 0;
};

std::uint32_t checksum(std::size_t version, const Bytes& bytes, std::size_t count) {
    const auto number = static_cast<std::uint8_t>(version);
    const uLong with_version = ::crc32(::crc32(0, nullptr, 0), &number, 1);
    return static_cast<std::uint32_t>(::crc32(with_version, bytes.data(), static_cast<uInt>(count)));
}

std::size_t bytes_before_checksum(const CodeLayout& layout) {
    int bits = static_cast<int>(kAspects.size() + 1) * kSeedBits;
    for (const CodeField& field : layout) bits += field.bits;
    return static_cast<std::size_t>((bits + 7) / 8);
}

std::size_t letters_for(std::size_t bytes) { return (bytes * 8 + kLetterBits - 1) / kLetterBits; }

std::uint64_t step_of(const CodeField& field, float value) {
    const auto steps = static_cast<double>((1U << static_cast<unsigned>(field.bits)) - 1U);
    const double low = static_cast<double>(field.min), wide = static_cast<double>(field.max) - low;
    const double above = static_cast<double>(std::clamp(value, field.min, field.max)) - low;
    return static_cast<std::uint64_t>(std::llround(field.is_whole ? above : above / wide * steps));
}

float value_of(const CodeField& field, std::uint64_t step) {
    const auto steps = static_cast<double>((1U << static_cast<unsigned>(field.bits)) - 1U);
    const double low = static_cast<double>(field.min), wide = static_cast<double>(field.max) - low;
    const double above = field.is_whole ? static_cast<double>(step) : wide * static_cast<double>(step) / steps;
    return static_cast<float>(low + above);
}

// What of the text is a code: from the last Q that digits and a hyphen follow, to its end.
struct Parts {
    std::string version;
    std::string letters;
};
std::optional<Parts> parts_of(std::string_view text) {
    const std::size_t hyphen = text.rfind('-');
    if (hyphen == std::string_view::npos) return std::nullopt;
    std::size_t first = hyphen;
    while (first > 0 && text[first - 1] >= '0' && text[first - 1] <= '9') --first;
    const bool has_version = first < hyphen && first > 0 && upper(text[first - 1]) == 'Q';
    Parts parts{std::string(text.substr(first, hyphen - first)), std::string(text.substr(hyphen + 1))};
    for (char& c : parts.letters) c = upper(c);
    const bool is_base_32 = parts.letters.find_first_not_of(kLetters) == std::string::npos;
    if (!has_version || !is_base_32 || parts.letters.size() < kShortest) return std::nullopt;
    return parts;
}

// Nothing where the last letter says more than it can have been written to say.
std::optional<Bytes> bytes_of(const std::string& letters, std::size_t count) {
    BitWriter writer;
    for (const char c : letters) writer.write(kLetters.find(c), kLetterBits);
    Bytes bytes = writer.bytes();
    const auto rest = bytes.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::any_of(rest, bytes.end(), [](std::uint8_t byte) { return byte != 0; })) return std::nullopt;
    bytes.resize(count);
    return bytes;
}

bool is_whole(const Bytes& bytes, std::size_t version) {
    const std::size_t before = bytes.size() - kChecksumBits / 8;
    BitReader reader(bytes);
    for (std::size_t i = 0; i < before; ++i) reader.read(8);
    return reader.read(kChecksumBits) == checksum(version, bytes, before);
}

[[noreturn]] void refuse(std::string_view source, const std::string& what) {
    throw base::InputError(fmt::format("{}: {}", source, what));
}

}  // namespace

std::string code_of(const Recipe& recipe, const std::vector<CodeLayout>& layouts) {
    const std::size_t version = layouts.size();
    BitWriter writer;
    for (const CodeField& field : layouts.back()) {
        const auto id = parameter_named(field.name);
        writer.write(id ? step_of(field, recipe.values[*id]) : 0, field.bits);
    }
    for (const Aspect aspect : kAspects) writer.write(recipe.seeds[aspect].value, kSeedBits);
    writer.write(recipe.flight.value, kSeedBits);
    Bytes bytes = writer.bytes();
    const std::uint32_t sum = checksum(version, bytes, bytes.size());
    for (int shift = kChecksumBits - 8; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::uint8_t>(sum >> static_cast<unsigned>(shift)));
    std::string code = fmt::format("Q{}-", version);
    bytes.push_back(0);  // the last letter may reach beyond
    BitReader reader(bytes);
    for (std::size_t i = 0; i < letters_for(bytes.size() - 1); ++i) code += kLetters[reader.read(kLetterBits)];
    return code;
}

bool has_code(std::string_view text) { return parts_of(text).has_value(); }

Recipe recipe_of_code(std::string_view text, std::string_view source, const std::vector<CodeLayout>& layouts) {
    const auto parts = parts_of(text);
    if (!parts) refuse(source, "this is no scene code; one begins with Q, a number and a hyphen");
    std::size_t version = 0;
    std::from_chars(parts->version.data(), parts->version.data() + parts->version.size(), version);
    if (version < 1 || version > layouts.size())
        refuse(source,
               fmt::format("the code is of version {}; this program reads versions 1 to {}; a newer one may more",
                           parts->version, layouts.size()));
    const CodeLayout& layout = layouts[version - 1];
    const std::size_t all = bytes_before_checksum(layout) + kChecksumBits / 8;
    if (parts->letters.size() != letters_for(all))
        refuse(source, fmt::format("the code has {} letters behind the hyphen; it should have {}",
                                   parts->letters.size(), letters_for(all)));
    const auto bytes = bytes_of(parts->letters, all);
    if (!bytes || !is_whole(*bytes, version))
        refuse(source, "a letter of the code is not as it was written; read it again");
    Recipe recipe;
    BitReader reader(*bytes);
    for (const CodeField& field : layout) {
        const std::uint64_t step = reader.read(field.bits);
        if (const auto id = parameter_named(field.name)) recipe.values.set(*id, value_of(field, step));
    }
    for (const Aspect aspect : kAspects) recipe.seeds[aspect] = base::Seed{reader.read(kSeedBits)};
    recipe.flight = base::Seed{reader.read(kSeedBits)};
    return recipe;
}

ParameterValues rounded_for_code(const ParameterValues& values) {
    ParameterValues rounded;
    for (const CodeField& field : code_layouts().back())
        if (const auto id = parameter_named(field.name)) rounded.set(*id, value_of(field, step_of(field, values[*id])));
    return rounded;
}

std::string code_of(const Recipe& recipe) { return code_of(recipe, code_layouts()); }

Recipe recipe_of_code(std::string_view text, std::string_view source) {
    return recipe_of_code(text, source, code_layouts());
}

CodeLayout layout_of_the_table() {
    CodeLayout layout;
    for (const Parameter& p : parameter_table()) {
        const bool is_whole = p.unit.empty() || p.unit == kChoice;
        int bits = is_whole ? 1 : kRealBits;
        while (is_whole && static_cast<float>((1U << static_cast<unsigned>(bits)) - 1U) < p.max - p.min) ++bits;
        layout.push_back({std::string(p.name), p.min, p.max, bits, is_whole});
    }
    return layout;
}

std::string to_text(const CodeLayout& layout) {
    std::string text;
    for (const CodeField& field : layout)
        text += fmt::format("{} {} {} {} {}\n", field.name, shortest(field.min), shortest(field.max), field.bits,
                            field.is_whole ? "whole" : "real");
    return text;
}

CodeLayout layout_from(std::string_view text) {
    CodeLayout layout;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        CodeField field{};
        std::string kind;
        words >> field.name >> field.min >> field.max >> field.bits >> kind;
        assert(words && field.bits >= 1 && field.bits <= 16 && field.max > field.min);
        field.is_whole = kind == "whole";
        layout.push_back(std::move(field));
    }
    return layout;
}

const std::vector<CodeLayout>& code_layouts() {
    static const std::vector<CodeLayout> layouts = [] {
        std::vector<CodeLayout> all(code_layout_texts().size());
        for (const base::EmbeddedText& text : code_layout_texts()) {
            std::size_t version = 0;
            std::from_chars(text.name.data(), text.name.data() + text.name.size(), version);
            assert(version >= 1 && version <= all.size());
            all[version - 1] = layout_from(text.text);
        }
        return all;
    }();
    return layouts;
}

Candidate candidate_of_code(std::string_view text, std::string_view source) {
    return candidate_of(recipe_of_code(text, source));
}

}  // namespace quadrat::genome
