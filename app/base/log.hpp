// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <spdlog/spdlog.h>

#include <filesystem>

namespace quadrat::base {

// The program's log goes to stderr (the journal, when it runs as a service), one line an event:
//     base::log::info("round {} shown after {} ms", round, ms);
namespace log = spdlog;

enum class LogDetail { Quiet, Normal, Verbose };

// Once, at start. With a file, every line is written there too.
void open_log(LogDetail detail, const std::filesystem::path& file = {});

}  // namespace quadrat::base
