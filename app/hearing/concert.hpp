// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "hearing/health.hpp"
#include "hearing/narrator.hpp"
#include "site/configuration.hpp"
#include "sound/player.hpp"

namespace quadrat::hearing {

// Who plays what is to be heard: a player for the room, one for a handset where the site has one, and a speaker on a
// thread of its own. No call waits.
class Concert {
  public:
    Concert(const site::Configuration::Sound& settings, base::Seed seed);
    ~Concert();
    Concert(const Concert&) = delete;
    Concert& operator=(const Concert&) = delete;

    void play(const std::vector<Cue>& cues);
    void surround(const sound::Surroundings& surroundings);
    void follow(const site::Configuration::Sound& settings);  // how loud
    void louder();  // for whoever listens to speech, until their visit ends; from the loudest to the quietest
    void end_visit();
    Health health() const;

  private:
    struct ToSay {
        std::int64_t number;
        sound::Utterance utterance;
    };
    void carry_out(const sound::Sounds& cue);
    void carry_out(const Says& cue);
    void carry_out(const Hushes& cue);
    void tell_all(const sound::Order& order);
    void set_levels();
    void speak();  // the speaker's thread

    site::Configuration::Sound settings_;
    double listened_level_;  // of whoever listens to speech
    sound::Soundscape soundscape_;
    sound::Player room_;
    std::unique_ptr<sound::Player> handset_;  // or null
    std::int64_t numbered_ = 0;
    mutable std::mutex mutex_;  // of what follows; held for moments
    std::condition_variable has_work_;
    std::deque<ToSay> to_say_;
    std::int64_t hushed_before_ = 0;
    bool is_over_ = false;
    std::string trouble_;
    std::thread speaker_;  // last: it ends before what it uses
};

}  // namespace quadrat::hearing
