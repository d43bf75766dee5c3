// SPDX-License-Identifier: Apache-2.0
#include "learning/school.hpp"

#include <fmt/format.h>

#include "backup/staged.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text_file.hpp"
#include "learning/past_visits.hpp"

namespace quadrat::learning {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargest = 64U << 20U;
constexpr const char* kTaste = "taste.json";
constexpr const char* kTasteBefore = "taste.previous.json";

fs::path words_file(const fs::path& folder) { return folder / "words.json"; }
fs::path previous_file(const fs::path& folder) { return folder / "words.previous.json"; }

// A file that cannot be read is kept for whoever may want to mend it, under a dated name.
void set_aside_if_damaged(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(words_file(folder), ignored)) return;
    try {
        breeding::word_lessons_from(base::read_file(words_file(folder), kLargest), words_file(folder).string());
    } catch (const base::InputError&) {
        using std::chrono::system_clock;
        const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(system_clock::now());
        fs::rename(words_file(folder), folder / backup::dated_name(folder, "words.json.damaged", now), ignored);
    }
}

SiteWords words_in(const fs::path& file) {
    breeding::Lessons lessons = breeding::word_lessons_from(base::read_text(file, base::kJsonLimits), file.string());
    breeding::WordMap map = breeding::map_of(lessons);
    return {std::move(lessons), std::move(map)};
}

// The whole lesson, on a thread of its own.
std::optional<SiteWords> learnt(const fs::path& folder, const SiteWords& known, const archive::WordAnswers& answers) {
    if (answers.unreadable > 0)
        base::log::warn("words: {} answers speak of what this program does not know, and are left out",
                        answers.unreadable);
    // Answers that are gone, with a damaged state file say, are no reason to forget what was learnt from them.
    if (answers.readable.empty()) return std::nullopt;
    const breeding::Lessons wanted{known.lessons.curator, breeding::lessons_from(answers.readable)};
    if (wanted == known.lessons) return std::nullopt;
    breeding::Training training = breeding::train(wanted, known.lessons, known.map, breeding::Worse::Refuse);
    for (const std::string& line : training.said) base::log::warn("words: {}", line);
    if (training.lessons == known.lessons) return std::nullopt;
    try {
        keep_site_words(folder, training.lessons);
    } catch (const base::InputError& error) {
        base::log::error("words: {}; what was learnt holds until the program ends", error.what());
    }
    base::log::info("words: learnt from {} answers", answers.readable.size());
    return SiteWords{std::move(training.lessons), std::move(training.map)};
}

// Nothing where nobody chose anything new.
std::optional<breeding::Taste> learnt_taste(const fs::path& folder) {
    try {
        breeding::Taste taste = counted_taste(folder);
        if (taste == site_taste(folder)) return std::nullopt;
        keep_site_taste(folder, taste);
        return taste;
    } catch (const base::InputError& error) {
        base::log::warn("taste: {}; what was learnt before holds", error.what());
        return std::nullopt;
    }
}

}  // namespace

breeding::Taste previous_site_taste(const fs::path& folder) {
    try {
        const fs::path file = folder / kTasteBefore;
        std::error_code ignored;
        if (!fs::exists(file, ignored)) return {};
        return breeding::taste_from(base::read_text(file, base::kJsonLimits), file.string());
    } catch (const base::InputError&) {
        return {};
    }
}

breeding::Taste site_taste(const fs::path& folder) {
    const fs::path file = folder / kTaste;
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    try {
        return breeding::taste_from(base::read_text(file, base::kJsonLimits), file.string());
    } catch (const base::InputError& error) {
        base::log::warn("taste: {}; all named scenes are as likely as before", error.what());
        return {};
    }
}

void keep_site_taste(const fs::path& folder, const breeding::Taste& taste) {
    base::write_file(folder / kTasteBefore, to_json(site_taste(folder)));
    base::write_file(folder / kTaste, to_json(taste));
}

breeding::Taste counted_taste(const fs::path& folder) {
    breeding::Taste taste = site_taste(folder);
    const breeding::WordMap map = site_words(folder).map;
    for (const EndedVisit& visit : ended_visits_in(folder, taste.since, kMostVisits))
        breeding::add(taste, map, visit.bred, visit.judged);
    taste.since = std::max(taste.since, last_visit_in(folder));
    return taste;
}

SiteWords site_words(const fs::path& folder) {
    std::error_code ignored;
    const fs::path file = words_file(folder);
    if (!fs::exists(file, ignored)) return {{}, breeding::default_word_map()};
    try {
        return words_in(file);
    } catch (const base::InputError& error) {
        base::log::warn("words: {}; the default map is used", error.what());
        return {{}, breeding::default_word_map()};
    }
}

std::optional<SiteWords> previous_site_words(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(previous_file(folder), ignored)) return std::nullopt;
    try {
        return words_in(previous_file(folder));
    } catch (const base::InputError&) {
        return std::nullopt;
    }
}

void keep_site_words(const fs::path& folder, const breeding::Lessons& lessons) {
    std::error_code error;
    fs::create_directories(folder, error);
    set_aside_if_damaged(folder);
    // Nothing before the first lesson is a map too: the default one.
    const std::string before = fs::exists(words_file(folder), error) ? base::read_file(words_file(folder), kLargest)
                                                                     : to_json(breeding::Lessons{});
    base::write_file(previous_file(folder), before);
    base::write_file(words_file(folder), to_json(lessons));
}

std::int64_t night_of(archive::WallTime local) {
    return std::chrono::floor<std::chrono::days>(local - std::chrono::hours{3}).time_since_epoch().count();
}

std::optional<breeding::WordMap> School::map_before() const {
    const auto before = previous_site_words(folder_);
    if (!before) return std::nullopt;
    return before->map;
}

breeding::Taste School::taste_before() const {
    return of_taste_ == OfTaste::Learn ? previous_site_taste(folder_) : breeding::Taste{};
}

void School::begin(archive::WordAnswers answers) {
    const std::scoped_lock lock(mutex_);
    if (lesson_.is_something()) return;
    lesson_ = teacher_.begin(
        [folder = folder_, known = known_, answers = std::move(answers), is_learning = of_taste_ == OfTaste::Learn] {
            Learnt all{learnt(folder, known, answers), std::nullopt};
            if (is_learning) all.taste = learnt_taste(folder);
            return all;
        });
}

bool School::take() {
    const std::scoped_lock lock(mutex_);
    if (!lesson_.is_something() || !lesson_.is_over()) return false;
    Learnt learnt = lesson_.get();
    if (learnt.words) known_ = std::move(*learnt.words);
    if (learnt.taste) taste_ = std::move(*learnt.taste);
    return learnt.words || learnt.taste;
}

void School::wait() {
    const std::scoped_lock lock(mutex_);
    lesson_.wait();
}

}  // namespace quadrat::learning
