// SPDX-License-Identifier: Apache-2.0
#include "base/log.hpp"

#include <fmt/chrono.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <deque>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace quadrat::base {
namespace {

constexpr std::size_t kWarningsKept = 20;
constexpr const char* kPattern = "%Y-%m-%dT%H:%M:%S.%e %^%l%$ %v";

class WarningSink final : public spdlog::sinks::base_sink<std::mutex> {
  public:
    RecentWarnings recent() {
        const std::scoped_lock lock(mutex_);
        return {{lines_.begin(), lines_.end()}, {warnings_.begin(), warnings_.end()}, count_};
    }

  private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        if (message.level < spdlog::level::warn) return;
        ++count_;
        lines_.push_back(fmt::format("{:%H:%M:%S} {}", fmt::localtime(spdlog::log_clock::to_time_t(message.time)),
                                     std::string_view(message.payload.data(), message.payload.size())));
        warnings_.push_back({message.time, {message.payload.data(), message.payload.size()}});
        if (lines_.size() > kWarningsKept) lines_.pop_front();
        if (warnings_.size() > kWarningsKept) warnings_.pop_front();
    }
    void flush_() override {}

    std::deque<std::string> lines_;
    std::deque<Warning> warnings_;
    std::size_t count_ = 0;
};

std::shared_ptr<WarningSink>& warning_sink() {
    static std::shared_ptr<WarningSink> sink = std::make_shared<WarningSink>();
    return sink;
}

spdlog::level::level_enum level_of(log::Level level) {
    switch (level) {
        case log::Level::Debug:
            return spdlog::level::debug;
        case log::Level::Info:
            return spdlog::level::info;
        case log::Level::Warning:
            return spdlog::level::warn;
        case log::Level::Error:
            return spdlog::level::err;
    }
    return spdlog::level::err;
}

}  // namespace

void log::write(Level level, std::string_view text) {
    spdlog::default_logger_raw()->log(level_of(level), spdlog::string_view_t(text.data(), text.size()));
}

void log::write_formatted(Level level, fmt::string_view text, fmt::format_args values) {
    if (spdlog::should_log(level_of(level))) write(level, fmt::vformat(text, values));
}

RecentWarnings recent_warnings() { return warning_sink()->recent(); }

void open_log(LogDetail detail) {
    std::vector<spdlog::sink_ptr> sinks{std::make_shared<spdlog::sinks::stderr_color_sink_mt>()};
    sinks.push_back(warning_sink());
    auto logger = std::make_shared<spdlog::logger>("quadrat", sinks.begin(), sinks.end());
    logger->set_pattern(kPattern);
    const auto level = detail == LogDetail::Quiet    ? spdlog::level::warn
                       : detail == LogDetail::Normal ? spdlog::level::info
                                                     : spdlog::level::debug;
    logger->set_level(level);
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

void log_to_file_too(const std::filesystem::path& file) {
    constexpr std::size_t kLargest = 4U << 20U;
    constexpr std::size_t kOfBefore = 3;
    try {
        auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file.string(), kLargest, kOfBefore);
        sink->set_pattern(kPattern);
        spdlog::default_logger()->sinks().push_back(std::move(sink));
    } catch (const spdlog::spdlog_ex& error) {
        throw InputError(fmt::format("{}: cannot write the log: {}", file.string(), error.what()));
    }
}

}  // namespace quadrat::base
