// SPDX-License-Identifier: Apache-2.0
// A lock is left before it goes. llvmpipe looks whether a fence is done without the fence's lock, and then frees it:
// also under the thread that counted last and is just leaving that lock, which then writes its zeros over whatever has
// the memory next. There it is every picture's fence, drawn into whatever target, so that it can't be helped by what
// this program asks of the driver; but the driver does destroy the lock first, and finds this function for it.
#include <dlfcn.h>
#include <pthread.h>

#include <ctime>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define QUADRAT_DESTROYS_NO_LOCKS  // the sanitizer's own is needed
#endif
#endif

#if !defined(QUADRAT_DESTROYS_NO_LOCKS) && !defined(__SANITIZE_THREAD__)
namespace {

using Destroy = int (*)(pthread_mutex_t*);

// Longer than any thread is kept from leaving a lock, and not for ever, should the caller be who holds it.
constexpr std::time_t kLongestSeconds = 2;

}  // namespace

extern "C" __attribute__((visibility("default"))) int pthread_mutex_destroy(pthread_mutex_t* mutex) noexcept {
    static const auto system_s = reinterpret_cast<Destroy>(::dlsym(RTLD_NEXT, "pthread_mutex_destroy"));
    std::timespec until{};
    std::timespec_get(&until, TIME_UTC);
    until.tv_sec += kLongestSeconds;
    if (::pthread_mutex_timedlock(mutex, &until) == 0) ::pthread_mutex_unlock(mutex);
    return system_s(mutex);
}
#endif
