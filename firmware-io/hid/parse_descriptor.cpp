// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "firmware-io/hid/hid_layout.hpp"

namespace quadrat::firmware_io::hid {
namespace {

constexpr std::size_t kLongestDescriptor = 4096;  // HID_MAX_DESCRIPTOR_SIZE of Linux
constexpr std::uint64_t kLongestReport_bits = 8 * 16'384;
constexpr std::size_t kMostControls = 2048;
constexpr std::size_t kMostUsages = 1024;
constexpr std::size_t kDeepest = 32;

struct Item {
    unsigned type;  // 0 main, 1 global, 2 local
    unsigned tag;
    unsigned size;  // of the value, in bytes
    std::uint32_t value;
    std::int64_t signed_value() const {
        if (size == 1) return static_cast<std::int8_t>(value);
        if (size == 2) return static_cast<std::int16_t>(value);
        return static_cast<std::int32_t>(value);
    }
};

struct Globals {
    unsigned usage_page = 0;
    std::int64_t logical_min = 0;
    Item logical_max{1, 2, 1, 0};
    std::uint32_t report_size = 0, report_count = 0;
    std::uint8_t report_id = 0;
    // A maximum is signed only if the minimum is negative: 0x25 0xff after 0x15 0x00 means 255.
    std::int64_t max() const { return logical_min < 0 ? logical_max.signed_value() : std::int64_t{logical_max.value}; }
};

struct LocalUsage {
    std::uint32_t first, last;
    bool has_page;  // written with 32 bits
};

struct Locals {
    std::vector<LocalUsage> usages;
    std::optional<Item> min, max;
    bool is_in_set = false;  // between delimiters: the usages are alternatives, of which the first is preferred
    bool is_set_filled = false;
};

class DescriptorReader {
  public:
    HidLayout read(std::span<const std::uint8_t> bytes);

  private:
    std::optional<Item> next_item(std::span<const std::uint8_t>& bytes);
    void main_item(const Item& item);
    void global_item(const Item& item);
    void local_item(const Item& item);
    void add_usage(LocalUsage usage);
    void input(std::uint32_t flags);
    void add_array(std::uint64_t bit);
    void add_variables(std::uint64_t bit);
    std::vector<UsageRange> usages() const;
    bool fail(const char* why);

    HidLayout layout_;
    Globals globals_;
    std::vector<Globals> pushed_;
    Locals locals_;
    std::size_t depth_ = 0;
    std::size_t controls_ = 0;
    std::array<std::uint64_t, 256> report_bits_{};  // by report ID
};

bool DescriptorReader::fail(const char* why) {
    if (layout_.trouble.empty()) layout_.trouble = why;
    return false;
}

std::optional<Item> DescriptorReader::next_item(std::span<const std::uint8_t>& bytes) {
    constexpr std::uint8_t kLongItem = 0xfe;
    const std::uint8_t prefix = bytes.front();
    if (prefix == kLongItem) {
        const std::size_t length = bytes.size() > 1 ? 3u + bytes[1] : 3u;
        if (length > bytes.size()) return fail("a long item is cut short"), std::nullopt;
        bytes = bytes.subspan(length);
        return Item{3, 0, 0, 0};
    }
    const unsigned size = (prefix & 3u) == 3u ? 4u : prefix & 3u;
    if (size + 1 > bytes.size()) return fail("an item is cut short"), std::nullopt;
    std::uint32_t value = 0;
    for (unsigned i = 0; i < size; ++i) value |= std::uint32_t{bytes[1 + i]} << (8 * i);
    bytes = bytes.subspan(size + 1);
    return Item{(prefix >> 2u) & 3u, unsigned{prefix} >> 4u, size, value};
}

HidLayout DescriptorReader::read(std::span<const std::uint8_t> bytes) {
    if (bytes.size() > kLongestDescriptor) {
        fail("it is longer than 4096 bytes");
        bytes = bytes.first(kLongestDescriptor);
    }
    while (!bytes.empty()) {
        const auto item = next_item(bytes);
        if (!item) break;
        if (item->type == 0) main_item(*item);
        if (item->type == 1) global_item(*item);
        if (item->type == 2) local_item(*item);
        if (!layout_.trouble.empty()) break;
    }
    return std::move(layout_);
}

void DescriptorReader::main_item(const Item& item) {
    enum { kInput = 0x8, kCollection = 0xa, kEndCollection = 0xc };
    if (item.tag == kInput) input(item.value);
    if (item.tag == kCollection) {
        const auto used = usages();
        if (depth_ == 0 && layout_.applications.size() < kMostUsages)
            layout_.applications.push_back(used.empty() ? 0 : used.front().first);
        if (++depth_ > kDeepest) fail("its collections are nested too deeply");
    }
    if (item.tag == kEndCollection && depth_-- == 0) fail("a collection ends that never began");
    locals_ = {};
}

void DescriptorReader::global_item(const Item& item) {
    switch (item.tag) {
        case 0x0:
            globals_.usage_page = item.value & 0xffffu;
            break;
        case 0x1:
            globals_.logical_min = item.signed_value();
            break;
        case 0x2:
            globals_.logical_max = item;
            break;
        case 0x7:
            globals_.report_size = item.value;
            break;
        case 0x8:
            globals_.report_id = static_cast<std::uint8_t>(item.value);
            layout_.has_report_ids = true;
            if (item.value == 0 || item.value > 255) fail("a report ID is not 1 to 255");
            break;
        case 0x9:
            globals_.report_count = item.value;
            break;
        case 0xa:
            if (pushed_.size() == kDeepest)
                fail("it pushes too often");
            else
                pushed_.push_back(globals_);
            break;
        case 0xb:
            if (pushed_.empty()) {
                fail("it pops what it never pushed");
            } else {
                globals_ = pushed_.back();
                pushed_.pop_back();
            }
            break;
        default:
            break;  // physical extents and units say nothing about what is pressed
    }
}

void DescriptorReader::add_usage(LocalUsage usage) {
    if (locals_.is_in_set && std::exchange(locals_.is_set_filled, true)) return;
    if (usage.last >= usage.first && locals_.usages.size() < kMostUsages) locals_.usages.push_back(usage);
}

void DescriptorReader::local_item(const Item& item) {
    switch (item.tag) {
        case 0x0:
            add_usage({item.value, item.value, item.size == 4});
            break;
        case 0x1:
            locals_.min = item;
            break;
        case 0x2:
            locals_.max = item;
            break;
        case 0xa:
            locals_.is_in_set = item.value == 1;
            locals_.is_set_filled = false;
            break;
        default:
            break;
    }
    if (locals_.min && locals_.max) {
        add_usage({locals_.min->value, locals_.max->value, locals_.min->size == 4});
        locals_.min = locals_.max = std::nullopt;
    }
}

// The usages with their page, which is the one in force at the main item unless they carry their own.
std::vector<UsageRange> DescriptorReader::usages() const {
    std::vector<UsageRange> ranges;
    for (const LocalUsage& local : locals_.usages) {
        const std::uint32_t page = local.has_page ? local.first & 0xffff0000u : globals_.usage_page << 16;
        ranges.push_back({page | (local.first & 0xffffu), page | (local.last & 0xffffu)});
    }
    std::erase_if(ranges, [](const UsageRange& range) { return range.last < range.first; });
    return ranges;
}

void DescriptorReader::input(std::uint32_t flags) {
    constexpr std::uint32_t kConstant = 1u << 0, kVariable = 1u << 1, kRelative = 1u << 2;
    const std::uint64_t length = std::uint64_t{globals_.report_size} * globals_.report_count;
    const std::uint64_t bit = report_bits_[globals_.report_id];
    if (length > kLongestReport_bits - bit) {
        fail("a report is longer than 16384 bytes");
        return;
    }
    report_bits_[globals_.report_id] += length;
    const bool is_opaque = globals_.report_size == 0 || globals_.report_size > 32 || globals_.report_count == 0;
    if ((flags & kConstant) != 0 || is_opaque || layout_.applications.empty()) return;
    if ((flags & kVariable) == 0)
        add_array(bit);
    else if ((flags & kRelative) == 0)
        add_variables(bit);
}

void DescriptorReader::add_array(std::uint64_t bit) {
    Array array{static_cast<std::uint16_t>(layout_.applications.size() - 1),
                globals_.report_id,
                static_cast<std::uint32_t>(bit),
                static_cast<std::uint8_t>(globals_.report_size),
                globals_.report_count,
                globals_.logical_min < 0,
                globals_.logical_min,
                globals_.max(),
                usages()};
    if (array.usages.empty() || controls_ + array.slots > kMostControls) return;
    controls_ += array.slots;
    layout_.arrays.push_back(std::move(array));
}

std::optional<ControlKind> kind_of(Usage usage, unsigned bits) {
    const unsigned page = page_of(usage);
    const bool is_undefined = (usage & 0xffffu) == 0 && page != page::kButton;
    if (is_undefined || page >= page::kVendorFirst) return std::nullopt;  // nobody's business
    if (page == page::kButton) return ControlKind::Button;
    if (page == page::kKeyboard) return ControlKind::Key;
    if (usage == kHatSwitch) return ControlKind::Hat;
    return bits == 1 ? ControlKind::Button : ControlKind::Axis;
}

// Button 0 means "no button pressed" (HID Usage Tables 1.5, chapter 12), and so it is padding; but home-made boxes
// number theirs from it, and then there is a button 1 beside it.
bool has_button(const std::vector<UsageRange>& ranges, unsigned number) {
    const Usage button = usage(page::kButton, number);
    return std::any_of(ranges.begin(), ranges.end(),
                       [&](const UsageRange& range) { return range.first <= button && button <= range.last; });
}

void DescriptorReader::add_variables(std::uint64_t bit) {
    const std::vector<UsageRange> ranges = usages();
    const bool is_zero_padding = !has_button(ranges, 1);
    if (ranges.empty()) return;
    const unsigned bits = globals_.report_size;
    std::size_t range = 0;
    Usage usage = ranges.front().first;
    for (std::uint32_t i = 0; i < globals_.report_count; ++i, bit += bits) {
        if (controls_ == kMostControls) return;
        const bool is_padding = usage == hid::usage(page::kButton, 0) && is_zero_padding;
        if (const auto kind = is_padding ? std::nullopt : kind_of(usage, bits)) {
            ++controls_;
            Variable variable{*kind,
                              usage,
                              static_cast<std::uint16_t>(layout_.applications.size() - 1),
                              globals_.report_id,
                              static_cast<std::uint32_t>(bit),
                              static_cast<std::uint8_t>(bits),
                              globals_.logical_min < 0,
                              globals_.logical_min,
                              globals_.max()};
            if (variable.logical_max <= variable.logical_min) {  // undeclared or contradictory: what fits
                variable.is_signed = false;
                variable.logical_min = 0;
                variable.logical_max = (std::int64_t{1} << bits) - 1;
            }
            layout_.variables.push_back(variable);
        }
        // More controls than usages: the last usage belongs to all that remain.
        if (usage != ranges[range].last)
            ++usage;
        else if (range + 1 < ranges.size())
            usage = ranges[++range].first;
    }
}

bool has_part(ControlKind kind, SignalPart part) {
    switch (kind) {
        case ControlKind::Button:
        case ControlKind::Key:
            return part == SignalPart::Pressed;
        case ControlKind::Hat:
            return part >= SignalPart::Up && part <= SignalPart::Left;
        case ControlKind::Axis:
            return part == SignalPart::Low || part == SignalPart::High;
    }
    return false;
}

}  // namespace

bool can_send(const HidLayout& layout, const HidSignal& signal) {
    const auto is_sent_by_variable = [&](const Variable& v) {
        return v.collection == signal.collection && v.usage == signal.usage && has_part(v.kind, signal.part);
    };
    const auto is_sent_by_array = [&](const Array& array) {
        return array.collection == signal.collection && signal.part == SignalPart::Pressed &&
               std::any_of(array.usages.begin(), array.usages.end(), [&](const UsageRange& range) {
                   return range.first <= signal.usage && signal.usage <= range.last;
               });
    };
    return std::any_of(layout.variables.begin(), layout.variables.end(), is_sent_by_variable) ||
           std::any_of(layout.arrays.begin(), layout.arrays.end(), is_sent_by_array);
}

HidLayout parse_descriptor(std::span<const std::uint8_t> descriptor) { return DescriptorReader{}.read(descriptor); }

}  // namespace quadrat::firmware_io::hid
