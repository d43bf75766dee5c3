// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <linux/input.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

// A machine's /dev and /sys for libevdev and hidapi themselves: nodes that they open, and the answers that a kernel
// gives to what they ask of them (open and ioctl are ours in this program). Only what those libraries use of it.
namespace quadrat::tests {

class StandInFolder {
  public:
    StandInFolder();
    ~StandInFolder();
    StandInFolder(const StandInFolder&) = delete;
    StandInFolder& operator=(const StandInFolder&) = delete;
    std::filesystem::path sys() const { return root_ / "sys"; }
    std::filesystem::path dev() const { return root_ / "dev"; }

  private:
    std::filesystem::path root_;
};

// One event device. Plugged in again it has another number.
class StandInEvdev {
  public:
    StandInEvdev(const StandInFolder& folder, std::set<unsigned> keys, std::map<unsigned, input_absinfo> axes = {});
    ~StandInEvdev() { unplug(); }
    void plug();
    void unplug();

    void key(unsigned code, bool is_down, std::int64_t at_us);
    void axis(unsigned code, std::int32_t value, std::int64_t at_us);
    // The buffer has overflowed: what was sent since the last read is lost.
    void overflow(std::int64_t at_us);

    bool is_open() const { return is_open_; }
    bool is_grabbed() const { return is_grabbed_; }
    bool is_grabbed_by_another = false;
    std::string path() const { return node_.string(); }

    int answer(unsigned long request, void* argument);  // as ioctl does

  private:
    int answer_bits(unsigned type, unsigned size, void* argument) const;
    void send(std::uint16_t type, unsigned code, std::int32_t value, std::int64_t at_us);

    const StandInFolder& folder_;
    std::set<unsigned> keys_, held_;
    std::map<unsigned, input_absinfo> axes_;
    std::filesystem::path node_;
    int number_ = 0;
    int pipe_ = -1;
    bool is_open_ = false, is_grabbed_ = false;
};

// One hidraw device, as above.
class StandInHidraw {
  public:
    StandInHidraw(const StandInFolder& folder, std::vector<std::uint8_t> descriptor);
    ~StandInHidraw() { unplug(); }
    void plug();
    void unplug();
    void send(const std::vector<std::uint8_t>& report);

    int open_node();  // as open does
    int answer(unsigned long request, void* argument) const;

  private:
    const StandInFolder& folder_;
    std::vector<std::uint8_t> descriptor_;
    std::filesystem::path node_;
    int number_ = 0;
    int ours_ = -1;
};

}  // namespace quadrat::tests
