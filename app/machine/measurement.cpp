// SPDX-License-Identifier: Apache-2.0
#include "machine/measurement.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace quadrat::machine {
namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if ((line.starts_with("model name") || line.starts_with("Model")) && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown processor";
}

double memory_gb() {
    struct sysinfo info {};
    return ::sysinfo(&info) == 0 ? static_cast<double>(info.totalram) * info.mem_unit / 1e9 : 0;
}

}  // namespace

double percentile(std::vector<double> samples, double share) {
    if (samples.empty()) return 0;
    std::ranges::sort(samples);
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(samples.size())));
    return samples[std::clamp<std::size_t>(rank, 1, samples.size()) - 1];
}

double peak_memory_mb() {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double resident_memory_mb() {
    std::ifstream statm("/proc/self/statm");
    double all_pages = 0;
    double resident_pages = 0;
    if (!(statm >> all_pages >> resident_pages)) return 0;
    return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

double cpu_seconds() {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string machine_description() {
    return fmt::format("{}, {} cores, {:.1f} GB", processor(), std::thread::hardware_concurrency(), memory_gb());
}

std::string table_of(const std::vector<Measurement>& results) {
    std::string out;
    for (const Measurement& m : results)
        out += fmt::format("{:<32} {:>12.2f} {:<10} {} thread{}{}{}\n", m.name, m.value, m.unit, m.threads,
                           m.threads == 1 ? "" : "s", m.others.empty() ? "" : "   others: ", m.others);
    return out;
}

std::string json_of(const std::vector<Measurement>& results, const std::string& gpu) {
    nlohmann::ordered_json json;
    json["machine"] = {{"processor", processor()},
                       {"cores", std::thread::hardware_concurrency()},
                       {"memory_gb", memory_gb()},
                       {"gpu", gpu}};
    json["results"] = nlohmann::ordered_json::array();
    for (const Measurement& m : results) {
        json["results"].push_back({{"name", m.name}, {"value", m.value}, {"unit", m.unit}, {"threads", m.threads}});
        if (!m.others.empty()) json["results"].back()["others"] = m.others;
    }
    return json.dump();
}

}  // namespace quadrat::machine
