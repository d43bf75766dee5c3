// SPDX-License-Identifier: Apache-2.0
#include "site/wall_clock.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <sys/timex.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"

namespace quadrat::site {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::year kBuilt{2025};
constexpr std::chrono::year kTooLate{2100};
constexpr std::time_t kAgreeWithin_s = 60;
constexpr std::time_t kNoteEvery_s = 3600;
constexpr std::chrono::seconds kTryAgain{5};  // where the folder is not there yet, or cannot be written in

std::optional<std::time_t> first_number(const fs::path& file) {
    std::ifstream stream(file);
    std::string word;
    stream >> word;
    std::time_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = error == std::errc{} && end == word.data() + word.size();
    return is_number ? std::optional(value) : std::nullopt;
}

std::string utc_text(std::time_t at) {
    std::tm utc{};
    if (::gmtime_r(&at, &utc) == nullptr) return "no time at all";
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", utc);
}

bool is_close(std::time_t a, std::time_t b) {
    std::time_t apart = 0;
    return !__builtin_sub_overflow(a, b, &apart) && apart >= -kAgreeWithin_s && apart <= kAgreeWithin_s;
}

// "Europe/Berlin" of "/usr/share/zoneinfo/Europe/Berlin"; "" of what is no such name.
std::string zone_named_by(const std::string& path) {
    constexpr std::string_view kFolder = "zoneinfo/";
    const std::size_t at = path.rfind(kFolder);
    return at == std::string::npos ? "" : path.substr(at + kFolder.size());
}

std::string zone_name() {
    fs::path file = "/etc/localtime";
    if (const char* tz = std::getenv("TZ"); tz != nullptr && *tz != '\0') {
        file = *tz == ':' ? tz + 1 : tz;
        if (!file.is_absolute()) return file.string();
        file = file.lexically_normal();
    }
    const std::string named = zone_named_by(file.string());
    std::error_code error;
    return named.empty() ? zone_named_by(fs::read_symlink(file, error).string()) : named;
}

std::string zone_text(const std::tm& local) {
    const long minutes = local.tm_gmtoff / 60;
    const long distance = minutes < 0 ? -minutes : minutes;
    const std::string offset =
        fmt::format("{}, UTC{}{:02}:{:02}", local.tm_zone, minutes < 0 ? '-' : '+', distance / 60, distance % 60);
    const std::string name = zone_name();
    return name.empty() ? offset : fmt::format("{} ({})", name, offset);
}

struct RealTimeClocks {
    std::string agreeing;             // the name of one that agrees
    std::vector<std::string> others;  // "rtc0 shows 1970-01-01 00:00:41 UTC"
};

RealTimeClocks look_at_real_time_clocks(const fs::path& sys, std::time_t now) {
    RealTimeClocks clocks;
    std::error_code error;
    for (fs::directory_iterator entry{sys / "class/rtc", error}, end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const auto shown = first_number(entry->path() / "since_epoch");
        if (!shown)
            clocks.others.push_back(name + " cannot be read");
        else if (is_close(*shown, now))
            clocks.agreeing = clocks.agreeing.empty() ? name : std::min(clocks.agreeing, name);
        else
            clocks.others.push_back(fmt::format("{} shows {}", name, utc_text(*shown)));
    }
    std::sort(clocks.others.begin(), clocks.others.end());
    return clocks;
}

void doubt(WallClock& wall, std::string why, std::string remedy) {
    wall.doubt = std::move(why);
    wall.remedy = std::move(remedy);
}

constexpr const char* kSetIt =
    "connect a network (timedatectl set-ntp true), or set it: timedatectl set-time \"2026-12-24 10:00\"";

}  // namespace

LastTimeSeen::LastTimeSeen(const fs::path& state) : file_(state.empty() ? fs::path{} : state / "clock.seen") {}

std::optional<std::time_t> LastTimeSeen::read() const {
    const auto seen = file_.empty() ? std::nullopt : first_number(file_);
    return seen && *seen > 0 ? seen : std::nullopt;
}

void LastTimeSeen::note(std::time_t now) {
    const auto last = read();
    if (file_.empty() || (last && now >= *last && now - *last < kNoteEvery_s)) return;
    const auto at = std::chrono::steady_clock::now();
    if (at < next_try_) return;
    next_try_ = at + kTryAgain;
    try {
        base::write_file(file_, fmt::format("{} {}\n", now, utc_text(now)));
    } catch (const base::InputError& error) {
        base::log::debug("clock: {}", error.what());
    }
}

WallClock judge_clock(std::time_t now, bool is_synchronised, std::optional<std::time_t> last_seen,
                      const fs::path& sys) {
    std::tm local{};
    ::localtime_r(&now, &local);
    WallClock wall;
    wall.date = std::chrono::year_month_day{std::chrono::year{local.tm_year + 1900},
                                            std::chrono::month(static_cast<unsigned>(local.tm_mon + 1)),
                                            std::chrono::day(static_cast<unsigned>(local.tm_mday))};
    wall.minute = local.tm_hour * 60 + local.tm_min;
    wall.zone = zone_text(local);
    const RealTimeClocks clocks = look_at_real_time_clocks(sys, now);
    if (wall.date.year() < kBuilt || wall.date.year() >= kTooLate)
        doubt(wall, fmt::format("it shows the year {}", static_cast<int>(wall.date.year())), kSetIt);
    else if (is_synchronised)
        wall.source = "synchronised";
    else if (clocks.agreeing.empty() && clocks.others.empty())
        doubt(wall, "nothing synchronises it, and there is no real-time clock",
              "connect a network (timedatectl set-ntp true) or fit a clock module");
    else if (clocks.agreeing.empty())
        doubt(wall, fmt::format("nothing synchronises it, and {}", fmt::join(clocks.others, ", ")),
              "a new battery for the clock module, then connect a network (timedatectl set-ntp true) or set both: "
              "timedatectl set-time \"2026-12-24 10:00\"");
    else if (last_seen && now < *last_seen - kAgreeWithin_s)
        doubt(wall,
              fmt::format("it is before the last time seen, {}, and only {} agrees with it", utc_text(*last_seen),
                          clocks.agreeing),
              fmt::format("{}; if it is right now, delete clock.seen in the state folder", kSetIt));
    else
        wall.source = clocks.agreeing;
    wall.is_trusted = !wall.source.empty();
    return wall;
}

WallClock read_wall_clock(const LastTimeSeen& seen, const fs::path& sys) {
    const std::time_t now = ::time(nullptr);
    struct timex state {};
    const bool is_synchronised = ::adjtimex(&state) >= 0 && (state.status & STA_UNSYNC) == 0;
    return judge_clock(now, is_synchronised, seen.read(), sys);
}

std::string time_text(const WallClock& wall) {
    return fmt::format("{} {:02}:{:02} {}", date_text(wall.date), wall.minute / 60, wall.minute % 60, wall.zone);
}

void use_zone(const std::string& name) {
    if (name.empty()) return;
    ::setenv("TZ", name.c_str(), 1);
    ::tzset();
}

ZoneWatch::ZoneWatch(const fs::path& zoneinfo) {
    ::tzset();
    const char* tz = std::getenv("TZ");
    if (tz == nullptr || *tz == '\0') return;
    const std::string name = *tz == ':' ? tz + 1 : tz;
    const fs::path file = name.starts_with('/') ? fs::path(name) : zoneinfo / name;
    std::error_code error;
    if (!name.empty() && fs::is_regular_file(file, error)) file_ = file;
    stamp_ = stamp();
}

ZoneWatch::Stamp ZoneWatch::stamp() const {
    struct stat found {};
    if (::stat(file_.c_str(), &found) != 0) return {};
    return {found.st_dev, found.st_ino, found.st_mtim.tv_sec * 1'000'000'000LL + found.st_mtim.tv_nsec};
}

void ZoneWatch::look() {
    const Stamp now = stamp();
    if (!file_.empty() && now.inode != 0 && std::exchange(stamp_, now) != now) {
        // tzset() looks at the file again only where TZ itself has changed: here, by another spelling of the same path.
        // That does not move the environment's table under another thread's getenv(): the variable is there already.
        is_respelled_ = !is_respelled_;
        ::setenv("TZ",
                 (is_respelled_ ? ":" + (file_.parent_path() / "." / file_.filename()).string() : ":" + file_.string())
                     .c_str(),
                 1);
    }
    ::tzset();
}

}  // namespace quadrat::site
