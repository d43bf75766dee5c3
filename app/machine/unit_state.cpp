// SPDX-License-Identifier: Apache-2.0
#include "machine/unit_state.hpp"

#include <systemd/sd-bus.h>

#include <cstdint>
#include <cstdlib>
#include <memory>

namespace quadrat::machine {
namespace {

constexpr std::uint64_t kPatience_us = 2'000'000;

struct Unref {
    void operator()(sd_bus* bus) const { ::sd_bus_flush_close_unref(bus); }
    void operator()(char* text) const { std::free(text); }
};
using Bus = std::unique_ptr<sd_bus, Unref>;
using Text = std::unique_ptr<char, Unref>;

Bus open_bus() {
    sd_bus* opened = nullptr;
    if (::sd_bus_open_system(&opened) < 0) return nullptr;
    Bus bus{opened};
    ::sd_bus_set_method_call_timeout(bus.get(), kPatience_us);
    return bus;
}

// "" where it cannot be had.
std::string property(sd_bus* bus, const char* object, const char* interface, const char* name) {
    sd_bus_error error{};
    char* answer = nullptr;
    const int status =
        ::sd_bus_get_property_string(bus, "org.freedesktop.systemd1", object, interface, name, &error, &answer);
    ::sd_bus_error_free(&error);
    const Text text{answer};
    return status >= 0 && text ? text.get() : "";
}

}  // namespace

std::optional<UnitState> read_unit_state(const std::string& unit) {
    const Bus bus = open_bus();
    char* path = nullptr;
    if (!bus || ::sd_bus_path_encode("/org/freedesktop/systemd1/unit", unit.c_str(), &path) < 0) return std::nullopt;
    const Text object{path};
    constexpr const char* kUnit = "org.freedesktop.systemd1.Unit";
    UnitState state;
    state.load = property(bus.get(), object.get(), kUnit, "LoadState");
    if (state.load.empty()) return std::nullopt;
    state.file = property(bus.get(), object.get(), kUnit, "UnitFileState");
    state.active = property(bus.get(), object.get(), kUnit, "ActiveState");
    state.result = property(bus.get(), object.get(), "org.freedesktop.systemd1.Service", "Result");
    return state;
}

}  // namespace quadrat::machine
