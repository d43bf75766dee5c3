// SPDX-License-Identifier: Apache-2.0
#include "staff/postcards.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/owned.hpp"
#include "pictures/png_picture.hpp"
#include "site/wall_clock.hpp"

extern char** environ;

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kPatience{30};
constexpr std::size_t kMostSaid = 400;

// A folder of our own, gone with what is in it.
class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "quadrat-postcard-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw base::InputError(fmt::format("{}: {}", name, std::strerror(errno)));
        folder_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& folder() const { return folder_; }

  private:
    fs::path folder_;
};

// What a program says until it ends, and how it ended: -1 for one that had to be.
struct Ended {
    int status = -1;
    std::string said;
};

// Reads what is there of both ends' one pipe; true: nothing more will come.
bool hear(int from, std::string& said) {
    std::array<char, 512> part{};
    const auto got = ::read(from, part.data(), part.size());
    if (got > 0 && said.size() < kMostSaid) said.append(part.data(), static_cast<std::size_t>(got));
    return got <= 0;
}

Ended ended(pid_t process, int from) {
    Ended end;
    const auto until = std::chrono::steady_clock::now() + kPatience;
    for (bool is_silent = false; std::chrono::steady_clock::now() < until;) {
        pollfd ready{from, POLLIN, 0};
        if (::poll(is_silent ? nullptr : &ready, is_silent ? 0 : 1, 50) > 0) is_silent = hear(from, end.said);
        int status = 0;
        if (::waitpid(process, &status, WNOHANG) == 0) continue;
        end.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return end;
    }
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
    end.said = fmt::format("it was not done within {} s", kPatience.count());
    return end;
}

std::string in_one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    while (text.ends_with(' ')) text.pop_back();
    return text;
}

}  // namespace

std::string print(const mesh::Image& card, const std::string& printer, const std::string& program) {
    try {
        const Scratch scratch;
        const fs::path file = scratch.folder() / "postcard.png";
        pictures::write_png_quickly(file, card);
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::strerror(errno);
        const base::OwnedDescriptor from(ends[0]);
        base::OwnedDescriptor to(ends[1]);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, to.get(), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, to.get(), STDERR_FILENO);
        std::array<std::string, 9> words{program, "-d",         printer, "-t", "Quadrat", "-o", "print-scaling=fit",
                                         "--",    file.string()};
        std::array<char*, 10> arguments{};
        for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
        pid_t process = 0;
        const int error = ::posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        to = {};
        if (error != 0) return fmt::format("{}: {}; apt install cups-client", program, std::strerror(error));
        const Ended end = ended(process, from.get());
        if (end.status == 0) return "";
        return fmt::format("printer {}: {}", printer, end.said.empty() ? "lp failed" : in_one_line(end.said));
    } catch (const base::InputError& error) {
        return error.what();
    }
}

pictures::Postcard blank_card(const site::Configuration& configuration, std::string title, std::string code,
                              const std::string& language) {
    pictures::Postcard card;
    card.title = std::move(title);
    card.code = std::move(code);
    card.reads_right_to_left = stage::is_written_from_the_right(language);
    // Apart from what is written the other way.
    const std::string when =
        fmt::format("\u2066{}\u2069", site::date_text(site::read_wall_clock(site::LastTimeSeen({})).date));
    const std::string& place = configuration.postcard.place;
    card.below = place.empty() ? when : fmt::format("{} · {}", place, when);
    return card;
}

void Postcards::wish(std::string title, std::string code, const std::string& language) {
    if (configuration_.postcard.printer.empty() || card_ || printing_.is_something()) return;
    card_ = blank_card(configuration_, std::move(title), std::move(code), language);
}

void Postcards::look(stage::Theatre& theatre, const nursery::Act& finale, const display::Canvas& canvas) {
    hear_of_the_last();
    if (!card_) return;
    if (!is_begun_) {
        is_begun_ = theatre.begin_portrait(finale, pictures::kOnPostcard_px, canvas);
        return;
    }
    auto picture = theatre.take_portrait();
    if (!picture) return;
    is_begun_ = false;
    pictures::Postcard card = *std::exchange(card_, std::nullopt);
    card.landscape = pictures::filling_postcard(*picture);
    printing_ = printer_.begin([card = std::move(card), printer = configuration_.postcard.printer] {
        return print(pictures::draw_postcard(card), printer);
    });
}

void Postcards::hear_of_the_last() {
    if (!printing_.is_something() || !printing_.is_over()) return;
    const std::string before = std::exchange(trouble_, printing_.get());
    if (trouble_.empty())
        base::log::info("a postcard goes to the printer {}", configuration_.postcard.printer);
    else if (trouble_ != before)
        base::log::warn("postcards: {}", trouble_);
}

}  // namespace quadrat::staff
