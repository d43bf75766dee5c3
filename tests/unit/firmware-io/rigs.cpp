// SPDX-License-Identifier: Apache-2.0
#include "rigs.hpp"

#include <algorithm>

#include "fake_evdev.hpp"
#include "fake_gpio.hpp"
#include "fake_hid.hpp"
#include "firmware-io/evdev/evdev_buttons.hpp"
#include "firmware-io/evdev/libevdev_host.hpp"
#include "firmware-io/gpio/gpio_buttons.hpp"
#include "firmware-io/hid/hid_buttons.hpp"
#include "firmware-io/hid/hidraw.hpp"
#include "firmware-io/keyboard/keyboard_buttons.hpp"
#include "firmware-io/merged_buttons.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"
#include "stand_in_kernel.hpp"

namespace quadrat::tests {

using namespace firmware_io;
using namespace std::chrono_literals;

void Rig::schedule(Act act) { acts_.push_back(act); }

std::vector<ButtonEdge> Rig::poll(Instant now) {
    if (!is_prepared_) {
        std::stable_sort(acts_.begin(), acts_.end(), [](const Act& a, const Act& b) { return a.at < b.at; });
        prepare(acts_);
        is_prepared_ = true;
    }
    for (; next_ < acts_.size() && acts_[next_].at <= now; ++next_) deliver(acts_[next_]);
    now_ = now;
    return source().poll(now);
}

std::vector<ButtonEdge> Rig::run(Instant until, Instant step) {
    std::vector<ButtonEdge> all;
    while (now_ < until) {
        const auto edges = poll(std::min(until, now_ + step));
        all.insert(all.end(), edges.begin(), edges.end());
    }
    return all;
}

void Rig::press(Button button, Instant at, Instant span) {
    schedule({Act::Close, button, at});
    schedule({Act::Open, button, at + span});
}

void Rig::bounce(Button button, Instant at, int edges, Instant span) {
    for (int i = 0; i < edges; ++i) schedule({i % 2 == 0 ? Act::Close : Act::Open, button, at + span * i / edges});
    schedule({Act::Close, button, at + span});
}

namespace {

class ScriptedRig : public Rig {
  public:
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act&) override {}
    void prepare(const std::vector<Act>& acts) override {
        scripted::Script script;
        for (const Act& act : acts) {
            constexpr std::array kHappenings{scripted::Happening::Close, scripted::Happening::Open,
                                             scripted::Happening::Unplug, scripted::Happening::Plug};
            script.events.push_back({act.at, kHappenings.at(act.kind), act.button});
            script.end = act.at;
        }
        buttons_ = std::make_unique<scripted::ScriptedButtons>(script);
    }

  private:
    std::unique_ptr<scripted::ScriptedButtons> buttons_;
};

class KeyboardRig : public Rig {
  public:
    ButtonSource& source() override { return buttons_; }
    bool can_be_absent() const override { return false; }
    void deliver(const Act& act) override {
        constexpr std::array kKeys{'A', '2', 'c', 'D', keyboard::kEscape};
        if (act.kind == Act::Unplug) has_focus_ = false, buttons_.lost_focus(act.at);
        if (act.kind == Act::Plug) has_focus_ = true;
        if (!has_focus_ || act.kind > Act::Open) return;
        const char key = kKeys.at(index_of(act.button));
        buttons_.key(key, act.kind == Act::Close ? Motion::Down : Motion::Up, act.at);
        if (act.kind == Act::Close) buttons_.key(key, Motion::Down, act.at);  // as auto-repeat does
    }

  private:
    keyboard::KeyboardButtons buttons_;
    bool has_focus_ = true;
};

class GpioRig : public Rig {
  public:
    GpioRig() {
        gpio::Wiring wiring;
        std::vector<std::string> names;
        for (const Button button : kButtons) {
            names.push_back("GPIO" + std::to_string(index_of(button)));
            wiring.contacts.push_back({button, {names.back(), {}}});
        }
        machine_->chips = {chip_of("/dev/gpiochip0", "pinctrl-fake", names)};
        buttons_ = std::make_unique<gpio::GpioButtons>(std::make_unique<FakeGpioHost>(machine_), wiring);
    }
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act& act) override {
        const gpio::LinePlace line{"/dev/gpiochip0", static_cast<unsigned>(index_of(act.button))};
        if (act.kind == Act::Unplug) machine_->unplug();
        if (act.kind == Act::Plug) machine_->plug();
        if (act.kind <= Act::Open) machine_->move(line, act.kind == Act::Close, act.at);
    }

  protected:
    std::shared_ptr<FakeGpioMachine> machine_ = std::make_shared<FakeGpioMachine>();
    std::unique_ptr<ButtonSource> buttons_;
};

class HidRig : public Rig {
  public:
    HidRig() {
        buttons_ = std::make_unique<hid::HidButtons>(std::make_unique<FakeHidHost>(FakeHidDevices{device_}),
                                                     hid::HidSelector{});
    }
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act& act) override {
        const auto bit = static_cast<std::uint8_t>(1u << index_of(act.button));
        if (act.kind == Act::Unplug) device_->unplug();
        if (act.kind == Act::Plug) device_->plug();
        if (act.kind == Act::Close) held_ = static_cast<std::uint8_t>(held_ | bit);
        if (act.kind == Act::Open) held_ = static_cast<std::uint8_t>(held_ & ~bit);
        if (act.kind != Act::Unplug) device_->send({held_});
    }

  protected:
    std::shared_ptr<FakeHidDevice> device_ = five_button_device();
    std::unique_ptr<ButtonSource> buttons_;
    std::uint8_t held_ = 0;
};

// hidapi itself, on nodes that a stand-in for the kernel answers.
class HidrawRig : public Rig {
  public:
    HidrawRig() {
        buttons_ = std::make_unique<hid::HidButtons>(std::make_unique<hid::Hidraw>(folder_.sys(), folder_.dev()),
                                                     hid::HidSelector{});
    }
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act& act) override {
        const auto bit = static_cast<std::uint8_t>(1u << index_of(act.button));
        if (act.kind == Act::Unplug) device_.unplug();
        if (act.kind == Act::Plug) device_.plug();
        if (act.kind == Act::Close) held_ = static_cast<std::uint8_t>(held_ | bit);
        if (act.kind == Act::Open) held_ = static_cast<std::uint8_t>(held_ & ~bit);
        if (act.kind != Act::Unplug) device_.send({held_});
    }

  private:
    StandInFolder folder_;
    StandInHidraw device_{folder_, kFiveButtons};
    std::unique_ptr<ButtonSource> buttons_;
    std::uint8_t held_ = 0;
};

class EvdevRig : public Rig {
  public:
    EvdevRig() {
        buttons_ = std::make_unique<evdev::EvdevButtons>(std::make_unique<FakeEvdevHost>(FakeEvdevDevices{device_}),
                                                         evdev::EvdevOptions{});
    }
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act& act) override {
        if (act.kind == Act::Unplug) device_->unplug();
        if (act.kind == Act::Plug) device_->plug();
        if (act.kind <= Act::Open) device_->key(kFiveKeys[index_of(act.button)], act.kind == Act::Close, act.at);
    }

  private:
    std::shared_ptr<FakeEvdevDevice> device_ = evdev_device("/dev/input/event0", kFiveKeys);
    std::unique_ptr<ButtonSource> buttons_;
};

// libevdev itself, as above.
class LibevdevRig : public Rig {
  public:
    LibevdevRig() {
        buttons_ = std::make_unique<evdev::EvdevButtons>(
            std::make_unique<evdev::LibevdevHost>(folder_.sys(), folder_.dev()), evdev::EvdevOptions{});
    }
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act& act) override {
        const auto at = std::chrono::duration_cast<std::chrono::microseconds>(FakeEvdevDevice::kKernelZero + act.at);
        if (act.kind == Act::Unplug) device_.unplug();
        if (act.kind == Act::Plug) device_.plug();
        if (act.kind <= Act::Open) device_.key(kFiveKeys[index_of(act.button)], act.kind == Act::Close, at.count());
    }

  private:
    StandInFolder folder_;
    StandInEvdev device_{folder_, {kFiveKeys.begin(), kFiveKeys.end()}};
    std::unique_ptr<ButtonSource> buttons_;
};

// The same hand on two devices at once: still one press.
class MergedRig : public Rig {
  public:
    struct Gpio : GpioRig {
        std::unique_ptr<ButtonSource> take() { return std::move(buttons_); }
    };
    struct Hid : HidRig {
        std::unique_ptr<ButtonSource> take() { return std::move(buttons_); }
    };
    MergedRig() {
        std::vector<std::unique_ptr<ButtonSource>> sources;
        sources.push_back(gpio_.take());
        sources.push_back(hid_.take());
        buttons_ = std::make_unique<MergedButtons>(std::move(sources));
    }
    ButtonSource& source() override { return *buttons_; }
    void deliver(const Act& act) override {
        gpio_.deliver(act);
        hid_.deliver(act);
    }

  private:
    Gpio gpio_;
    Hid hid_;
    std::unique_ptr<MergedButtons> buttons_;
};

}  // namespace

std::vector<RigKind> every_rig() {
    return {{"Scripted", [] { return std::make_unique<ScriptedRig>(); }},
            {"Keyboard", [] { return std::make_unique<KeyboardRig>(); }},
            {"Gpio", [] { return std::make_unique<GpioRig>(); }},
            {"Hid", [] { return std::make_unique<HidRig>(); }},
            {"Hidraw", [] { return std::make_unique<HidrawRig>(); }},
            {"Evdev", [] { return std::make_unique<EvdevRig>(); }},
            {"Libevdev", [] { return std::make_unique<LibevdevRig>(); }},
            {"Merged", [] { return std::make_unique<MergedRig>(); }}};
}

}  // namespace quadrat::tests
