// SPDX-License-Identifier: Apache-2.0
#include "projector/keeper.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"

namespace quadrat::projector {
namespace {

bool is_as_wanted(Power power, Wanted wanted) { return power == (wanted == Wanted::On ? Power::On : Power::Off); }
bool is_on_its_way(Power power, Wanted wanted) {
    return power == (wanted == Wanted::On ? Power::Warming : Power::Cooling);
}

std::string text_in(const nlohmann::json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

bool Keeper::look(std::optional<Wanted> wanted, Moment now) {
    if (!wanted) return false;
    if (wanted != wanted_) {
        wanted_ = wanted;
        wanted_since_ = now;
        patience_ = kFirstTry;
    } else if (now < next_) {
        return false;
    }
    try {
        see_to_it(now);
    } catch (const Trouble& trouble) {
        // Once it answers it has as long as at first.
        wanted_since_ = now;
        fail(trouble.what(), trouble.remedy(), now);
    }
    return true;
}

// A screen that is off may not answer by CEC, and is as it should be.
void Keeper::see_to_it(Moment now) {
    told_.power = projector_.power();
    const bool may_be_off = *told_.power == Power::Unknown && *wanted_ == Wanted::Off;
    if (is_as_wanted(*told_.power, *wanted_)) return settle(now);
    if (now - wanted_since_ > kLongestWay) {
        if (may_be_off) return settle(now);
        const std::string ailments = projector_.ailments();
        // It is told once more, for the plug may have been pulled since it came there.
        *wanted_ == Wanted::On ? projector_.turn_on() : projector_.turn_off();
        const char* const what = *wanted_ == Wanted::On ? "the projector was told to go on, and does not"
                                                        : "the projector was told to go off, and does not";
        return fail(std::string(what) + (ailments.empty() ? "" : "; it reports " + ailments),
                    "look at its lamps and its menu", now);
    }
    next_ = now + kOnItsWay;
    if (is_on_its_way(*told_.power, *wanted_)) return;
    *wanted_ == Wanted::On ? projector_.turn_on() : projector_.turn_off();
}

void Keeper::settle(Moment now) {
    const std::string ailments = projector_.ailments();
    const std::string trouble = ailments.empty() ? "" : "the projector reports " + ailments;
    if (trouble != told_.trouble && trouble.empty()) base::log::info("projector: all is well again");
    if (trouble != told_.trouble && !trouble.empty()) base::log::warn("projector: it reports {}", ailments);
    told_.trouble = trouble;
    told_.remedy = trouble.empty() ? "" : "look at its lamps and its menu";
    patience_ = kFirstTry;
    // When it is not as it was at the next look, it has as long as at first.
    next_ = now + kCheckEvery;
    wanted_since_ = next_;
}

void Keeper::fail(const std::string& what, const std::string& remedy, Moment now) {
    if (what != told_.trouble) base::log::warn("projector: {}; {}; it is tried again", what, remedy);
    told_.trouble = what;
    told_.remedy = remedy;
    next_ = now + patience_;
    patience_ = std::min(2 * patience_, kLongestTry);
}

std::string to_json(const Told& told) {
    return nlohmann::json{
               {"power", told.power ? name_of(*told.power) : ""}, {"trouble", told.trouble}, {"remedy", told.remedy}}
               .dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
           "\n";
}

std::optional<Told> told_in(const std::filesystem::path& runtime, std::filesystem::file_time_type now) {
    constexpr std::size_t kLongest = 4096;
    std::error_code error;
    const auto written = std::filesystem::last_write_time(runtime / kTold, error);
    if (error || now - written > 3 * Keeper::kCheckEvery) return std::nullopt;
    try {
        const auto json = nlohmann::json::parse(base::read_file(runtime / kTold, kLongest), nullptr, false);
        if (!json.is_object()) return std::nullopt;
        Told told{std::nullopt, text_in(json, "trouble"), text_in(json, "remedy")};
        const std::string power = text_in(json, "power");
        for (const Power one : {Power::Off, Power::On, Power::Cooling, Power::Warming, Power::Unknown})
            if (power == name_of(one)) told.power = one;
        return told;
    } catch (const base::InputError&) {
        return std::nullopt;
    }
}

}  // namespace quadrat::projector
