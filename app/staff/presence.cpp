// SPDX-License-Identifier: Apache-2.0
#include "staff/presence.hpp"

#include <fcntl.h>
#include <sys/file.h>

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;

fs::path file_in(const fs::path& runtime) { return runtime / "running"; }

}  // namespace

Presence::Presence(const fs::path& runtime) {
    std::error_code ignored;
    fs::create_directories(runtime, ignored);
    constexpr int kMode = 0644;
    file_.reset(::open(file_in(runtime).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode));
    if (file_) ::flock(file_.get(), LOCK_EX | LOCK_NB);
}

bool is_exhibit_present(const fs::path& runtime) {
    const base::OwnedDescriptor file(::open(file_in(runtime).c_str(), O_RDONLY | O_CLOEXEC));
    return file && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0;
}

}  // namespace quadrat::staff
