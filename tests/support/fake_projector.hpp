// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <openssl/evp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace quadrat::tests {

// A projector on this machine's own network, as PJLink's specification has one of class 1: one connection at a time, a
// greeting, one command, one answer.
class FakeProjector {
  public:
    enum class Manner { Usual, Silent, Rude, HangsUp, Busy, Failing };

    explicit FakeProjector(std::string password = "") : password_(std::move(password)) {
        sockaddr_in at{};
        at.sin_family = AF_INET;
        at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof at;
        listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (::bind(listener_, reinterpret_cast<sockaddr*>(&at), size) != 0 || ::listen(listener_, 4) != 0) std::abort();
        ::getsockname(listener_, reinterpret_cast<sockaddr*>(&at), &size);
        port_ = ntohs(at.sin_port);
        thread_ = std::thread([this] { serve(); });
    }
    ~FakeProjector() {
        is_ending_ = true;
        thread_.join();
        ::close(listener_);
    }
    FakeProjector(const FakeProjector&) = delete;
    FakeProjector& operator=(const FakeProjector&) = delete;

    int port() const { return port_; }
    std::string address() const { return "pjlink://127.0.0.1:" + std::to_string(port_); }
    // '0' off, '1' on, '2' cooling, '3' warming.
    char power() const { return power_; }
    void set_power(char power) { power_ = power; }
    void set_ailments(const std::string& digits) {
        const std::scoped_lock lock(mutex_);
        ailments_ = digits;
    }
    void behave(Manner manner) { manner_ = manner; }
    // Whether it takes its time: it warms up or cools down until set_power().
    void take_time(bool takes_time) { takes_time_ = takes_time; }
    int visits() const { return visits_; }  // connections
    std::vector<std::string> heard() const {
        const std::scoped_lock lock(mutex_);
        return heard_;
    }

  private:
    static std::string md5_of(const std::string& text) {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
        unsigned int size = 0;
        EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_md5(), nullptr);
        std::string hex;
        std::array<char, 3> two{};
        for (unsigned int i = 0; i < size; ++i)
            hex += (std::snprintf(two.data(), two.size(), "%02x", digest[i]), two.data());
        return hex;
    }
    static bool is_ready(int socket) {
        pollfd one{socket, POLLIN, 0};
        return ::poll(&one, 1, 20) > 0;
    }
    static void say(int socket, const std::string& text) {
        (void)!::send(socket, text.data(), text.size(), MSG_NOSIGNAL);
    }

    void serve() {
        while (!is_ending_) {
            if (!is_ready(listener_)) continue;
            const int guest = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
            converse(guest);
            ::close(guest);
        }
    }
    void converse(int guest) {
        ++visits_;
        if (manner_ == Manner::HangsUp) return;
        if (manner_ == Manner::Rude) return say(guest, "SSH-2.0-OpenSSH_9.2\r\n");
        if (manner_ != Manner::Silent) say(guest, password_.empty() ? "PJLINK 0\r" : "PJLINK 1 498e4a67\r");
        std::string line;
        while (!is_ending_ && line.find('\r') == std::string::npos) {
            if (!is_ready(guest)) continue;
            std::array<char, 256> bytes{};
            const ssize_t count = ::recv(guest, bytes.data(), bytes.size(), 0);
            if (count <= 0) return;
            line.append(bytes.data(), static_cast<std::size_t>(count));
        }
        if (manner_ != Manner::Silent) say(guest, answer_to(line) + "\r");
    }
    std::string answer_to(const std::string& line) {
        const std::string proof = password_.empty() ? "" : md5_of("498e4a67" + password_);
        if (!line.starts_with(proof + "%1")) return "PJLINK ERRA";
        const std::string command = line.substr(proof.size(), line.find('\r') - proof.size());
        const std::scoped_lock lock(mutex_);
        heard_.push_back(command);
        if (command == "%1ERST ?") return "%1ERST=" + ailments_;
        if (!command.starts_with("%1POWR ")) return command.substr(0, 6) + "=ERR1";
        if (manner_ == Manner::Busy) return "%1POWR=ERR3";
        if (manner_ == Manner::Failing) return "%1POWR=ERR4";
        const char what = command[7];
        if (what == '?') return std::string("%1POWR=") + power_.load();
        if (what != '0' && what != '1') return "%1POWR=ERR2";
        if (what != power_) power_ = takes_time_ ? (what == '1' ? '3' : '2') : what;
        return "%1POWR=OK";
    }

    std::string password_;
    int listener_ = -1;
    int port_ = 0;
    std::atomic<char> power_{'0'};
    std::atomic<Manner> manner_{Manner::Usual};
    std::atomic<int> visits_{0};
    std::atomic<bool> is_ending_{false}, takes_time_{false};
    mutable std::mutex mutex_;
    std::string ailments_ = "000000";
    std::vector<std::string> heard_;
    std::thread thread_;
};

}  // namespace quadrat::tests
