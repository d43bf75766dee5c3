// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "doctor/diagnosis.hpp"
#include "projector/keeper.hpp"
#include "projector/projector.hpp"

namespace quadrat::doctor {
namespace {

using projector::Power;

Finding as_told(const projector::Told& told) {
    if (!told.trouble.empty()) return {"projector", Health::Doubtful, told.trouble, told.remedy};
    return {"projector", Health::Good,
            fmt::format("is {}, as the exhibit wants it", name_of(told.power.value_or(Power::Unknown))), ""};
}

}  // namespace

std::vector<Finding> examine_projector(const site::Configuration& configuration, const std::filesystem::path& runtime,
                                       const AskProjector& ask) {
    if (configuration.screen.power.empty()) return {};
    if (const auto told = projector::told_in(runtime, std::filesystem::file_time_type::clock::now()))
        return {as_told(*told)};
    try {
        return {{"projector", Health::Doubtful,
                 fmt::format("answers, and is {}; nobody switches it", ask(configuration.screen)),
                 "sudo systemctl enable --now quadrat-projector"}};
    } catch (const projector::Trouble& trouble) {
        return {{"projector", Health::Doubtful, trouble.what(), trouble.remedy()}};
    }
}

}  // namespace quadrat::doctor
