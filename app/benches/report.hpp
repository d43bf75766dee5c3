// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "benches/benches.hpp"
#include "benches/peer_table.hpp"
#include "benches/settings.hpp"
#include "benches/shader_table.hpp"

namespace quadrat::benches {

// What `quadrat bench --report` tells.
struct Report {
    std::string machine;
    std::string version;  // of the program
    std::string made_at;  // "2026-01-31 12:00 UTC"
    std::vector<std::string> groups;
    std::vector<Setting> settings;
    Results results;
    std::optional<ShaderTable> shaders;
    std::optional<PeerTable> peers = {};
};

// One page of HTML that needs nothing beside it, neither files nor scripts. The figures stand in tables by what their
// names begin with, in the order in which they were measured.
std::string html_of(const Report& report);

}  // namespace quadrat::benches
