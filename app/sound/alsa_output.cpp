// SPDX-License-Identifier: Apache-2.0
#include <alsa/asoundlib.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <vector>

#include "sound/output.hpp"

namespace quadrat::sound {
namespace {

constexpr unsigned kLatency_us = 60'000;  // a press is heard within a tenth of a second, with what lies before it
constexpr int kStuck_ms = 500;

// What ALSA says to the terminal about a card that is not there, we say ourselves.
void say_nothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/, const char* /*format*/,
                 ...) {}

std::string cannot_be_opened(const std::string& device, int error) {
    return fmt::format("the sound card {} cannot be opened: {}", device, snd_strerror(error));
}

struct Close {
    void operator()(snd_pcm_t* pcm) const { snd_pcm_close(pcm); }
};
using Pcm = std::unique_ptr<snd_pcm_t, Close>;

class AlsaOutput final : public Output {
  public:
    AlsaOutput(Pcm pcm, std::string device) : pcm_(std::move(pcm)), device_(std::move(device)) {
        snd_pcm_uframes_t period = 0;
        snd_pcm_get_params(pcm_.get(), &room_, &period);
    }

    Outcome play(Block block) override {
        samples_.clear();
        for (const Frame& frame : block) {
            samples_.push_back(whole(frame.left));
            samples_.push_back(whole(frame.right));
        }
        bool is_late = false;
        std::size_t done = 0;
        while (done < block.size()) {
            const snd_pcm_sframes_t taken = snd_pcm_writei(pcm_.get(), samples_.data() + 2 * done, block.size() - done);
            if (taken > 0) {
                done += static_cast<std::size_t>(taken);
                continue;
            }
            if (taken == -EPIPE) is_late = true;
            if (!can_go_on(static_cast<int>(taken))) return Outcome::Gone;
        }
        keep_time(block.size());
        return is_late ? Outcome::Late : Outcome::Played;
    }

    std::string trouble() const override { return trouble_; }

  private:
    static std::int16_t whole(float value) {
        return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32'767.0F));
    }

    // A device that swallows all at once, as ALSA's null and file do, has room for everything straight after a block.
    void keep_time(std::size_t frames) {
        const snd_pcm_sframes_t free = snd_pcm_avail(pcm_.get());
        if (free >= 0 && static_cast<snd_pcm_uframes_t>(free) >= room_)
            ::poll(nullptr, 0, static_cast<int>(frames * 1'000 / kRate));
    }

    bool can_go_on(int error) {
        if (error == 0 || error == -EAGAIN) {
            const int ready = snd_pcm_wait(pcm_.get(), kStuck_ms);
            if (ready > 0) return true;
            if (ready == 0) return gone("it has taken no sound for half a second");
            error = ready;
        }
        if (snd_pcm_recover(pcm_.get(), error, 1) == 0) return true;
        return gone(snd_strerror(error));
    }

    bool gone(const std::string& why) {
        trouble_ = fmt::format("the sound card {} is gone: {}", device_, why);
        return false;
    }

    Pcm pcm_;
    std::string device_;
    snd_pcm_uframes_t room_ = 0;  // frames that it holds
    std::string trouble_;
    std::vector<std::int16_t> samples_;
};

}  // namespace

std::unique_ptr<Output> open_alsa(const std::string& device, std::string& trouble) {
    snd_lib_error_set_handler(say_nothing);
    snd_pcm_t* opened = nullptr;
    int error = snd_pcm_open(&opened, device.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
    Pcm pcm(error < 0 ? nullptr : opened);
    if (error == 0)
        error =
            snd_pcm_set_params(pcm.get(), SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 2, kRate, 1, kLatency_us);
    if (error == 0) return std::make_unique<AlsaOutput>(std::move(pcm), device);
    trouble = cannot_be_opened(device, error);
    return nullptr;
}

std::string trouble_with_alsa(const std::string& device) {
    snd_lib_error_set_handler(say_nothing);
    snd_pcm_t* opened = nullptr;
    const int error = snd_pcm_open(&opened, device.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
    const Pcm pcm(error < 0 ? nullptr : opened);
    return error == 0 || error == -EBUSY ? "" : cannot_be_opened(device, error);
}

}  // namespace quadrat::sound
