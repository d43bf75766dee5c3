// SPDX-License-Identifier: Apache-2.0
#include "desk/server.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <vector>

#include "base/error.hpp"
#include "desk/incoming.hpp"

namespace quadrat::desk {
namespace {

MHD_Result send(MHD_Connection* connection, Answer& answer) {
    MHD_Response* response =
        MHD_create_response_from_buffer(answer.body.size(), answer.body.data(), MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) return MHD_NO;
    MHD_add_response_header(response, "Content-Type", answer.type.c_str());
    for (const auto& [name, value] : answer.headers) MHD_add_response_header(response, name.c_str(), value.c_str());
    const MHD_Result sent = MHD_queue_response(connection, static_cast<unsigned>(answer.status), response);
    MHD_destroy_response(response);
    return sent;
}

MHD_Result handle(void* inbox, MHD_Connection* connection, const char* url, const char* method, const char*,
                  const char* upload, std::size_t* upload_size, void** state) {
    if (*state == nullptr) {
        *state = new Incoming(*static_cast<Inbox*>(inbox), connection, method, url);
        return MHD_YES;
    }
    Incoming& incoming = *static_cast<Incoming*>(*state);
    if (*upload_size > 0) {
        incoming.take(upload, *upload_size);
        *upload_size = 0;
        return MHD_YES;
    }
    Answer answer = incoming.answer();
    return send(connection, answer);
}

void forget(void*, MHD_Connection*, void** state, MHD_RequestTerminationCode) {
    delete static_cast<Incoming*>(*state);
    *state = nullptr;
}

// A path with a zero byte would end there: what says one stays as it was written, and names nothing.
std::size_t unescape(void*, MHD_Connection*, char* text) {
    char* to = text;
    for (const char* from = text; *from != '\0'; ++to) {
        unsigned value = 0;
        const bool is_escape = from[0] == '%' && std::isxdigit(static_cast<unsigned char>(from[1])) != 0 &&
                               std::isxdigit(static_cast<unsigned char>(from[2])) != 0;
        if (is_escape) std::from_chars(from + 1, from + 3, value, 16);
        *to = value == 0 ? *from : static_cast<char>(value);
        from += value == 0 ? 1 : 3;
    }
    *to = '\0';
    return static_cast<std::size_t>(to - text);
}

// libmicrohttpd tells of faults by a text of its own: the exhibit's log is ours.
void say_nothing(void*, const char*, va_list) {}

sockaddr_storage bound_to(const base::ListenAddress& address) {
    sockaddr_storage storage{};
    auto* four = reinterpret_cast<sockaddr_in*>(&storage);
    auto* six = reinterpret_cast<sockaddr_in6*>(&storage);
    if (::inet_pton(AF_INET, address.host.c_str(), &four->sin_addr) == 1) {
        four->sin_family = AF_INET;
        four->sin_port = htons(static_cast<std::uint16_t>(address.port));
    } else if (::inet_pton(AF_INET6, address.host.c_str(), &six->sin6_addr) == 1) {
        six->sin6_family = AF_INET6;
        six->sin6_port = htons(static_cast<std::uint16_t>(address.port));
    }
    return storage;
}

}  // namespace

void Server::Stop::operator()(MHD_Daemon* daemon) const { MHD_stop_daemon(daemon); }

Server::Server(const ServerOptions& options, Answerer answerer)
    : inbox_(std::make_unique<Inbox>(Inbox{std::move(answerer), options.brought, options.most_brought})) {
    const sockaddr_storage address = bound_to(options.address);
    unsigned flags = MHD_USE_AUTO_INTERNAL_THREAD | MHD_USE_ERROR_LOG;
    if (address.ss_family == AF_INET6) flags |= MHD_USE_IPv6;
    std::vector<MHD_OptionItem> more{
        {MHD_OPTION_EXTERNAL_LOGGER, reinterpret_cast<std::intptr_t>(&say_nothing), nullptr},
        {MHD_OPTION_UNESCAPE_CALLBACK, reinterpret_cast<std::intptr_t>(&unescape), nullptr},
        {MHD_OPTION_SOCK_ADDR, 0, const_cast<sockaddr_storage*>(&address)},
        {MHD_OPTION_CONNECTION_LIMIT, 256, nullptr},
        {MHD_OPTION_PER_IP_CONNECTION_LIMIT, 16, nullptr},
        {MHD_OPTION_CONNECTION_TIMEOUT, 6, nullptr},
        {MHD_OPTION_CONNECTION_MEMORY_LIMIT, 32 * 1024, nullptr},
        {MHD_OPTION_NOTIFY_COMPLETED, reinterpret_cast<std::intptr_t>(&forget), nullptr},
    };
    if (!options.certificate.empty()) {
        flags |= MHD_USE_TLS;
        more.push_back({MHD_OPTION_HTTPS_MEM_CERT, 0, const_cast<char*>(options.certificate.c_str())});
        more.push_back({MHD_OPTION_HTTPS_MEM_KEY, 0, const_cast<char*>(options.key.c_str())});
    }
    more.push_back({MHD_OPTION_END, 0, nullptr});
    errno = 0;
    daemon_.reset(MHD_start_daemon(flags, static_cast<std::uint16_t>(options.address.port), nullptr, nullptr, &handle,
                                   inbox_.get(), MHD_OPTION_ARRAY, more.data(), MHD_OPTION_END));
    if (daemon_) return;
    const std::string why = errno == 0 ? "the certificate and its key are no pair" : std::strerror(errno);
    throw base::InputError(fmt::format("the desk cannot listen on {}: {}", base::to_text(options.address), why));
}

Server::~Server() = default;

}  // namespace quadrat::desk
