// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "projector/projector.hpp"

namespace quadrat::projector {

enum class Wanted { Off, On };

// What staff are told of it.
struct Told {
    std::optional<Power> power;  // when it was last asked; nothing: it never answered
    std::string trouble;         // "" where it is as wanted, or on its way
    std::string remedy;
    friend bool operator==(const Told&, const Told&) = default;
};

// Has a projector be as the exhibit is: on while that shows something, off while it is dark. Asks it every few minutes,
// since its plug may have been pulled meanwhile; is patient with one that warms up or cools down, and with one that
// does not answer. A reason for trouble is logged once.
class Keeper {
  public:
    using Moment = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::seconds kCheckEvery{300};
    static constexpr std::chrono::seconds kOnItsWay{5};      // until it is asked again
    static constexpr std::chrono::seconds kLongestWay{180};  // until it should have come there
    static constexpr std::chrono::seconds kFirstTry{5}, kLongestTry{300};

    explicit Keeper(Projector& projector) : projector_(projector) {}

    // Again and again. Waits for the projector, for seconds. Nothing wanted: it is left as it is. True: told() is new,
    // or as old as staff may see it.
    bool look(std::optional<Wanted> wanted, Moment now);
    const Told& told() const { return told_; }

  private:
    void see_to_it(Moment now);
    void settle(Moment now);
    void fail(const std::string& what, const std::string& remedy, Moment now);

    Projector& projector_;
    std::optional<Wanted> wanted_;
    Moment wanted_since_{};
    Moment next_{};
    std::chrono::seconds patience_ = kFirstTry;
    Told told_;
};

// What the one who keeps it writes for the others of this machine, in the exhibit's runtime folder.
inline constexpr const char* kTold = "projector.json";
std::string to_json(const Told& told);
// Nothing where nobody keeps it, or has not looked for long. Takes whatever lies there.
std::optional<Told> told_in(const std::filesystem::path& runtime, std::filesystem::file_time_type now);

}  // namespace quadrat::projector
