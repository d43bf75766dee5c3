// SPDX-License-Identifier: Apache-2.0
// Machines and screens that behave as replays/*.txt say, and the plans that tempo makes of them. With
// QUADRAT_MAKE_GOLDENS=1 in the environment the files' own plans are written anew; the expectations are not.
//
//   period_ms 16.667                     the screen's refresh period from here on; 0: it has none
//   for 60 s: always_ms 4 level_ms 20    so long each frame takes always_ms and level_ms times the level to draw
//       growing 1                        and landscapes grow meanwhile
//       hiccup_ms 40 every_s 3600        and one frame in so many seconds takes so much longer
//       noise_ms 2                       and each up to so much longer
//   expect level 0.5 0.7 periods 1 1 ahead 0 0.01 late 0 0.01     of the last half of that time
//   plan 60 s: level 0.62 periods 1 wait                          what it had come to, to be looked at when it changes
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "base/seed.hpp"
#include "tempo/flight_log.hpp"
#include "tempo/tempo.hpp"

namespace quadrat::tempo {
namespace {

namespace fs = std::filesystem;

struct Behaviour {
    double seconds = 0;
    double always_ms = 0, level_ms = 0, noise_ms = 0;
    double hiccup_ms = 0, every_s = 0;
    bool is_growing = false;
};

nanoseconds ns(double ms) { return nanoseconds{static_cast<nanoseconds::rep>(ms * 1e6)}; }

// A machine that draws and a screen that shows, on a clock of their own.
class Replay {
  public:
    struct Seen {
        double level = 0, ahead = 0, late = 0, periods = 0;  // means
        Plan plan;
    };
    void set_period(double ms) { period_ = ns(ms); }
    Seen run(const Behaviour& behaviour) {
        const nanoseconds end = now_ + ns(1e3 * behaviour.seconds);
        const nanoseconds half = now_ + (end - now_) / 2;
        Seen seen;
        double frames = 0;
        while (now_ < end) {
            const FrameRecord record = frame(behaviour);
            if (record.shown.time_since_epoch() < half) continue;
            ++frames;
            seen.level += plan_.level;
            seen.periods += plan_.periods;
            seen.ahead += plan_.then == HandOver::Then::Ahead;
            seen.late += is_late(record);
        }
        for (double* mean : {&seen.level, &seen.ahead, &seen.late, &seen.periods}) *mean /= std::max(frames, 1.0);
        seen.plan = plan_;
        return seen;
    }

  private:
    FrameRecord frame(const Behaviour& behaviour) {
        HandOver how;
        how.begun = how.drawing_since = DisplayTime{now_};
        nanoseconds cost = ns(behaviour.always_ms + behaviour.level_ms * static_cast<double>(plan_.level) +
                              behaviour.noise_ms * noise_.unit());
        if (behaviour.every_s > 0 && now_ >= next_hiccup_) {
            cost += ns(behaviour.hiccup_ms);
            next_hiccup_ = now_ + ns(1e3 * behaviour.every_s);
        }
        // The processor is free when the frame is handed over; the GPU goes on where drawing takes longer.
        const nanoseconds frame_time = (period_.count() > 0 ? period_ : ns(16.667)) * plan_.periods;
        const nanoseconds drawn = now_ + cost;
        if (cost < frame_time * 9 / 10) how.drawn = DisplayTime{drawn};
        how.meant_periods = plan_.periods;
        how.then = plan_.then;
        nanoseconds handed_over = std::max(drawn, shown_);
        if (plan_.hand_over_at) handed_over = std::max(handed_over, plan_.hand_over_at->time_since_epoch());
        flights_.handed_over(++number_, how, DisplayTime{handed_over});
        const nanoseconds before = shown_;
        shown_ = period_.count() > 0 ? (handed_over / period_ + 1) * period_ : std::max(handed_over, now_ + frame_time);
        flights_.shown(DisplayTime{shown_}, period_);
        now_ = how.then == HandOver::Then::Wait ? shown_ : std::max(handed_over, before);
        const FrameRecord record = flights_.take_finished().front();
        Circumstances midst;
        midst.now = DisplayTime{now_};
        midst.period = period_;
        midst.act = 1;
        midst.is_growing = behaviour.is_growing;
        if (how.then == HandOver::Then::Ahead) midst.in_flight_since = DisplayTime{handed_over};
        // Drawn ahead, a frame is known to be shown only when the next one is handed over.
        std::vector<FrameRecord> known = std::exchange(pending_, {});
        (how.then == HandOver::Then::Wait ? known : pending_).push_back(record);
        plan_ = tempo_.next(known, midst);
        return record;
    }

    Tempo tempo_{TempoOptions{}};
    Plan plan_ = tempo_.plan();
    FlightLog flights_;
    std::vector<FrameRecord> pending_;
    base::RandomStream noise_{base::Seed{7}.child("noise")};
    nanoseconds period_ = ns(16.667);
    nanoseconds now_{0}, shown_{0}, next_hiccup_{std::chrono::seconds{30}};
    std::uint64_t number_ = 0;
};

double number_in(const std::map<std::string, double>& numbers, const char* name) {
    const auto found = numbers.find(name);
    return found == numbers.end() ? 0 : found->second;
}

Behaviour behaviour_in(std::istringstream& words) {
    Behaviour behaviour;
    std::string unit;
    words >> behaviour.seconds >> unit;
    std::map<std::string, double> numbers;
    std::string name;
    for (double number = 0; words >> name >> number;) numbers[name] = number;
    behaviour.always_ms = number_in(numbers, "always_ms");
    behaviour.level_ms = number_in(numbers, "level_ms");
    behaviour.noise_ms = number_in(numbers, "noise_ms");
    behaviour.hiccup_ms = number_in(numbers, "hiccup_ms");
    behaviour.every_s = number_in(numbers, "every_s");
    behaviour.is_growing = number_in(numbers, "growing") > 0;
    return behaviour;
}

void expect_seen(std::istringstream& words, const Replay::Seen& seen, const std::string& where) {
    const std::map<std::string, double> found{
        {"level", seen.level}, {"periods", seen.periods}, {"ahead", seen.ahead}, {"late", seen.late}};
    std::string name;
    for (double least = 0, most = 0; words >> name >> least >> most;) {
        ASSERT_TRUE(found.contains(name)) << where << ": " << name;
        EXPECT_GE(found.at(name), least) << where << ": " << name;
        EXPECT_LE(found.at(name), most) << where << ": " << name;
    }
}

void play(const fs::path& file) {
    std::ifstream in(file);
    Replay replay;
    Replay::Seen seen;
    std::string written;
    double seconds = 0;
    int expectations = 0;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        const std::string where = file.filename().string() + ": " + line;
        if (first == "plan") {
            EXPECT_EQ(line, fmt::format("plan {:.0f} s: level {:.2f} periods {} {}", seconds, seen.plan.level,
                                        seen.plan.periods, seen.plan.then == HandOver::Then::Wait ? "wait" : "ahead"))
                << file;
            continue;
        }
        written += line + "\n";
        if (first == "period_ms") {
            double period = 0;
            words >> period;
            replay.set_period(period);
        } else if (first == "for") {
            const Behaviour behaviour = behaviour_in(words);
            seen = replay.run(behaviour);
            seconds += behaviour.seconds;
            written += fmt::format("plan {:.0f} s: level {:.2f} periods {} {}\n", seconds, seen.plan.level,
                                   seen.plan.periods, seen.plan.then == HandOver::Then::Wait ? "wait" : "ahead");
        } else if (first == "expect") {
            expect_seen(words, seen, where);
            ++expectations;
        } else if (!first.empty() && first[0] != '#') {
            ADD_FAILURE() << where << ": not understood";
        }
    }
    EXPECT_GT(expectations, 0) << file;
    if (std::getenv("QUADRAT_MAKE_GOLDENS") != nullptr) std::ofstream(file) << written;
}

TEST(Replays, AreAnsweredWithThePlansThatTheFilesExpect) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(QUADRAT_SOURCE_DIR "/tests/unit/tempo/replays"))
        files.push_back(entry.path());
    ASSERT_GE(files.size(), 10U);
    std::ranges::sort(files);
    for (const fs::path& file : files) play(file);
}

}  // namespace
}  // namespace quadrat::tempo
