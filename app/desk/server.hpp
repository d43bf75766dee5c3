// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "base/listen_address.hpp"
#include "desk/http.hpp"

struct MHD_Daemon;

namespace quadrat::desk {

struct Inbox;

struct ServerOptions {
    base::ListenAddress address;
    std::string certificate, key;   // PEM; both "" for none: nothing is encrypted
    std::filesystem::path brought;  // where a file lies that comes with a form; there is one at a time
    std::size_t most_brought = 0;   // bytes of it
};

// What the server asks. All are called on its thread and must not throw.
struct Answerer {
    std::function<Answer(const Request&)> respond;
    // Whether what is known before the form itself comes lets it bring a file.
    std::function<bool(const Request&)> takes_file;
    std::function<bool(const Request&)> takes_long_form;  // likewise
};

// An HTTP server (libmicrohttpd) on one thread of its own: requests are answered one after the other. What a request
// may cost is bounded: 16 connections an address and 64 in all, 6 s without a byte, 4 kB of a form (128 kB of one that
// may be long), 32 kB of headers, and one file of `most_brought` bytes from whoever may bring one.
class Server {
  public:
    // Throws InputError: the address is taken or not this machine's, or the certificate and its key are no pair.
    Server(const ServerOptions& options, Answerer answerer);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

  private:
    struct Stop {
        void operator()(MHD_Daemon* daemon) const;
    };
    std::unique_ptr<Inbox> inbox_;
    std::unique_ptr<MHD_Daemon, Stop> daemon_;
};

}  // namespace quadrat::desk
