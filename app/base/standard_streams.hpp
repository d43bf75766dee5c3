// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::base {

// First thing in main. A standard stream that was closed is opened onto nothing, the wrong way round, so that no file
// of ours gets its number, and using it fails as it would have.
void hold_standard_streams();

// Last thing in main: whether all that was printed on standard output has arrived. Says so on standard error, in one
// line with the reason, where it has not.
bool is_standard_output_written();

}  // namespace quadrat::base
