// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/worker.hpp"
#include "hearing/health.hpp"
#include "hearing/narrator.hpp"
#include "site/configuration.hpp"
#include "sound/player.hpp"
#include "sound/speaker.hpp"

namespace quadrat::hearing {

// Who plays what is to be heard: a player for the room, one for a handset where the site has one, and a speaker on a
// thread of its own. No call waits.
class Concert {
  public:
    Concert(const site::Configuration::Sound& settings, base::Seed seed);

    void play(const std::vector<Cue>& cues);
    void surround(const sound::Surroundings& surroundings);
    void follow(const site::Configuration::Sound& settings);  // how loud
    void louder();  // for whoever listens to speech, until their visit ends; from the loudest to the quietest
    void end_visit();
    Health health() const;

  private:
    void carry_out(const sound::Sounds& cue);
    void carry_out(const Says& cue);
    void carry_out(const Hushes& cue);
    void tell_all(const sound::Order& order);
    void set_levels();
    void say(std::int64_t number, const sound::Utterance& utterance);  // the speaker's thread

    site::Configuration::Sound settings_;
    double listened_level_;  // of whoever listens to speech
    sound::Soundscape soundscape_;
    sound::Player room_;
    std::unique_ptr<sound::Player> handset_;  // or null
    std::int64_t numbered_ = 0;
    sound::Speaker speaker_;    // of the speaker's thread alone
    mutable std::mutex mutex_;  // of what follows; held for moments
    std::int64_t hushed_before_ = 0;
    std::string trouble_;
    // A question, its choices and what came before them: who is told faster than anybody can speak hears the newest.
    base::Worker speaking_{{.name = "speech",
                            .bound = 13,
                            .when_full = base::WorkerOptions::WhenFull::DropOldest,
                            .at_end = base::WorkerOptions::AtEnd::Drop}};  // last: it ends before what it uses
};

}  // namespace quadrat::hearing
