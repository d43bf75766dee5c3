// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "base/owned.hpp"
#include "desk/server.hpp"

struct MHD_Connection;
struct MHD_PostProcessor;

namespace quadrat::desk {

// Where files are brought to, one at a time.
struct Inbox {
    Answerer answerer;
    std::filesystem::path file;
    std::size_t most = 0;  // bytes
    bool is_in_use = false;
};

// A request while its parts come, within bounds: what is too much is dropped and said.
class Incoming {
  public:
    // `inbox` outlives it.
    Incoming(Inbox& inbox, MHD_Connection* connection, const char* method, const char* path);
    // The file that it brought is gone with it.
    ~Incoming();
    Incoming(const Incoming&) = delete;
    Incoming& operator=(const Incoming&) = delete;

    void take(const char* bytes, std::size_t count);
    // Once all of it has come.
    Answer answer();

  private:
    struct End {
        void operator()(MHD_PostProcessor* processor) const;
    };
    friend struct IncomingParts;  // hears of the parts of a form with a file
    void take_part(const std::string& name, bool is_file, std::size_t at, const char* bytes, std::size_t count);
    void open_inbox();
    void refuse(int status, std::string why);

    Inbox& inbox_;
    Request request_;
    std::string form_;
    std::unique_ptr<MHD_PostProcessor, End> parts_;
    base::OwnedDescriptor file_;
    std::size_t file_bytes_ = 0;
    std::size_t most_form_;  // bytes
};

}  // namespace quadrat::desk
