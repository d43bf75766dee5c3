// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "support/free_port.hpp"

// The page for staff over real connections, beside an exhibit or without one.
namespace quadrat::tests {

class StaffsPage : public testing::Test {
  protected:
    void SetUp() override {
        ::unsetenv("RUNTIME_DIRECTORY");
        folder.write("quadrat.toml", "[picture]\nland_samples = 65\n[desk]\nlisten = \"127.0.0.1:" +
                                         std::to_string(port) + "\"\n[fleet]\nname = \"Foyer\"\n");
        folder.write("visit.script", "wait 600s\n");
        std::filesystem::create_directory(folder / "state");
    }

    std::string at(const std::string& name) const { return (folder / name).string(); }
    Ended tool(const std::vector<std::string>& arguments) const { return run(program(arguments), elsewhere); }
    void set_passphrase() const {
        const std::string command =
            "echo 'a sentence of staff' | '" QUADRAT_BINARY "' desk --set-passphrase --state '" + at("state") + "'";
        ASSERT_EQ(std::system(command.c_str()), 0);
    }
    std::vector<std::string> desk() const {
        return program({"desk", "--config", at("quadrat.toml"), "--state", at("state")});
    }

    std::vector<std::string> exhibit_alone() const {
        return program({"run", "--config", at("quadrat.toml"), "--display", "headless", "--size", "64x64", "--input",
                        "script:" + at("visit.script"), "--state", at("state"), "--seed", "5", "--speed", "1.001"});
    }

    // What comes back for these bytes, until the other side is through.
    std::string say(const std::string& bytes) const {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        const timeval patience{10, 0};
        ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        const sockaddr_in address = loopback(port);
        std::string answer;
        if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
            ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            char some[4096];
            for (ssize_t got = 0; (got = ::recv(socket, some, sizeof some, 0)) > 0;)
                answer.append(some, static_cast<std::size_t>(got));
        }
        ::close(socket);
        return answer;
    }
    std::string ask(const std::string& method, const std::string& path, const std::string& form = "") const {
        return say(method + " " + path + " HTTP/1.1\r\nHost: exhibit\r\nConnection: close\r\nCookie: " + cookie +
                   "\r\nContent-Type: application/x-www-form-urlencoded\r\nContent-Length: " +
                   std::to_string(form.size()) + "\r\n\r\n" + form);
    }
    void log_in() {
        const std::string answer = ask("POST", "/login", "passphrase=a+sentence+of+staff");
        ASSERT_THAT(answer, testing::StartsWith("HTTP/1.1 303")) << answer;
        const std::size_t from = answer.find("quadrat-desk=");
        ASSERT_NE(from, std::string::npos) << answer;
        cookie = answer.substr(from, answer.find(';', from) - from);
    }
    std::string token() const {
        const std::string page = ask("GET", "/");
        return page.substr(page.find("name=\"token\" value=\"") + 20, 64);
    }
    std::string act(const std::string& what) const { return ask("POST", "/act", "act=" + what + "&token=" + token()); }
    // A file as a browser sends it.
    std::string bring(const std::string& bytes) const {
        const std::string form =
            "--limit\r\nContent-Disposition: form-data; name=\"token\"\r\n\r\n" + token() +
            "\r\n--limit\r\nContent-Disposition: form-data; name=\"file\"; filename=\"backup.tar.xz\"\r\n"
            "Content-Type: application/x-xz\r\n\r\n" +
            bytes + "\r\n--limit--\r\n";
        return say("POST /restore HTTP/1.1\r\nHost: exhibit\r\nConnection: close\r\nCookie: " + cookie +
                   "\r\nContent-Type: multipart/form-data; boundary=limit\r\nContent-Length: " +
                   std::to_string(form.size()) + "\r\n\r\n" + form);
    }
    template <typename Comes>
    void wait_until(Process& process, const char* what, const Comes& comes) const {
        const auto begun = std::chrono::steady_clock::now();
        while (!comes()) {
            ASSERT_TRUE(process.is_running()) << what;
            ASSERT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds{120}) << what << " has not come";
            std::this_thread::sleep_for(std::chrono::milliseconds{20});
        }
    }

    TemporaryFolder folder, elsewhere;
    int port = free_port();
    std::string cookie;
};

}  // namespace quadrat::tests
