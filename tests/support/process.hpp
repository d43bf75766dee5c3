// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace quadrat::tests {

inline std::string contents_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A folder of the test's own, gone with it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "quadrat-test-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) std::abort();
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

struct Ended {
    int status = -1;  // the exit status, or -1 when a signal ended it
    int signal = 0;
    std::string out;
    std::string err;

    // The leak sanitizer's own tracer dies now and then beside threads that are ending. It looks once a program is
    // through, so how that one ended is lost, and nothing else.
    bool is_lost_to_leak_sanitizer() const {
        return err.find("LeakSanitizer has encountered a fatal error") != std::string::npos;
    }
};

// A child with its output in files, so that it never waits for a reader.
class Process {
  public:
    Process(const std::vector<std::string>& command, const std::filesystem::path& folder, const std::string& input = {})
        : folder_(folder) {
        std::ofstream(folder_ / "stdin.txt", std::ios::binary) << input;
        child_ = ::fork();
        if (child_ != 0) return;
        redirect("stdin.txt", O_RDONLY, STDIN_FILENO);
        redirect("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        redirect("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        if (::chdir(folder_.c_str()) != 0) ::_exit(126);
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        ::execvp(arguments[0], arguments.data());
        ::_exit(127);
    }
    ~Process() {
        if (child_ > 0) kill(SIGKILL), wait();
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Never all processes there are, which is what -1 means.
    void kill(int signal) const {
        if (child_ > 0) ::kill(child_, signal);
    }
    bool is_running() {
        int status = 0;
        if (child_ > 0 && ::waitpid(child_, &status, WNOHANG) == child_) note(status);
        return child_ > 0;
    }
    Ended wait() {
        int status = 0;
        while (child_ > 0 && ::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
        }
        if (child_ > 0) note(status);
        ended_.out = contents_of(folder_ / "stdout.txt");
        ended_.err = contents_of(folder_ / "stderr.txt");
        return ended_;
    }

  private:
    void redirect(const char* name, int flags, int to) const {
        constexpr int kMode = 0644;
        const int fd = ::open((folder_ / name).c_str(), flags, kMode);
        if (fd < 0 || ::dup2(fd, to) < 0) ::_exit(125);
    }
    void note(int status) {
        ended_.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        ended_.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        child_ = -1;
    }

    std::filesystem::path folder_;
    pid_t child_ = -1;
    Ended ended_;
};

inline Ended run(const std::vector<std::string>& command, const TemporaryFolder& folder,
                 const std::string& input = {}) {
    Ended ended = Process(command, folder.path(), input).wait();
    if (ended.is_lost_to_leak_sanitizer()) ended = Process(command, folder.path(), input).wait();
    return ended;
}

}  // namespace quadrat::tests
