// SPDX-License-Identifier: Apache-2.0
// The program's own start, from its execution to what is first seen: on a fresh state, and after a kill in a visit.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "base/owned.hpp"
#include "benches/benches.hpp"
#include "benches/scratch.hpp"

namespace quadrat::benches {
namespace {

// A child whose log is read line by line; killed with this, as a pulled plug would.
class Exhibit {
  public:
    explicit Exhibit(std::vector<std::string> command) {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for the exhibit's log");
        log_.reset(::fdopen(ends[0], "r"));
        const base::OwnedDescriptor write(ends[1]);
        std::vector<char*> arguments;
        for (std::string& word : command) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        child_ = ::fork();
        if (child_ != 0) return;
        ::dup2(write.get(), STDERR_FILENO);
        ::execv("/proc/self/exe", arguments.data());
        ::_exit(127);
    }
    ~Exhibit() {
        if (child_ <= 0) return;  // -1 would be all processes there are
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
    }
    Exhibit(const Exhibit&) = delete;
    Exhibit& operator=(const Exhibit&) = delete;

    // The line that holds this text. Throws where the log ends before.
    std::string line_with(std::string_view text) {
        constexpr int kLongest = 4096;
        char line[kLongest];
        while (std::fgets(line, kLongest, log_.get()) != nullptr)
            if (std::string_view(line).find(text) != std::string_view::npos) return line;
        throw std::runtime_error(fmt::format("the exhibit ended before it said \"{}\"", text));
    }

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> log_;
    pid_t child_ = -1;
};

double told_ms(Exhibit& exhibit, const std::string& what) {
    const std::string line = exhibit.line_with("start: the first " + what);
    return 1000 * std::strtod(line.c_str() + line.find(" after ") + 7, nullptr);
}

}  // namespace

void start(Results& results, const Options& options) {
    const Scratch scratch;
    base::write_file(scratch.path / "visit.script", "at 5s press A\nwait 600s\n");
    const std::vector<std::string> command{"quadrat",   "run",
                                           "--display", "headless",
                                           "--size",    options.size,
                                           "--input",   "script:" + (scratch.path / "visit.script").string(),
                                           "--state",   (scratch.path / "state").string(),
                                           "--seed",    "5",
                                           "--speed",   "1.001"};  // the world's clock, though no hand presses
    for (const char* name : {"start.fresh", "start.again"}) {
        Exhibit exhibit(command);
        const double frame_ms = told_ms(exhibit, "frame");
        const double landscapes_ms = told_ms(exhibit, "landscapes");
        results.push_back({fmt::format("{}_first_frame_ms", name), frame_ms, "ms", cores()});
        results.push_back({fmt::format("{}_first_landscapes_ms", name), landscapes_ms, "ms", cores()});
        if (std::string_view(name) == "start.fresh") exhibit.line_with("a visit begins");
    }
}

}  // namespace quadrat::benches
