// SPDX-License-Identifier: Apache-2.0
// PJLink class 1, as JBMIA's "PJLink Specifications", version 1.04, has it (2013).
#include "projector/pjlink.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <openssl/evp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "base/owned.hpp"

namespace quadrat::projector {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestLine = 256;
constexpr const char* kPasswordRemedy =
    "put the password of its PJLink menu into a file of one line, and name that: screen.power_password_file";
constexpr const char* kReachRemedy =
    "look at its network cable and address; switch on PJLink and the network in stand-by in its menu";

std::string printable(std::string_view bytes) {
    constexpr std::size_t kMost = 40;
    std::string text(bytes.substr(0, kMost));
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c >= '\x7f'; }, '?');
    return text;
}

// The specification's own proof; that it is MD5 is not ours to choose.
std::string md5_of(const std::string& text) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_md5(), nullptr) != 1)
        throw Trouble("this machine's OpenSSL refuses MD5, which PJLink's password needs",
                      "take the password out of the projector's PJLink menu");
    std::string hex;
    for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
    return hex;
}

struct FreeAddresses {
    void operator()(addrinfo* addresses) const { ::freeaddrinfo(addresses); }
};

class Connection {
  public:
    Connection(const PjLink& to, std::chrono::milliseconds patience) : to_(to), until_(Clock::now() + patience) {
        connect();
    }

    std::string line() {
        std::size_t end = 0;
        while ((end = held_.find('\r')) == std::string::npos) {
            if (held_.size() > kLongestLine) throw Trouble(says("it sends a line without an end"), kReachRemedy);
            std::array<char, kLongestLine> bytes{};
            wait(POLLIN);
            const ssize_t count = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
            if (count == 0) throw Trouble(says("it hangs up"), kReachRemedy);
            if (count < 0) fail(errno);
            held_.append(bytes.data(), static_cast<std::size_t>(count));
        }
        std::string line = held_.substr(0, end);
        held_.erase(0, end + 1);
        return line;
    }

    void send(const std::string& text) {
        for (std::size_t sent = 0; sent < text.size();) {
            wait(POLLOUT);
            const ssize_t count = ::send(socket_.get(), text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
            if (count < 0) fail(errno);
            sent += static_cast<std::size_t>(count);
        }
    }

  private:
    std::string says(const std::string& what) const { return fmt::format("{}: {}", to_text(Address(to_)), what); }
    [[noreturn]] void fail(int error) const { throw Trouble(says(std::strerror(error)), kReachRemedy); }

    // Each of its addresses in turn; what the last one says is told.
    void connect() {
        addrinfo hints{};
        hints.ai_socktype = SOCK_STREAM;
        hints.ai_flags = AI_ADDRCONFIG | AI_NUMERICSERV;
        addrinfo* found = nullptr;
        if (const int error = ::getaddrinfo(to_.host.c_str(), std::to_string(to_.port).c_str(), &hints, &found);
            error != 0)
            throw Trouble(says(fmt::format("its name is not found: {}", ::gai_strerror(error))),
                          "write its number: pjlink://192.168.0.30");
        const std::unique_ptr<addrinfo, FreeAddresses> addresses(found);
        int error = EHOSTUNREACH;
        for (const addrinfo* at = found; at != nullptr; at = at->ai_next)
            if ((error = connect_to(*at)) == 0) return;
        fail(error);
    }

    int connect_to(const addrinfo& at) {
        socket_.reset(::socket(at.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
        if (!socket_) return errno;
        if (::connect(socket_.get(), at.ai_addr, at.ai_addrlen) == 0) return 0;
        if (errno != EINPROGRESS) return errno;
        wait(POLLOUT);
        int error = 0;
        socklen_t size = sizeof error;
        return ::getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
    }

    void wait(short events) const {
        for (;;) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(until_ - Clock::now()).count();
            pollfd one{socket_.get(), events, 0};
            const int ready = left > 0 ? ::poll(&one, 1, static_cast<int>(left)) : 0;
            if (ready > 0) return;
            if (ready == 0) throw Trouble(says("it does not answer"), kReachRemedy);
            if (errno != EINTR) fail(errno);
        }
    }

    PjLink to_;
    Clock::time_point until_;
    base::OwnedDescriptor socket_;
    std::string held_;
};

// One connection a command: a projector ends one that is idle, and some take one at a time.
class OverTheNetwork : public Projector {
  public:
    OverTheNetwork(PjLink to, std::string password, std::chrono::milliseconds patience)
        : to_(std::move(to)), password_(std::move(password)), patience_(patience) {}

    Power power() override {
        const auto answer = ask("POWR", "?");
        return answer ? power_from(*answer) : Power::Unknown;
    }
    void turn_on() override { ask("POWR", "1"); }
    void turn_off() override { ask("POWR", "0"); }
    std::string ailments() override { return ailments_from(ask("ERST", "?").value_or("")); }

  private:
    std::optional<std::string> ask(const std::string& command, const std::string& what) const {
        Connection connection(to_, patience_);
        const std::string challenge = challenge_of(connection.line());
        if (!challenge.empty() && password_.empty()) throw Trouble("the projector wants a password", kPasswordRemedy);
        connection.send(command_text(challenge, password_, fmt::format("%1{} {}", command, what)));
        return answer_from(connection.line(), command);
    }

    PjLink to_;
    std::string password_;
    std::chrono::milliseconds patience_;
};

}  // namespace

std::string challenge_of(std::string_view greeting) {
    if (greeting == "PJLINK 0") return "";
    constexpr std::string_view kSecure = "PJLINK 1 ";
    const std::string_view number = greeting.substr(std::min(kSecure.size(), greeting.size()));
    const bool is_number = number.size() == 8 && number.find_first_not_of("0123456789abcdefABCDEF") == number.npos;
    if (greeting.starts_with(kSecure) && is_number) return std::string(number);
    if (greeting == "PJLINK ERRA") throw Trouble("the projector refuses our password", kPasswordRemedy);
    throw Trouble(fmt::format("what answers there speaks no PJLink; it says \"{}\"", printable(greeting)),
                  "look at the projector's address, and at PJLink in its menu");
}

std::string command_text(const std::string& challenge, const std::string& password, std::string_view command) {
    return fmt::format("{}{}\r", challenge.empty() ? "" : md5_of(challenge + password), command);
}

std::optional<std::string> answer_from(std::string_view line, std::string_view command) {
    if (line == "PJLINK ERRA") throw Trouble("the projector refuses our password", kPasswordRemedy);
    const std::string head = fmt::format("%1{}=", command);
    // Letters of either size are meant, and small ones seen.
    const bool is_ours =
        line.size() >= head.size() && std::ranges::equal(line.substr(0, head.size()), head, [](char a, char b) {
            return (a >= 'a' && a <= 'z' ? static_cast<char>(a - 'a' + 'A') : a) == b;
        });
    if (!is_ours)
        throw Trouble(fmt::format("the projector answers \"{}\"", printable(line)),
                      "its PJLink is another than class 1: ask its maker, or switch it by CEC");
    const std::string_view answer = line.substr(head.size());
    if (answer == "ERR3") return std::nullopt;
    if (answer == "ERR4") throw Trouble("the projector reports a fault of its own", "look at its lamps and its menu");
    if (answer.starts_with("ERR"))
        throw Trouble(fmt::format("the projector does not know {}", command),
                      "its PJLink is another than class 1: ask its maker, or switch it by CEC");
    return std::string(answer);
}

Power power_from(std::string_view answer) {
    constexpr std::array kPowers{Power::Off, Power::On, Power::Cooling, Power::Warming};
    if (answer.size() == 1 && answer[0] >= '0' && answer[0] <= '3')
        return kPowers[static_cast<std::size_t>(answer[0] - '0')];
    throw Trouble(fmt::format("the projector says of its power \"{}\"", printable(answer)),
                  "its PJLink is another than class 1: ask its maker, or switch it by CEC");
}

std::string ailments_from(std::string_view answer) {
    constexpr std::array<const char*, 6> kParts{"fan", "lamp", "temperature", "cover", "filter", "other"};
    std::string all;
    if (answer.size() != kParts.size()) return all;
    for (std::size_t i = 0; i < kParts.size(); ++i) {
        if (answer[i] != '1' && answer[i] != '2') continue;
        all += fmt::format("{}{}: {}", all.empty() ? "" : ", ", kParts[i], answer[i] == '1' ? "warning" : "error");
    }
    return all;
}

std::unique_ptr<Projector> open_pjlink(const PjLink& to, const std::string& password,
                                       std::chrono::milliseconds patience) {
    return std::make_unique<OverTheNetwork>(to, password, patience);
}

}  // namespace quadrat::projector
