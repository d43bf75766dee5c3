// SPDX-License-Identifier: Apache-2.0
// Adobe, "TIFF", revision 6.0 (1992), section 2, and BigTIFF (2007), which has 8 bytes where TIFF has 4; the tag 42113
// is of GDAL's driver GTiff: a number as text. OpenImageIO passes over it.
#include "pictures/images/tiff_nodata.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace quadrat::pictures {
namespace {

constexpr std::uint64_t kTiff = 42, kBigTiff = 43, kGdalNodata = 42113, kAscii = 2;

// Numbers at any place: 0 beyond the end.
class Tiff {
  public:
    explicit Tiff(std::string_view bytes) : bytes_(bytes), is_little_(bytes.starts_with("II")) {
        const bool is_tiff = is_little_ || bytes.starts_with("MM");
        const std::uint64_t kind = is_tiff ? number(2, 2) : 0;
        word_ = kind == kTiff ? 4 : kind == kBigTiff ? 8 : 0;
    }
    bool is_one() const { return word_ != 0; }
    std::uint64_t word() const { return word_; }  // bytes of an offset
    std::uint64_t number(std::uint64_t at, std::uint64_t size) const {
        if (at > bytes_.size() || size > bytes_.size() - at) return 0;
        std::uint64_t number = 0;
        for (std::uint64_t i = 0; i < size; ++i)
            number = number << 8U | static_cast<std::uint8_t>(bytes_[at + (is_little_ ? size - 1 - i : i)]);
        return number;
    }
    std::string_view text(std::uint64_t at, std::uint64_t size) const {
        if (at > bytes_.size() || size > bytes_.size() - at) return {};
        const std::string_view text = bytes_.substr(at, size);
        return text.substr(0, text.find('\0'));
    }
    std::uint64_t size() const { return bytes_.size(); }

  private:
    std::string_view bytes_;
    bool is_little_;
    std::uint64_t word_ = 0;
};

// The text of a tag in the first directory; empty where there is none.
std::string_view text_of_tag(const Tiff& tiff, std::uint64_t tag) {
    const std::uint64_t directory = tiff.number(tiff.word(), tiff.word());
    const std::uint64_t count_size = tiff.word() == 4 ? 2 : 8;
    const std::uint64_t entry_size = 4 + 2 * tiff.word();
    const std::uint64_t count = tiff.number(directory, count_size);
    std::uint64_t entry = directory + count_size;
    for (std::uint64_t i = 0; i < count && entry <= tiff.size(); ++i, entry += entry_size) {
        if (tiff.number(entry, 2) != tag || tiff.number(entry + 2, 2) != kAscii) continue;
        const std::uint64_t size = tiff.number(entry + 4, tiff.word());
        const std::uint64_t value = entry + 4 + tiff.word();
        return tiff.text(size <= tiff.word() ? value : tiff.number(value, tiff.word()), size);
    }
    return {};
}

}  // namespace

std::optional<float> nodata_of_tiff(std::string_view bytes) {
    const Tiff tiff(bytes);
    if (!tiff.is_one()) return std::nullopt;
    std::string_view text = text_of_tag(tiff, kGdalNodata);
    while (text.starts_with(' ') || text.starts_with('+')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return is_number ? std::optional(value) : std::nullopt;
}

}  // namespace quadrat::pictures
