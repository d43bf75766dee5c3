// SPDX-License-Identifier: Apache-2.0
#include "sound/speaker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/owned.hpp"
#include "sound/wav.hpp"

extern char** environ;

namespace quadrat::sound {
namespace {

constexpr std::size_t kMostBytes = 16U << 20U;
constexpr int kPatience_ms = 4'000;  // without a byte

// What a program says that is given a text.
class Reading {
  public:
    // 0, or an error of errno.
    int start(const std::string& program, const std::string& voice, const std::string& text) {
        // A file in memory: whoever does not read it to its end harms nobody, as with a pipe he would.
        const base::OwnedDescriptor script(::memfd_create("speech", MFD_CLOEXEC));
        std::array<int, 2> ends{};
        if (!script || ::pipe2(ends.data(), O_CLOEXEC) != 0) return errno;
        from_ = base::OwnedDescriptor(ends[0]);
        const base::OwnedDescriptor to(ends[1]);
        if (::write(script.get(), text.data(), text.size()) < 0 || ::lseek(script.get(), 0, SEEK_SET) < 0) return errno;
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, script.get(), STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, to.get(), STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        std::array<std::string, 7> words{program, "-v", voice, "-s", "150", "--stdin", "--stdout"};
        std::array<char*, 8> arguments{};
        for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
        const int error = ::posix_spawnp(&process_, program.c_str(), &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0) process_ = 0;
        return error;
    }

    // Nothing: it hung, or said too much.
    std::optional<std::string> hear() {
        std::string bytes;
        std::vector<char> part(65'536);
        for (;;) {
            pollfd ready{from_.get(), POLLIN, 0};
            if (::poll(&ready, 1, kPatience_ms) <= 0) return std::nullopt;
            const auto got = ::read(from_.get(), part.data(), part.size());
            if (got <= 0) return bytes;
            bytes.append(part.data(), static_cast<std::size_t>(got));
            if (bytes.size() > kMostBytes) return std::nullopt;
        }
    }

    // Its exit status, -1 for one that had to be ended.
    int end() {
        if (process_ == 0) return -1;
        from_ = {};
        const pid_t process = std::exchange(process_, 0);
        int status = 0;
        // Its last byte was read: it ends at once by itself, or never.
        for (int i = 0; i < 30; ++i) {
            if (::waitpid(process, &status, WNOHANG) != 0) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            ::poll(nullptr, 0, 10);
        }
        ::kill(process, SIGKILL);
        ::waitpid(process, &status, 0);
        return -1;
    }
    ~Reading() { end(); }

  private:
    pid_t process_ = 0;
    base::OwnedDescriptor from_;
};

constexpr std::array<std::string_view, 10> kForEyes{"←", "→", "…", "−", "–", "—", "·", "•", "»", "«"};

}  // namespace

Speaker::Speaker(std::filesystem::path folder, std::string program)
    : folder_(std::move(folder)), program_(std::move(program)) {}

std::vector<float> Speaker::say(const Utterance& utterance) {
    trouble_.clear();
    try {
        const auto recorded = folder_ / utterance.language / (utterance.key + ".wav");
        std::error_code ignored;
        if (!folder_.empty() && !utterance.key.empty() && std::filesystem::exists(recorded, ignored))
            return speech_from_wav(base::read_file(recorded, kMostBytes), recorded.string());
        const std::string text = readable(utterance.text);
        if (text.find_first_not_of(' ') == std::string::npos) return {};
        if (voice_of(utterance.language) == "ja")  // it names each kanji "Chinese letter"
            throw base::InputError(fmt::format("{} cannot read Japanese; it wants recordings", program_));
        Reading reading;
        if (const int error = reading.start(program_, voice_of(utterance.language), text + "\n"); error != 0)
            throw base::InputError(fmt::format("{}: {}; apt install espeak-ng", program_, std::strerror(error)));
        const auto bytes = reading.hear();
        const int status = reading.end();
        if (!bytes) throw base::InputError(fmt::format("{} does not answer", program_));
        if (bytes->empty() || status != 0)
            throw base::InputError(
                fmt::format("{} has no voice for the language {}; it wants recordings", program_, utterance.language));
        return speech_from_wav(*bytes, program_);
    } catch (const base::InputError& error) {
        trouble_ = error.what();
        return {};
    }
}

std::string voice_of(std::string_view language) {
    if (language == "zh") return "cmn-latn-pinyin";  // "cmn" reads the tones' numbers aloud, in English
    if (language == "en") return "en-gb";
    if (language == "fr") return "fr-fr";
    return std::string(language.substr(0, language.find_first_of("-_.")));
}

std::string readable(std::string_view text) {
    std::string read;
    while (!text.empty()) {
        std::size_t dropped = 0;
        for (const std::string_view sign : kForEyes)
            if (text.starts_with(sign)) dropped = sign.size();
        if (dropped > 0) {
            // A pause, where one thing ends and the next begins.
            const bool is_pause = text.starts_with("·") && read.find_first_not_of(' ') != std::string::npos;
            while (is_pause && read.ends_with(' ')) read.pop_back();
            read += is_pause ? ';' : ' ';
            text.remove_prefix(dropped);
            continue;
        }
        read += text.front();
        text.remove_prefix(1);
    }
    const std::size_t from = read.find_first_not_of(' ');
    return from == std::string::npos ? "" : read.substr(from);
}

double speaking_time_s(const Utterance& utterance) {
    constexpr double kPause_s = 0.4, kLetter_s = 0.072, kConsonant_s = 0.095, kSyllable_s = 0.23;
    double seconds = kPause_s;
    for (const char byte : readable(utterance.text)) {
        const auto value = static_cast<unsigned char>(byte);
        if (value >= 0xE3)
            seconds += kSyllable_s;  // a sign of Chinese or Japanese
        else if (value >= 0xD6 && value <= 0xDB)
            seconds += kConsonant_s;  // of Hebrew or Arabic, which leave out vowels
        else if (value < 0x80 || value >= 0xC0)
            seconds += kLetter_s;
    }
    return seconds;
}

}  // namespace quadrat::sound
