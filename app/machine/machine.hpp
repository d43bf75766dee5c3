// SPDX-License-Identifier: Apache-2.0
// The room `machine`: the computer that we run on. Its facts, its memory and threads, its accounts, what systemd is
// told and asks. Nothing here knows of landscapes, visits or settings.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// What the machine tells about itself. Nothing here waits, throws or writes; what cannot be read is left out.
namespace quadrat::machine {

struct MachineFacts {
    std::string name;                     // of the host
    std::vector<std::string> addresses;   // of its networks, without the loopback
    std::optional<double> temperature_c;  // the warmest
    std::optional<bool> is_throttled;     // by heat or for want of voltage, as a Raspberry Pi tells
    double memory_mb = 0;                 // resident, of this program
    std::uint64_t written_bytes = 0;      // by this program, to any disk
    int descriptors = 0;                  // open, of this program
};
MachineFacts read_machine(const std::filesystem::path& sys = "/sys", const std::filesystem::path& proc = "/proc");

std::optional<double> free_mb(const std::filesystem::path& folder);

// Seconds since the machine was switched on, asleep or awake.
std::chrono::seconds uptime();

// The folder that a variable of the environment names: of several between colons the first. "" where the variable is
// missing, empty, or names no absolute path.
std::filesystem::path folder_in(const char* variable);

// Where requests, health and pictures of faults lie, gone with the power: the service's runtime folder, else `state`.
std::filesystem::path runtime_folder(const std::filesystem::path& state);

}  // namespace quadrat::machine
