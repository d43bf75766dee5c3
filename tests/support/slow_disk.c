// SPDX-License-Identifier: Apache-2.0
// Preloaded (LD_PRELOAD), it makes every flush to the disk take $SLOW_DISK_MS: what a worn memory card does.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <time.h>

static int slowly(const char* name, int fd) {
    const char* text = getenv("SLOW_DISK_MS");
    const long ms = text ? atol(text) : 0;
    struct timespec left = {ms / 1000, ms % 1000 * 1000000L};
    while (nanosleep(&left, &left) != 0) continue;
    int (*flush)(int) = (int (*)(int))dlsym(RTLD_NEXT, name);
    return flush(fd);
}

int fsync(int fd) { return slowly("fsync", fd); }
int fdatasync(int fd) { return slowly("fdatasync", fd); }
