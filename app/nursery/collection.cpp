// SPDX-License-Identifier: Apache-2.0
#include "nursery/collection.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::nursery {
namespace {

using nlohmann::json;

constexpr double kChosenCounts = 3;
constexpr double kDoubtStops = 1, kDoubt_min = 2;
constexpr double kAlike = 0.2;  // root mean square over all words, which go from -1 to 1
constexpr int kVersion = 1;

json json_of(const Work& work) {
    json one{{"code", work.code},       {"day", work.day},     {"parent", work.parent}, {"generation", work.generation},
             {"shown_s", work.shown_s}, {"stays", work.stays}, {"chosen", work.chosen}};
    if (!work.words) return one;
    for (const genome::Word& word : genome::vocabulary()) one["words"][std::string(word.name)] = (*work.words)[word.id];
    return one;
}

double number_in(const json& one, const char* key) {
    const double number = one.at(key).get<double>();
    if (!std::isfinite(number) || number < 0) throw base::InputError("a number is out of range");
    return number;
}

Work work_from(const json& one) {
    Work work;
    work.recipe = genome::recipe_of_code(one.at("code").get<std::string>(), "collection");
    work.code = genome::code_of(work.recipe);  // as this program writes it
    work.day = one.at("day").get<std::int64_t>();
    work.parent = one.at("parent").get<std::string>();
    work.generation = std::max(1, one.at("generation").get<int>());
    work.shown_s = number_in(one, "shown_s");
    work.stays = number_in(one, "stays");
    work.chosen = number_in(one, "chosen");
    if (!one.contains("words")) return work;
    work.words.emplace();
    for (const genome::Word& word : genome::vocabulary())
        if (const auto said = one["words"].find(std::string(word.name)); said != one["words"].end())
            work.words->set(word.id, std::clamp(said->get<float>(), -1.0F, 1.0F));
    return work;
}

}  // namespace

double worth(const Work& work) {
    return (work.stays + kChosenCounts * work.chosen + kDoubtStops) / (work.shown_s / 60 + kDoubt_min);
}

bool are_alike(const Work& a, const Work& b) {
    if (a.code == b.code || !a.words || !b.words) return a.code == b.code;
    double sum = 0;
    for (const genome::Word& word : genome::vocabulary()) {
        const double apart = static_cast<double>((*a.words)[word.id]) - static_cast<double>((*b.words)[word.id]);
        sum += apart * apart;
    }
    return sum < kAlike * kAlike * static_cast<double>(genome::vocabulary().size());
}

void Collection::admit(Work work) {
    // Bred again to the same, it goes on with what it has earned.
    if (const Work* known = find(work.code)) work = *known;
    std::erase_if(works_, [&](const Work& old) { return old.code == work.code; });
    const bool is_outdone =
        std::ranges::any_of(works_, [&](const Work& old) { return are_alike(old, work) && worth(old) > worth(work); });
    if (is_outdone) return;
    std::erase_if(works_, [&](const Work& old) { return are_alike(old, work); });
    works_.insert(works_.begin(), std::move(work));
    if (works_.size() <= kMost) return;
    works_.erase(std::min_element(works_.begin() + 1, works_.end(),
                                  [](const Work& a, const Work& b) { return worth(a) < worth(b); }));
}

const Work* Collection::find(std::string_view code) const {
    const auto found = std::ranges::find(works_, code, &Work::code);
    return found == works_.end() ? nullptr : &*found;
}

Work* Collection::find_to_change(std::string_view code) {
    const auto found = std::ranges::find(works_, code, &Work::code);
    return found == works_.end() ? nullptr : &*found;
}

std::vector<genome::Recipe> Collection::ranked() const {
    std::vector<const Work*> order;
    for (const Work& work : works_) order.push_back(&work);
    std::ranges::stable_sort(order, [](const Work* a, const Work* b) { return worth(*a) > worth(*b); });
    std::vector<genome::Recipe> recipes;
    for (const Work* work : order) recipes.push_back(work->recipe);
    return recipes;
}

void Collection::was_shown(std::string_view code, double seconds) {
    if (Work* work = find_to_change(code)) work->shown_s += std::max(0.0, seconds);
}

void Collection::was_stopped_at(std::string_view code, bool was_chosen) {
    Work* work = find_to_change(code);
    if (work == nullptr) return;
    ++work->stays;
    if (was_chosen) ++work->chosen;
}

std::string Collection::to_json() const {
    json all{{"version", kVersion}, {"works", json::array()}};
    for (const Work& work : works_) all["works"].push_back(json_of(work));
    return all.dump();
}

Collection Collection::from_json(std::string_view text) {
    Collection collection;
    try {
        const json all = genome::parse_json(std::string(text), "collection");
        if (!all.is_object() || all.value("version", 0) != kVersion || !all.contains("works")) return collection;
        for (const json& one : all["works"]) {
            try {
                Work work = work_from(one);
                const bool is_there = collection.find(work.code) != nullptr;
                if (!is_there && collection.works_.size() < kMost) collection.works_.push_back(std::move(work));
            } catch (const json::exception&) {
                continue;
            } catch (const base::InputError&) {
                continue;
            }
        }
    } catch (const base::InputError&) {
        return collection;
    } catch (const json::exception&) {
        return collection;
    }
    return collection;
}

}  // namespace quadrat::nursery
