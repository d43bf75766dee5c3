// SPDX-License-Identifier: Apache-2.0
#include "benches/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quadrat::benches {
namespace {

// Every option that is in force, with the groups that heed it.
std::vector<Setting> all_settings(const Options& how) {
    std::vector<Setting> all{{"--frames " + std::to_string(how.frames), {"frame"}},
                             {fmt::format("--minutes {}", how.minutes), {"visit"}},
                             {fmt::format("--hz {}", how.hz), {"visit"}}};
    Setting size{"--size " + how.size, {"frame", "fidelity", "start", "visit"}};
    Setting alpha{fmt::format("--alpha {}", how.alpha), {"frame", "fidelity", "visit"}};
    Setting triangles{fmt::format("--triangles {}", how.triangles), {"frame", "fidelity"}};
    Setting pixels{fmt::format("--pixels {}", how.pixels), {"frame", "fidelity"}};
    if (!how.profile.empty()) {
        // A profile has a size of its own where none was asked for.
        if (how.size != Options{}.size) size.groups.emplace_back("detail");
        for (Setting* setting : {&alpha, &triangles, &pixels}) setting->groups.emplace_back("detail");
        all.push_back({"--profile " + how.profile, {"detail"}});
    }
    all.insert(all.begin(), {size, alpha});
    if (how.triangles > 0) all.push_back(triangles);
    if (how.pixels > 0) all.push_back(pixels);
    if (how.ground != Options{}.ground) all.push_back({"--ground " + how.ground, {"frame", "fidelity"}});
    if (how.then_hz > 0) all.push_back({fmt::format("--then-hz {}", how.then_hz), {"visit"}});
    if (!how.attended.empty()) all.push_back({"--attended " + how.attended, {"visit"}});
    if (how.is_busy) all.push_back({"--busy", {"visit"}});
    return all;
}

}  // namespace

std::vector<Setting> settings_of(const Options& how, const std::vector<std::string>& measured) {
    std::vector<Setting> heeded;
    for (Setting& setting : all_settings(how)) {
        std::erase_if(setting.groups,
                      [&](const std::string& group) { return std::ranges::find(measured, group) == measured.end(); });
        if (!setting.groups.empty()) heeded.push_back(std::move(setting));
    }
    return heeded;
}

}  // namespace quadrat::benches
