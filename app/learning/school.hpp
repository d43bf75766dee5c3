// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <mutex>
#include <optional>

#include "archive/archive.hpp"
#include "base/worker.hpp"
#include "breeding/belief/taste.hpp"
#include "breeding/words/lessons.hpp"

namespace quadrat::learning {

// What a site has taught: in the state folder, words.json, and in words.previous.json what it replaced.
struct SiteWords {
    breeding::Lessons lessons;
    breeding::WordMap map;
};

// What the folder holds: the default map where there is no file, and also, said in one line of the log, where the file
// is damaged or of another version. There always is a map.
SiteWords site_words(const std::filesystem::path& folder);

// The one before; nothing where there is none that can be read.
std::optional<SiteWords> previous_site_words(const std::filesystem::path& folder);

// Whole or not at all; what was there becomes words.previous.json or, where it is damaged, a dated file. Throws
// InputError naming the file.
void keep_site_words(const std::filesystem::path& folder, const breeding::Lessons& lessons);

// What the site's visitors ended up with: taste.json. Nothing where there is no such file, and also, said in one line
// of the log, where it cannot be read.
breeding::Taste site_taste(const std::filesystem::path& folder);
// The one before: taste.previous.json. None, in silence, where there is no such file.
breeding::Taste previous_site_taste(const std::filesystem::path& folder);
void keep_site_taste(const std::filesystem::path& folder, const breeding::Taste& taste);

// The same with the visits since, the newest kMostVisits of them: bred again, as they were bred by this taste. Throws
// InputError where the state file cannot be read.
inline constexpr std::size_t kMostVisits = 600;
breeding::Taste counted_taste(const std::filesystem::path& folder);

// The night a moment of the site's own time belongs to, counted in days: it changes at three in the morning.
std::int64_t night_of(archive::WallTime local);

// Trains the word map on what visitors said, beside everything else: nobody waits for it. Its end waits for the lesson
// under way.
class School {
  public:
    enum class OfTaste { Learn, Ignore };
    explicit School(std::filesystem::path folder, OfTaste of_taste = OfTaste::Ignore)
        : folder_(std::move(folder)),
          of_taste_(of_taste),
          known_(site_words(folder_)),
          taste_(of_taste == OfTaste::Learn ? site_taste(folder_) : breeding::Taste{}) {}

    // Map and taste as they are now, and the ones before, by which a visit may have begun. From the thread that takes.
    const breeding::WordMap& map() const { return known_.map; }
    std::optional<breeding::WordMap> map_before() const;
    const breeding::Taste& taste() const { return taste_; }  // none where it is ignored
    breeding::Taste taste_before() const;                    // likewise

    // Begins to train on these answers and the curator's lessons; from any thread. One that is under way goes on
    // instead. What is refused, and why, is logged; what is taken is kept on disk.
    void begin(archive::WordAnswers answers);

    // Takes over what was learnt, if anything was; true when the map or the taste is another.
    bool take();

    void wait();  // for the lesson under way

  private:
    struct Learnt {
        std::optional<SiteWords> words;
        std::optional<breeding::Taste> taste;
    };

    std::filesystem::path folder_;
    OfTaste of_taste_;
    SiteWords known_;
    breeding::Taste taste_;
    std::mutex mutex_;
    base::Begun<Learnt> lesson_;  // until it is taken
    base::Worker teacher_{{.name = "school"}};
};

}  // namespace quadrat::learning
