// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::commands {

// The whole program: picks the subcommand and runs it. 0: success; 2: bad usage, bad input or hardware missing at
// start, with one line on stderr; 1: what was printed could not be written, or what nobody foresaw.
int run_command_line(int argc, const char* const* argv);

}  // namespace quadrat::commands
