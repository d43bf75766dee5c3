// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace quadrat::machine {

// One figure of `quadrat bench`.
struct Measurement {
    std::string name;  // "frame.median_ms"
    double value = 0;
    std::string unit;
    int threads = 1;
    std::string others = {};  // what the source papers and peers need for the same; may be empty
};

// The share-th smallest, by the nearest rank; 0 for none.
double percentile(std::vector<double> samples, double share);

double peak_memory_mb();      // of this process so far, resident
double resident_memory_mb();  // of this process now; 0 where the system does not tell
double cpu_seconds();         // of this process so far, all threads

std::string machine_description();  // processor, cores, memory

std::string table_of(const std::vector<Measurement>& results);
std::string json_of(const std::vector<Measurement>& results, const std::string& gpu);

}  // namespace quadrat::machine
