// SPDX-License-Identifier: Apache-2.0
#include "sound/wav.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/error.hpp"

namespace quadrat::sound {
namespace {

constexpr int kLongest_s = 60;
constexpr std::uint16_t kPcm = 1, kFloat = 3, kExtensible = 0xFFFE;

void put(std::string& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

std::uint32_t get(std::string_view bytes, std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]))
                 << (8 * i);
    return value;
}

[[noreturn]] void refuse(std::string_view source, const std::string& what) {
    throw base::InputError(
        fmt::format("{}: {}; save it as WAV of 16 bits, mono or stereo, at most {} s", source, what, kLongest_s));
}

struct Form {
    std::uint16_t kind = 0, channels = 0, bits = 0;
    std::uint32_t rate = 0;
};

Form form_from(std::string_view chunk, std::string_view source) {
    if (chunk.size() < 16) refuse(source, "its form is cut off");
    Form form;
    form.kind = static_cast<std::uint16_t>(get(chunk, 0, 2));
    form.channels = static_cast<std::uint16_t>(get(chunk, 2, 2));
    form.rate = get(chunk, 4, 4);
    form.bits = static_cast<std::uint16_t>(get(chunk, 14, 2));
    if (form.kind == kExtensible && chunk.size() >= 26) form.kind = static_cast<std::uint16_t>(get(chunk, 24, 2));
    const bool is_known =
        (form.kind == kPcm && (form.bits == 8 || form.bits == 16)) || (form.kind == kFloat && form.bits == 32);
    if (!is_known) refuse(source, fmt::format("it is of form {} with {} bits", form.kind, form.bits));
    if (form.channels < 1 || form.channels > 8) refuse(source, fmt::format("it has {} channels", form.channels));
    if (form.rate < 8'000 || form.rate > 192'000)
        refuse(source, fmt::format("it has {} samples per second", form.rate));
    return form;
}

float sample_at(std::string_view data, std::size_t at, const Form& form) {
    if (form.kind == kFloat) {
        const auto value = std::bit_cast<float>(get(data, at, 4));
        return std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
    }
    if (form.bits == 8) return (static_cast<float>(get(data, at, 1)) - 128.0F) / 128.0F;
    return static_cast<float>(static_cast<std::int16_t>(get(data, at, 2))) / 32'768.0F;
}

std::vector<float> samples_from(std::string_view data, const Form& form, std::string_view source) {
    const std::size_t bytes = form.bits / 8U, frame = bytes * form.channels;
    const std::size_t frames = data.size() / frame;
    if (frames == 0) refuse(source, "it holds no sound");
    if (frames > static_cast<std::size_t>(kLongest_s) * form.rate) refuse(source, "it is too long");
    std::vector<float> samples(frames);
    for (std::size_t i = 0; i < frames; ++i) {
        float sum = 0;
        for (std::size_t channel = 0; channel < form.channels; ++channel)
            sum += sample_at(data, i * frame + channel * bytes, form);
        samples[i] = sum / static_cast<float>(form.channels);
    }
    return resampled(samples, static_cast<int>(form.rate), kRate);
}

}  // namespace

std::string wav_of(Block block) {
    const auto bytes = static_cast<std::uint32_t>(block.size() * 4);
    std::string wav = "RIFF";
    put(wav, 36 + bytes, 4);
    wav += "WAVEfmt ";
    put(wav, 16, 4);
    put(wav, kPcm, 2);
    put(wav, 2, 2);
    put(wav, kRate, 4);
    put(wav, kRate * 4, 4);
    put(wav, 4, 2);
    put(wav, 16, 2);
    wav += "data";
    put(wav, bytes, 4);
    const auto put_sample = [&wav](float value) {
        const auto whole = static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32'767.0F));
        put(wav, static_cast<std::uint16_t>(whole), 2);
    };
    for (const Frame& frame : block) {
        put_sample(frame.left);
        put_sample(frame.right);
    }
    return wav;
}

std::vector<float> speech_from_wav(std::string_view bytes, std::string_view source) {
    if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE")
        refuse(source, "it is no WAV");
    std::size_t at = 12;
    std::optional<Form> form;
    while (at + 8 <= bytes.size()) {
        const std::string_view name = bytes.substr(at, 4);
        const std::size_t length = std::min<std::size_t>(get(bytes, at + 4, 4), bytes.size() - at - 8);
        const std::string_view chunk = bytes.substr(at + 8, length);
        if (name == "fmt ") form = form_from(chunk, source);
        if (name == "data") {
            if (!form) refuse(source, "its sound comes before its form");
            return samples_from(chunk, *form, source);
        }
        at += 8 + length + length % 2;
    }
    refuse(source, "it holds no sound");
}

std::vector<float> resampled(const std::vector<float>& samples, int from_rate, int to_rate) {
    if (from_rate == to_rate || samples.empty()) return samples;
    const double step = static_cast<double>(from_rate) / to_rate;
    std::vector<float> made(static_cast<std::size_t>(static_cast<double>(samples.size()) / step));
    const auto sample = [&samples](std::int64_t i) {
        return samples[static_cast<std::size_t>(std::clamp<std::int64_t>(i, 0, std::ssize(samples) - 1))];
    };
    for (std::size_t i = 0; i < made.size(); ++i) {
        const double place = static_cast<double>(i) * step;
        const auto whole = static_cast<std::int64_t>(place);
        const auto t = static_cast<float>(place - static_cast<double>(whole));
        const float a = sample(whole - 1), b = sample(whole), c = sample(whole + 1), d = sample(whole + 2);
        // Catmull and Rom 1974.
        made[i] = b + 0.5F * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
    }
    return made;
}

}  // namespace quadrat::sound
