// SPDX-License-Identifier: Apache-2.0
#include "commands/curator_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "base/error.hpp"
#include "commands/curator_entries.hpp"
#include "commands/curator_themes.hpp"
#include "genome/speech.hpp"

namespace quadrat::commands {
namespace {

using site::Configuration;
using site::CuratedValue;
using site::Edit;

constexpr std::array kDays{"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"};
constexpr std::string_view kAllDay = "00:00-24:00";

std::string time_text(int minute) { return fmt::format("{:02}:{:02}", minute / 60, minute % 60); }

std::string spans_text(const std::vector<site::OpenSpan>& spans) {
    std::string text;
    for (const site::OpenSpan& span : spans)
        text += fmt::format("{}{}-{}", text.empty() ? "" : ", ", time_text(span.from_min),
                            time_text(span.until_min > 24 * 60 ? span.until_min - 24 * 60 : span.until_min));
    return text.empty() ? "closed" : text;
}

// What the site says itself need not be said again: then it may change there.
template <typename Value>
std::optional<CuratedValue> unless_same(Value value, const Value& of_the_site) {
    if (value == of_the_site) return std::nullopt;
    return CuratedValue(std::move(value));
}

// ---- opening hours

// By day or by date, as the form has them.
using Times = std::map<std::string, std::string>;

Times week_of(const Configuration& configuration) {
    Times week;
    for (std::size_t i = 0; i < kDays.size(); ++i)
        week[kDays[i]] =
            configuration.hours.is_always_open ? std::string(kAllDay) : spans_text(configuration.hours.week[i]);
    return week;
}

Times week_in(const Fields& fields) {
    Times week;
    for (const char* day : kDays) {
        const std::string times = value_in(fields, day);
        week[day] = times.empty() ? "closed" : times;
    }
    return week;
}

Times other_days_of(const Configuration& configuration) {
    Times days;
    for (const auto& [date, spans] : configuration.hours.exceptions) days[site::date_text(date)] = spans_text(spans);
    return days;
}

Times other_days_in(const Fields& fields) {
    Times days;
    std::istringstream lines(value_in(fields, "exceptions"));
    for (std::string line; std::getline(lines, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
        if (line.empty()) continue;
        const std::size_t space = line.find(' ');
        if (space == std::string::npos)
            throw base::InputError(
                fmt::format("\"{}\": write a day and its times, as 2026-12-24 10:00-13:00", line.substr(0, 40)));
        if (!days.emplace(line.substr(0, space), line.substr(space + 1)).second)
            throw base::InputError(fmt::format("{} stands there twice; write it once", line.substr(0, space)));
    }
    return days;
}

Form hours_form(const Configuration& now, const Texts& say) {
    Form form;
    Group week{say("hours.days"), say("hours.days.hint"), {}};
    const Times times = week_of(now);
    for (const char* day : kDays)
        week.entries.push_back({Kind::Line, day, say(fmt::format("hours.{}", day)), times.at(day)});
    std::string days;
    for (const auto& [date, spans] : other_days_of(now)) days += fmt::format("{} {}\n", date, spans);
    Group others{say("hours.others"), "", {{Kind::Lines, "exceptions", say("hours.exceptions"), days}}};
    others.entries.front().hint = say("hours.exceptions.hint");
    Group zone{say("hours.zone.title"), "", {{Kind::Line, "zone", say("hours.zone"), now.zone}}};
    zone.entries.front().hint = say("hours.zone.hint");
    form.groups = {week, others, zone};
    return form;
}

// A site that names any day is closed on those it does not name: all seven are said, or none.
std::vector<Edit> hours_edits(const Fields& fields, const Configuration& site) {
    std::vector<Edit> edits;
    const Times week = week_in(fields), others = other_days_in(fields);
    const bool is_the_sites_week = week == week_of(site);
    for (const auto& [day, times] : week)
        edits.push_back({{"hours", day}, is_the_sites_week ? std::nullopt : std::optional<CuratedValue>(times)});
    edits.push_back({{"hours", "exceptions"}, std::nullopt});
    if (others != other_days_of(site)) {
        edits.push_back({{"hours", "exceptions"}, site::EmptyTable{}});
        for (const auto& [date, times] : others) edits.push_back({{"hours", "exceptions", date}, times});
    }
    edits.push_back({{"hours", "zone"}, unless_same(value_in(fields, "zone"), site.zone)});
    return edits;
}

// ---- visits

struct NumberKey {
    const char* key;
    double site::Configuration::Visit::*seconds;
    int site::Configuration::Visit::*count;
    double least, most;
};
using Visit = site::Configuration::Visit;
constexpr NumberKey kTimes[]{{"rounds", nullptr, &Visit::rounds, 1, 50},
                             {"patience_s", &Visit::patience_s, nullptr, 2, 600},
                             {"countdown_s", &Visit::countdown_s, nullptr, 1, 120},
                             {"finale_s", &Visit::finale_s, nullptr, 2, 600},
                             {"long_press_s", &Visit::long_press_s, nullptr, 0.5, 30}};
constexpr NumberKey kDescribing[]{{"describe_words", nullptr, &Visit::describe_words, 0, 10},
                                  {"describe_every", nullptr, &Visit::describe_every, 1, 1000},
                                  {"describe_s", &Visit::describe_s, nullptr, 2, 600}};

double value_of(const Visit& visit, const NumberKey& key) {
    return key.seconds != nullptr ? visit.*key.seconds : visit.*key.count;
}

Group numbers(const char* title, std::span<const NumberKey> keys, const Visit& visit, const Texts& say) {
    Group group{say(title), "", {}};
    for (const NumberKey& key : keys) {
        Entry entry{Kind::Number, key.key, say(fmt::format("visit.{}", key.key)),
                    fmt::format("{}", value_of(visit, key))};
        entry.least = key.least;
        entry.most = key.most;
        group.entries.push_back(entry);
    }
    return group;
}

Form visit_form(const Configuration& now, const Texts& say) {
    Entry language{Kind::Choice, "language", say("visit.language"), now.visit.language};
    language.options = language_options();
    Group offered{say("visit.languages"), say("visit.languages.hint"), {}};
    for (const desk::Option& option : language.options) {
        const bool is_offered = std::ranges::find(now.visit.languages, option.value) != now.visit.languages.end();
        Entry tick{Kind::Tick, "offers." + option.value, option.label, is_offered ? "on" : ""};
        tick.language = option.value;
        offered.entries.push_back(tick);
    }
    Form form;
    form.groups = {{say("visit.screen"), "", {language}},
                   offered,
                   numbers("visit.times", kTimes, now.visit, say),
                   numbers("visit.describing", kDescribing, now.visit, say)};
    return form;
}

std::vector<Edit> visit_edits(const Fields& fields, const Configuration& now, const Configuration& site) {
    std::vector<Edit> edits{{{"visit", "language"}, unless_same(value_in(fields, "language"), site.visit.language)}};
    // Those that were offered stay in their order; the order of the buttons is theirs.
    std::vector<std::string> offered = now.visit.languages;
    std::erase_if(offered, [&](const std::string& code) { return !fields.contains("offers." + code); });
    for (const std::string_view code : genome::language_codes())
        if (fields.contains(fmt::format("offers.{}", code)) && std::ranges::find(offered, code) == offered.end())
            offered.emplace_back(code);
    edits.push_back({{"visit", "languages"}, unless_same(offered, site.visit.languages)});
    const auto add = [&](std::span<const NumberKey> keys) {
        for (const NumberKey& key : keys) {
            const auto number = number_in(fields, key.key, key.key);
            std::optional<CuratedValue> value;
            if (number == value_of(site.visit, key))
                ;  // as the site's
            else if (number && key.count != nullptr && *number == std::clamp(*number, -1e9, 1e9) &&
                     *number == static_cast<double>(static_cast<std::int64_t>(*number)))
                value = static_cast<std::int64_t>(*number);
            else if (number)
                value = *number;
            edits.push_back({{"visit", key.key}, value});
        }
    };
    add(kTimes);
    add(kDescribing);
    return edits;
}

// ---- words

Form words_form(const Configuration& now, const Texts& say) {
    Form form;
    form.hint = say("words.hint");
    form.groups.push_back(locks(now.breeding.locked, say));
    for (const genome::Aspect aspect : genome::kAspects) form.groups.push_back(words_of(aspect, now.words, say));
    return form;
}

std::vector<Edit> words_edits(const Fields& fields, const Configuration& site) {
    std::vector<Edit> edits{{{"breeding", "locked"}, unless_same(locked_in(fields), site.breeding.locked)}};
    for (const genome::Word& word : genome::vocabulary()) {
        const std::string name(word.name);
        const auto range = range_in(fields, name);
        std::optional<CuratedValue> value;
        const auto of_the_site = site.words.find(name);
        if (range && (of_the_site == site.words.end() || of_the_site->second != *range)) value = *range;
        // No limit, where the site has one, is said too.
        if (!range && of_the_site != site.words.end()) value = std::array{-1.0, 1.0};
        edits.push_back({{"words", name}, value});
    }
    return edits;
}

// ---- texts

std::map<std::string, std::string> own_texts(const Configuration& configuration, const std::string& code) {
    std::map<std::string, std::string> own;
    if (code == configuration.visit.language) own = configuration.texts;
    if (const auto found = configuration.texts_in.find(code); found != configuration.texts_in.end())
        for (const auto& [key, words] : found->second) own[key] = words;
    return own;
}

Form texts_form(const Fields& query, const Configuration& now, const Texts& say) {
    const std::string code = spoken_in(query, now);
    Form form;
    form.others = languages_beside("/curator/texts?");
    form.current = "/curator/texts?in=" + code;
    form.kept = {{"in", code}, {"part", "texts"}};
    form.groups = {texts_of(code, own_texts(now, code), say)};
    return form;
}

std::vector<Edit> texts_edits(const Fields& fields, const Configuration& now, const Configuration& site) {
    const std::string code = spoken_in(fields, now);
    const auto written = texts_in(fields);
    const auto of_the_site = own_texts(site, code);
    std::vector<Edit> edits;
    for (const std::string_view prompt : genome::kPrompts) {
        const std::string key(prompt);
        const auto words = written.find(key);
        const auto standing = of_the_site.find(key);
        std::optional<CuratedValue> value;
        if (words != written.end() && (standing == of_the_site.end() || standing->second != words->second))
            value = words->second;
        // The language's own words, where the site has others, are said too.
        if (words == written.end() && standing != of_the_site.end()) value = std::string(genome::prompt(code, key));
        edits.push_back({{"text", code, key}, value});
    }
    return edits;
}

}  // namespace

std::vector<std::string> curator_parts() { return {"hours", "visit", "texts", "words", "themes"}; }

std::optional<Form> curator_form(const std::string& part, const Fields& query, const Texts& say,
                                 const Configuration& now) {
    std::optional<Form> form;
    if (part == "hours") form = hours_form(now, say);
    if (part == "visit") form = visit_form(now, say);
    if (part == "words") form = words_form(now, say);
    if (part == "texts") form = texts_form(query, now, say);
    if (part == "themes") form = themes_form(now, say);
    if (part == "theme") form = theme_form(query, now, say);
    if (form) form->part = part;
    return form;
}

std::vector<Edit> curator_edits(const std::string& part, const Fields& fields, desk::Curator::Deed deed,
                                const Configuration& now, const Configuration& site) {
    if (part == "hours") return hours_edits(fields, site);
    if (part == "visit") return visit_edits(fields, now, site);
    if (part == "words") return words_edits(fields, site);
    if (part == "texts") return texts_edits(fields, now, site);
    if (part == "theme") return theme_edits(fields, deed, now, site);
    return {{{"visit", "theme"}, unless_same(value_in(fields, "theme"), site.visit.theme)}};
}

}  // namespace quadrat::commands
