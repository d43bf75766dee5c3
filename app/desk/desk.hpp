// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "desk/curator.hpp"
#include "desk/http.hpp"
#include "desk/sessions.hpp"
#include "desk/texts.hpp"

namespace quadrat::desk {

// One thing that was looked at: as the doctor says it.
struct Finding {
    std::string subject, verdict;  // "good", "doubtful" or "bad"
    std::string what, remedy;      // the remedy may be ""
};

// A warning or an error of the exhibit's, however often it came.
struct Fault {
    std::string text, first, last;  // with their dates in words
    int count = 1;
    std::string picture;  // "fault-3.png": its name for fault_picture; "" for none
};

// What staff may have the exhibit do.
enum class Act { TestLamps, StandBy, Wake, Restart, SafeMode, UsualMode };

// A backup that was brought, and what it would change.
struct Preview {
    struct File {
        std::string name;
        std::optional<std::uint64_t> here, there;  // bytes; nothing: there is none
    };
    std::string made_at, host, program;
    std::vector<File> files;
};
enum class Identity { OfTheBackup, OfTheMachine };

// What the desk tells and does. Any may throw InputError, whose words are shown.
struct Sources {
    std::string exhibit;                                  // its name, "" for none
    std::string version;                                  // of the program
    std::function<std::optional<std::string>()> health;   // JSON, as the exhibit says it; nothing: none runs
    std::function<std::optional<std::string>()> picture;  // PNG of the last seconds; nothing: there is none yet
    std::function<std::string()> full_picture;            // PNG of this moment, at full size; takes a second
    std::function<std::vector<Fault>()> faults;           // newest first
    std::function<std::optional<std::string>(const std::string& name)> fault_picture;  // PNG
    std::function<std::vector<std::string>()> log;    // the exhibit's last lines, the newest last, without secrets
    std::function<std::vector<std::string>()> notes;  // what was done here, the newest last
    std::function<std::vector<Finding>()> examine;    // takes seconds
    // A page of what visitors did, with a link back, named so.
    std::function<std::string(const std::string& back)> report;
    std::function<std::string()> backup;  // a file of what the site has made
    // Looks into a file that was brought, and keeps it in place of the one before it.
    std::function<Preview(const std::filesystem::path& brought)> preview;
    std::function<void(Identity)> restore;  // the file that was kept
    std::function<void()> drop;             // likewise: nothing of it stays
    std::function<void(Act)> act;
    std::function<void(const std::string&)> note;  // who did what, for the list of what was done
    std::function<bool(const std::string&)> is_passphrase;
    Curator curator;
};

struct View;  // pages.hpp

// Answers requests one after the other. Pages need a session, acts also the token of a form of ours; no answer may be
// kept or shown within another page.
class Desk {
  public:
    Desk(Sources sources, RandomBytes random, bool is_encrypted)
        : sources_(std::move(sources)), sessions_(std::move(random)), is_encrypted_(is_encrypted) {}

    Answer answer(const Request& request, Instant now);

    // Whether this one may bring a file: whoever has a session, to the page that takes one.
    bool takes_file(const Request& request, Instant now);
    // Likewise a form of more than some lines, as the curator's are.
    bool takes_long_form(const Request& request, Instant now);

  private:
    Answer route(const Request& request, Instant now);
    Answer refuse(const Request& request, int status, const char* why) const;
    Answer log_in(const Request& request, Instant now);
    Answer log_out(const Request& request);
    Answer carry_out(const Request& request);
    Answer look_into(const Request& request);
    Answer restore(const Request& request, Identity identity);
    View view_of(const Request& request, const Sessions::Session& session) const;
    Answer page_of(const Request& request, const Sessions::Session& session);
    std::optional<Answer> file_of(const Request& request);
    std::string cookie(const std::string& value, long seconds) const;

    Sources sources_;
    Sessions sessions_;
    bool is_encrypted_;               // by TLS: cookies go nowhere else then
    std::optional<Preview> preview_;  // of the file that was brought last
};

}  // namespace quadrat::desk
