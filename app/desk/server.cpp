// SPDX-License-Identifier: Apache-2.0
#include "desk/server.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <vector>

#include "base/error.hpp"

namespace quadrat::desk {
namespace {

constexpr std::size_t kMostForm = 4096;

// What has come of a request so far.
struct Pending {
    std::string form;
    bool is_too_long = false;
};

MHD_Result keep_header(void* to, MHD_ValueKind, const char* name, const char* value) {
    std::string small;
    for (const char* c = name; *c != '\0'; ++c)
        small += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
    static_cast<Fields*>(to)->emplace(std::move(small), value == nullptr ? "" : value);
    return MHD_YES;
}

MHD_Result keep_argument(void* to, MHD_ValueKind, const char* name, const char* value) {
    static_cast<Fields*>(to)->emplace(name, value == nullptr ? "" : value);
    return MHD_YES;
}

std::string peer_of(MHD_Connection* connection) {
    const MHD_ConnectionInfo* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
    if (info == nullptr || info->client_addr == nullptr) return "?";
    char text[INET6_ADDRSTRLEN] = "?";
    if (info->client_addr->sa_family == AF_INET)
        ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(info->client_addr)->sin_addr, text, sizeof text);
    if (info->client_addr->sa_family == AF_INET6)
        ::inet_ntop(AF_INET6, &reinterpret_cast<const sockaddr_in6*>(info->client_addr)->sin6_addr, text, sizeof text);
    return text;
}

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

Answer answer_of(const std::function<Answer(const Request&)>& respond, MHD_Connection* connection, const char* url,
                 const char* method, const Pending& pending) {
    const auto plain = [](int status, const char* text) {
        return Answer{status, "text/plain; charset=utf-8", text, {}};
    };
    if (pending.is_too_long) return plain(413, "The form is too long.\n");
    Request request;
    request.method = method;
    request.path = url;
    request.peer = peer_of(connection);
    MHD_get_connection_values(connection, MHD_HEADER_KIND, keep_header, &request.headers);
    auto form = fields_of(pending.form);
    if (!form) return plain(400, "The form is not well-formed.\n");
    request.form = std::move(*form);
    if (request.method != "POST")
        MHD_get_connection_values(connection, MHD_GET_ARGUMENT_KIND, keep_argument, &request.form);
    return respond(request);
}

MHD_Result handle(void* respond, MHD_Connection* connection, const char* url, const char* method, const char*,
                  const char* upload, std::size_t* upload_size, void** state) {
    if (*state == nullptr) {
        *state = new Pending;
        return MHD_YES;
    }
    Pending& pending = *static_cast<Pending*>(*state);
    if (*upload_size > 0) {
        pending.is_too_long = pending.is_too_long || pending.form.size() + *upload_size > kMostForm;
        if (!pending.is_too_long) pending.form.append(upload, *upload_size);
        *upload_size = 0;
        return MHD_YES;
    }
    Answer answer =
        answer_of(*static_cast<std::function<Answer(const Request&)>*>(respond), connection, url, method, pending);
    return send(connection, answer);
}

void forget(void*, MHD_Connection*, void** state, MHD_RequestTerminationCode) {
    delete static_cast<Pending*>(*state);
    *state = nullptr;
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

Server::Server(const ServerOptions& options, std::function<Answer(const Request&)> respond)
    : respond_(std::move(respond)) {
    const sockaddr_storage address = bound_to(options.address);
    unsigned flags = MHD_USE_AUTO_INTERNAL_THREAD | MHD_USE_ERROR_LOG;
    if (address.ss_family == AF_INET6) flags |= MHD_USE_IPv6;
    std::vector<MHD_OptionItem> more{
        {MHD_OPTION_EXTERNAL_LOGGER, reinterpret_cast<std::intptr_t>(&say_nothing), nullptr},
        {MHD_OPTION_SOCK_ADDR, 0, const_cast<sockaddr_storage*>(&address)},
        {MHD_OPTION_CONNECTION_LIMIT, 64, nullptr},
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
                                   &respond_, MHD_OPTION_ARRAY, more.data(), MHD_OPTION_END));
    if (daemon_) return;
    const std::string why = errno == 0 ? "the certificate and its key are no pair" : std::strerror(errno);
    throw base::InputError(fmt::format("the desk cannot listen on {}: {}", base::to_text(options.address), why));
}

Server::~Server() = default;

}  // namespace quadrat::desk
