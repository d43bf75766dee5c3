// SPDX-License-Identifier: Apache-2.0
#include "desk/incoming.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstring>

namespace quadrat::desk {

struct IncomingParts {
    static MHD_Result take(void* to, MHD_ValueKind, const char* name, const char* file, const char*, const char*,
                           const char* bytes, std::uint64_t at, std::size_t count) {
        static_cast<Incoming*>(to)->take_part(name == nullptr ? "" : name, file != nullptr, at, bytes, count);
        return MHD_YES;
    }
};

namespace {

constexpr std::size_t kMostForm = 4096;
constexpr std::size_t kMostLongForm = 128 * 1024;  // each of the screen's texts, each letter of it escaped
constexpr std::size_t kPartsBuffer = 32 * 1024;

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

}  // namespace

void Incoming::End::operator()(MHD_PostProcessor* processor) const { MHD_destroy_post_processor(processor); }

Incoming::Incoming(Inbox& inbox, MHD_Connection* connection, const char* method, const char* path)
    : inbox_(inbox), most_form_(kMostForm) {
    request_.method = method;
    request_.path = path;
    request_.peer = peer_of(connection);
    MHD_get_connection_values(connection, MHD_HEADER_KIND, keep_header, &request_.headers);
    if (request_.method != "POST")
        MHD_get_connection_values(connection, MHD_GET_ARGUMENT_KIND, keep_argument, &request_.form);
    const auto type = request_.headers.find("content-type");
    if (request_.method == "POST" && inbox_.answerer.takes_long_form(request_)) most_form_ = kMostLongForm;
    if (type == request_.headers.end() || !type->second.starts_with("multipart/form-data")) return;
    if (!inbox_.answerer.takes_file(request_)) return;
    parts_.reset(MHD_create_post_processor(connection, kPartsBuffer, &IncomingParts::take, this));
}

Incoming::~Incoming() {
    parts_.reset();
    if (!file_) return;
    std::error_code ignored;
    std::filesystem::remove(inbox_.file, ignored);
    inbox_.is_in_use = false;
}

void Incoming::take(const char* bytes, std::size_t count) {
    if (parts_) {
        if (MHD_post_process(parts_.get(), bytes, count) != MHD_YES) refuse(400, "The form is not well-formed.");
        return;
    }
    if (form_.size() + count > most_form_) return refuse(413, "The form is too long.");
    form_.append(bytes, count);
}

void Incoming::open_inbox() {
    if (inbox_.is_in_use) {
        refuse(503, "Another file is on its way: try again.");
        return;
    }
    file_.reset(::open(inbox_.file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!file_) {
        refuse(503, fmt::format("The file cannot be kept here: {}.", std::strerror(errno)));
        return;
    }
    inbox_.is_in_use = true;
    request_.brought = inbox_.file;
}

void Incoming::take_part(const std::string& name, bool is_file, std::size_t at, const char* bytes, std::size_t count) {
    if (!is_file) {
        if (form_.size() + name.size() + count > kMostForm) return refuse(413, "The form is too long.");
        std::string& value = request_.form[name];
        if (at != value.size()) return;  // of a name that comes twice the first counts
        value.append(bytes, count);
        form_.append(name).append(bytes, count);  // as a measure of how much has come
        return;
    }
    if (request_.refusal != 0 || name != "file" || count == 0) return;
    if (!file_) open_inbox();
    if (!file_) return;
    file_bytes_ += count;
    if (file_bytes_ > inbox_.most)
        refuse(413, fmt::format("The file has more than {} MB.", inbox_.most >> 20U));
    else if (::write(file_.get(), bytes, count) != static_cast<ssize_t>(count))
        refuse(503, "There is no room for the file.");
}

void Incoming::refuse(int status, std::string why) {
    if (request_.refusal != 0) return;
    request_.refusal = status;
    request_.trouble = std::move(why);
}

Answer Incoming::answer() {
    if (parts_) {
        // Its last words may say that a part was cut off.
        if (MHD_destroy_post_processor(parts_.release()) != MHD_YES) refuse(400, "The form is not well-formed.");
    } else if (request_.method == "POST") {
        auto form = fields_of(form_);
        if (!form) refuse(400, "The form is not well-formed.");
        request_.form = std::move(form).value_or(Fields{});
    }
    return inbox_.answerer.respond(request_);
}

}  // namespace quadrat::desk
