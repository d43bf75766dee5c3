// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "desk/http.hpp"
#include "desk/sessions.hpp"

namespace quadrat::desk {

// One thing that was looked at: as the doctor says it.
struct Finding {
    std::string subject, verdict;  // "good", "doubtful" or "bad"
    std::string what, remedy;      // the remedy may be ""
};

// What staff may have the exhibit do.
enum class Act { StandBy, Wake, Restart };

// What the desk tells and does. Any may throw InputError, whose words are shown.
struct Sources {
    std::string exhibit;                                  // its name, "" for none
    std::string version;                                  // of the program
    std::function<std::optional<std::string>()> health;   // JSON, as the exhibit says it; nothing: none runs
    std::function<std::optional<std::string>()> picture;  // PNG of the last seconds; nothing: there is none yet
    std::function<std::vector<Finding>()> examine;        // takes seconds
    std::function<std::string()> report;                  // a page of what visitors did
    std::function<std::string()> backup;                  // a file of what the site has made
    std::function<void(Act)> act;
    std::function<void(const std::string&)> note;  // who did what, for the list of what was done
    std::function<bool(const std::string&)> is_passphrase;
};

// Answers requests one after the other. Pages need a session, acts also the token of a form of ours; no answer may be
// kept or shown within another page.
class Desk {
  public:
    Desk(Sources sources, RandomBytes random, bool is_encrypted)
        : sources_(std::move(sources)), sessions_(std::move(random)), is_encrypted_(is_encrypted) {}

    Answer answer(const Request& request, Instant now);

  private:
    Answer route(const Request& request, Instant now);
    Answer log_in(const Request& request, Instant now);
    Answer carry_out(const Request& request);
    Answer page_of(const Request& request, const Sessions::Session& session);
    std::string cookie(const std::string& value, long seconds) const;

    Sources sources_;
    Sessions sessions_;
    bool is_encrypted_;  // by TLS: cookies go nowhere else then
};

}  // namespace quadrat::desk
