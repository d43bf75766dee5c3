// SPDX-License-Identifier: Apache-2.0
#include "base/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

namespace quadrat::base {

void hold_standard_streams() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(fd, F_GETFD) == -1 && errno == EBADF)
            (void)::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // takes the lowest number: this one
}

bool is_standard_output_written() {
    std::cout.flush();
    errno = 0;
    const bool is_flushed = std::fflush(stdout) == 0;
    const int reason = errno;
    if (is_flushed && std::ferror(stdout) == 0 && std::cout) return true;
    std::fprintf(stderr, "quadrat: standard output: cannot be written: %s\n",
                 reason != 0 ? std::strerror(reason) : "the file or pipe behind it took no more");
    return false;
}

}  // namespace quadrat::base
