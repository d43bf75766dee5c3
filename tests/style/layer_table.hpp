// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace quadrat::tests {

// tests/style/layers.txt, section by section: a name, and the words behind its colon, in the file's order.
struct LayerTable {
    using Rows = std::map<std::string, std::vector<std::string>>;
    Rows rooms;   // whom a room may include
    Rows system;  // who alone may include a system header
    Rows clocks;  // one row: who reads a clock
    Rows paths;   // what passes which rooms, in order
};

inline LayerTable read_layers() {
    LayerTable table;
    std::ifstream file(QUADRAT_SOURCE_DIR "/tests/style/layers.txt");
    auto* rows = &table.rooms;
    for (std::string line; std::getline(file, line);) {
        if (line == "[system]") rows = &table.system;
        if (line == "[clock]") rows = &table.clocks;
        if (line == "[paths]") rows = &table.paths;
        const auto colon = line.find(':');
        if (line.empty() || line[0] == '#' || colon == std::string::npos) continue;
        std::istringstream names(line.substr(colon + 1));
        auto& allowed = (*rows)[line.substr(0, colon)];
        for (std::string name; names >> name;) allowed.push_back(name);
    }
    return table;
}

}  // namespace quadrat::tests
