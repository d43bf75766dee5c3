// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/hidraw.hpp"

#include <hidapi/hidapi.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::hid {
namespace {

std::vector<char> read_start(const std::filesystem::path& file, std::size_t most) {
    std::ifstream stream{file, std::ios::binary};
    std::vector<char> bytes(most);
    stream.read(bytes.data(), static_cast<std::streamsize>(most));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

HidDeviceFacts facts_of(const std::filesystem::path& entry, const std::filesystem::path& nodes) {
    constexpr std::size_t kLongest = 4096;
    const auto uevent = read_start(entry / "device" / "uevent", kLongest);
    const auto descriptor = read_start(entry / "device" / "report_descriptor", kLongest);
    return {(nodes / entry.filename()).string(),
            parse_uevent({uevent.data(), uevent.size()}),
            {descriptor.begin(), descriptor.end()}};
}

// hidraw2 before hidraw10.
bool is_before(const std::filesystem::path& a, const std::filesystem::path& b) {
    const std::string left = a.filename().string(), right = b.filename().string();
    return std::pair{left.size(), left} < std::pair{right.size(), right};
}

class Stream final : public HidStream {
  public:
    explicit Stream(hid_device* device) : device_{device} {}

    std::ptrdiff_t read(std::span<std::uint8_t> report) override {
        constexpr int kDoNotWait_ms = 0;
        return hid_read_timeout(device_.get(), report.data(), report.size(), kDoNotWait_ms);
    }

  private:
    struct Close {
        void operator()(hid_device* device) const { hid_close(device); }
    };
    std::unique_ptr<hid_device, Close> device_;
};

std::string narrow(const wchar_t* text) {
    std::string out;
    for (; text != nullptr && *text != 0; ++text)
        out += *text >= L' ' && *text <= L'~' ? static_cast<char>(*text) : '?';
    return out;
}

}  // namespace

HidIdentity parse_uevent(std::string_view uevent) {
    HidIdentity identity;
    for (const std::string_view line : split(uevent, '\n')) {
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) continue;
        const std::string_view key = line.substr(0, equals), value = line.substr(equals + 1);
        if (key == "HID_NAME") identity.name = value;
        if (key == "HID_UNIQ") identity.serial = value;
        if (key == "HID_PHYS") identity.port = value;
        if (key != "HID_ID") continue;
        const auto numbers = split(value, ':');
        if (numbers.size() != 3) continue;
        identity.vendor = static_cast<std::uint16_t>(parse_unsigned(numbers[1], 16).value_or(0));
        identity.product = static_cast<std::uint16_t>(parse_unsigned(numbers[2], 16).value_or(0));
    }
    return identity;
}

std::vector<HidDeviceFacts> Hidraw::devices() {
    std::vector<std::filesystem::path> entries;
    std::error_code error;
    for (std::filesystem::directory_iterator entry{listing_, error}, end; !error && entry != end;
         entry.increment(error))
        entries.push_back(entry->path());
    std::sort(entries.begin(), entries.end(), is_before);
    std::vector<HidDeviceFacts> devices;
    for (const auto& entry : entries) devices.push_back(facts_of(entry, nodes_));
    return devices;
}

std::unique_ptr<HidStream> Hidraw::open(const std::string& path, std::string& trouble) {
    if (hid_device* device = hid_open_path(path.c_str())) return std::make_unique<Stream>(device);
    trouble = narrow(hid_error(nullptr));
    if (trouble.empty()) trouble = "no reason given";
    return nullptr;
}

}  // namespace quadrat::firmware_io::hid
