// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis_access.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

namespace quadrat::doctor {

namespace fs = std::filesystem;

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> paths;
    std::error_code error;
    for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error))
        paths.push_back(entry->path());
    std::ranges::sort(paths);
    return paths;
}

bool is_usable(const fs::path& path, const std::optional<machine::Account>& exhibit) {
    return exhibit ? machine::may_use(*exhibit, path) : ::access(path.c_str(), R_OK | W_OK) == 0;
}

std::string joining(const char* group, const std::optional<machine::Account>& exhibit) {
    return fmt::format("usermod -aG {} {}", group, exhibit ? exhibit->name : "USER");
}

Finding access_finding(const Nodes& nodes, const fs::path& dev, const std::optional<machine::Account>& exhibit) {
    std::string closed;
    int seen = 0;
    for (const fs::path& path : entries_of(dev)) {
        if (!path.filename().string().starts_with(nodes.prefix)) continue;
        ++seen;
        if (!is_usable(path, exhibit)) closed += fmt::format(" {}", path.string());
    }
    const std::string who = exhibit ? fmt::format(" by the user {}", exhibit->name) : "";
    if (seen == 0) return {nodes.subject, Health::Good, fmt::format("this machine has no {}", nodes.kind), ""};
    if (closed.empty())
        return {nodes.subject, Health::Good, fmt::format("{}: {} may be used{}", nodes.kind, seen, who), ""};
    return {nodes.subject, Health::Bad, fmt::format("{}: may not be used{}:{}", nodes.kind, who, closed),
            fmt::format("add the exhibit's user to the group {}: {}; then systemctl restart quadrat", nodes.group,
                        joining(nodes.group, exhibit))};
}

}  // namespace quadrat::doctor
