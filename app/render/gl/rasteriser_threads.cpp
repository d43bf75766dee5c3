// SPDX-License-Identifier: Apache-2.0
#include "render/gl/rasteriser_threads.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace quadrat::render::gl {
namespace {

namespace fs = std::filesystem;

cpu_set_t only(int core) {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    CPU_SET(static_cast<std::size_t>(core), &cores);
    return cores;
}

cpu_set_t without(cpu_set_t cores, int core) {
    CPU_CLR(static_cast<std::size_t>(core), &cores);
    return cores;
}

// A thread that has ended meanwhile stays where it is.
void move(pid_t thread, const cpu_set_t& cores) { ::sched_setaffinity(thread, sizeof cores, &cores); }

}  // namespace

RasteriserThreads RasteriserThreads::of_this_process(std::string_view name_begins) {
    RasteriserThreads found;
    std::error_code none;
    for (const fs::directory_entry& task : fs::directory_iterator("/proc/self/task", none)) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        if (!name.starts_with(name_begins)) continue;
        const std::string id = task.path().filename();
        Thread thread{};
        std::from_chars(id.data(), id.data() + id.size(), thread.id);
        if (::sched_getaffinity(thread.id, sizeof thread.cores, &thread.cores) == 0) found.threads_.push_back(thread);
    }
    return found;
}

RasteriserThreads::Feeding::Feeding(const RasteriserThreads& threads) : threads_(threads) {
    if (threads.count() == 0 || ::sched_getaffinity(0, sizeof feeder_before_, &feeder_before_) != 0) return;
    const int core = ::sched_getcpu();
    if (core < 0 || core >= CPU_SETSIZE) return;
    for (const Thread& thread : threads.threads_) {
        const cpu_set_t others = without(thread.cores, core);
        if (CPU_COUNT(&others) == 0) return;
    }
    core_ = core;
    move(0, only(core));
    for (const Thread& thread : threads.threads_) move(thread.id, without(thread.cores, core));
}

RasteriserThreads::Feeding::~Feeding() {
    if (!core_) return;
    // At once: the scheduler would take it for too short a rest to move anybody there.
    const Thread& heir = threads_.threads_.front();
    if (CPU_ISSET(static_cast<std::size_t>(*core_), &heir.cores)) move(heir.id, only(*core_));
    for (const Thread& thread : threads_.threads_) move(thread.id, thread.cores);
    move(0, feeder_before_);
}

}  // namespace quadrat::render::gl
