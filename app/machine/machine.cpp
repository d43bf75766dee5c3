// SPDX-License-Identifier: Apache-2.0
#include "machine/machine.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace quadrat::machine {
namespace {

namespace fs = std::filesystem;

std::string word_in(const fs::path& file) {
    std::ifstream stream(file);
    std::string word;
    stream >> word;
    return word;
}

// The value behind a key such as "write_bytes:" in one of the kernel's tables.
std::uint64_t number_after(const fs::path& file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string word; stream >> word;) {
        std::uint64_t value = 0;
        if (word == key && stream >> value) return value;
    }
    return 0;
}

template <typename Each>
void for_each_entry(const fs::path& folder, const Each& each) {
    std::error_code error;
    for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error))
        each(entry->path());
}

std::optional<double> warmest(const fs::path& sys) {
    std::optional<double> most;
    for_each_entry(sys / "class/thermal", [&](const fs::path& zone) {
        if (!zone.filename().string().starts_with("thermal_zone")) return;
        const double degrees = std::atof(word_in(zone / "temp").c_str()) / 1000;
        if (degrees > 0) most = std::max(degrees, most.value_or(degrees));
    });
    return most;
}

// What a Raspberry Pi's firmware says, under /soc/soc:firmware or, on a Pi 5, /soc@107c000000/soc@107c000000:firmware.
std::optional<bool> firmware_throttles(const fs::path& sys) {
    std::optional<bool> told;
    const auto ask = [&](const fs::path& device) {
        const std::string name = device.filename().string();
        if (!name.starts_with("soc") || !name.ends_with(":firmware")) return;
        const std::string word = word_in(device / "get_throttled");
        // Bits of what happens now: under voltage, frequency capped, throttled, soft temperature limit.
        if (!word.empty()) told = (std::strtoul(word.c_str(), nullptr, 16) & 0xfU) != 0;
    };
    for_each_entry(sys / "devices/platform", [&](const fs::path& bus) {
        if (bus.filename().string().starts_with("soc")) for_each_entry(bus, ask);
    });
    return told;
}

// What the Raspberry Pi's driver for its voltage says, where the firmware is not asked.
std::optional<bool> voltage_is_low(const fs::path& sys) {
    std::optional<bool> told;
    for_each_entry(sys / "class/hwmon", [&](const fs::path& sensor) {
        if (word_in(sensor / "name") != "rpi_volt") return;
        const std::string alarm = word_in(sensor / "in0_lcrit_alarm");
        if (!alarm.empty()) told = alarm != "0";
    });
    return told;
}

std::vector<std::string> addresses() {
    std::vector<std::string> found;
    ifaddrs* list = nullptr;
    if (::getifaddrs(&list) != 0) return found;
    for (const ifaddrs* one = list; one != nullptr; one = one->ifa_next) {
        if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET || (one->ifa_flags & IFF_LOOPBACK) != 0)
            continue;
        std::array<char, INET_ADDRSTRLEN> text{};
        const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
        if (::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) != nullptr)
            found.emplace_back(text.data());
    }
    ::freeifaddrs(list);
    return found;
}

}  // namespace

MachineFacts read_machine(const fs::path& sys, const fs::path& proc) {
    MachineFacts facts;
    std::array<char, 65> name{};
    if (::gethostname(name.data(), name.size() - 1) == 0) facts.name = name.data();
    facts.addresses = addresses();
    facts.temperature_c = warmest(sys);
    facts.is_throttled = firmware_throttles(sys);
    if (!facts.is_throttled) facts.is_throttled = voltage_is_low(sys);
    facts.memory_mb = static_cast<double>(number_after(proc / "self/status", "VmRSS:")) / 1024;
    facts.written_bytes = number_after(proc / "self/io", "write_bytes:");
    for_each_entry(proc / "self/fd", [&](const fs::path&) { ++facts.descriptors; });
    return facts;
}

std::optional<double> free_mb(const fs::path& folder) {
    std::error_code error;
    const auto space = fs::space(folder, error);
    if (error) return std::nullopt;
    return static_cast<double>(space.available) / (1 << 20);
}

std::chrono::seconds uptime() {
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return std::chrono::seconds{now.tv_sec};
}

fs::path folder_in(const char* variable) {
    const char* const value = std::getenv(variable);
    if (value == nullptr) return {};
    const std::string folders = value;
    const fs::path first = folders.substr(0, folders.find(':'));  // systemd names several that way
    return first.is_absolute() ? first : fs::path();
}

fs::path runtime_folder(const fs::path& state) {
    const fs::path service = folder_in("RUNTIME_DIRECTORY");
    return service.empty() ? state : service;
}

}  // namespace quadrat::machine
