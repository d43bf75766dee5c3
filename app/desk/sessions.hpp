// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace quadrat::desk {

using Instant = std::chrono::milliseconds;  // since any fixed moment; never goes back
using RandomBytes = std::function<std::string(std::size_t count)>;

// Who has logged in, and who tries too often. One thread.
class Sessions {
  public:
    static constexpr Instant kIdle = std::chrono::minutes{30};   // a session ends when nobody asked for so long
    static constexpr Instant kLongest = std::chrono::hours{12};  // and at the latest then
    static constexpr std::size_t kMost = 32;                     // the oldest ends for a new one
    static constexpr int kTries = 5;                             // wrong passphrases of one address
    static constexpr int kTriesOfAll = 30;                       // and of all of them
    static constexpr Instant kForgiven = std::chrono::minutes{5};

    explicit Sessions(RandomBytes random) : random_(std::move(random)) {}

    struct Session {
        Instant began{0}, asked{0};
        std::string form_token;  // in each form: only a page of ours knows it
    };

    // The cookie's value of a new session.
    std::string begin(Instant now);
    // The session of a cookie, and that it was asked for now; null where there is none, or no longer.
    const Session* find(const std::string& cookie, Instant now);
    void end(const std::string& cookie) { sessions_.erase(cookie); }
    void end_all() { sessions_.clear(); }

    // How long an address has to wait before another try; nothing: it may try.
    std::optional<Instant> wait_of(const std::string& peer, Instant now);
    void failed(const std::string& peer, Instant now);

  private:
    struct Failure {
        std::string peer;
        Instant at{0};
    };
    RandomBytes random_;
    std::map<std::string, Session> sessions_;  // by cookie
    std::deque<Failure> failures_;             // oldest first
};

}  // namespace quadrat::desk
