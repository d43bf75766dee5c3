// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <future>
#include <mutex>
#include <optional>

#include "archive/archive.hpp"
#include "breeding/words/lessons.hpp"

namespace quadrat::kiosk {

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

// The night a moment of the site's own time belongs to, counted in days: it changes at three in the morning.
std::int64_t night_of(archive::WallTime local);

// Trains the word map on what visitors said, beside everything else: nobody waits for it.
class School {
  public:
    explicit School(std::filesystem::path folder) : folder_(std::move(folder)), known_(site_words(folder_)) {}
    ~School() = default;  // waits for the lesson under way

    // The map as it is now, and the one before, by which a visit may have begun. From the thread that takes.
    const breeding::WordMap& map() const { return known_.map; }
    std::optional<breeding::WordMap> map_before() const;

    // Begins to train on these answers and the curator's lessons; from any thread. One that is under way goes on
    // instead. What is refused, and why, is logged; what is taken is kept on disk.
    void begin(archive::WordAnswers answers);

    // Takes over what was learnt, if anything was; true when the map is another.
    bool take();

    void wait();  // for the lesson under way

  private:
    std::filesystem::path folder_;
    SiteWords known_;
    std::mutex mutex_;
    std::future<std::optional<SiteWords>> lesson_;
};

}  // namespace quadrat::kiosk
