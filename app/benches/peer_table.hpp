// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::benches {

// What we need of what others need for the same, as bin/bench_peers --json writes it.
struct PeerRatio {
    std::string name;              // "chain"
    std::string against;           // what the yardstick is
    std::optional<double> ratio;   // none where there was nothing to compare with
    std::optional<double> spread;  // between its quartiles
    std::optional<double> goal;    // at most
    std::string note;              // what else decides, or why there is no ratio; may be empty
};

struct PeerTable {
    std::string machine;
    std::vector<PeerRatio> rows;
};

// Throws base::InputError naming source and the place: where it is not JSON, or a key is missing or has another type
// than it should. Keys that are not told here are left out.
PeerTable peer_table_from(std::string_view text, std::string_view source);

// HTML: a section with a row for each.
std::string section_of(const PeerTable& table);

}  // namespace quadrat::benches
