// SPDX-License-Identifier: Apache-2.0
// Preloaded (LD_PRELOAD), it makes the kernel say of its clock what $CLOCK_IS names: synchronised, or not.
#define _GNU_SOURCE
#include <stdlib.h>
#include <string.h>
#include <sys/timex.h>

int adjtimex(struct timex* state) {
    const char* is = getenv("CLOCK_IS");
    const int is_synchronised = is != NULL && strcmp(is, "synchronised") == 0;
    memset(state, 0, sizeof *state);
    state->status = is_synchronised ? 0 : STA_UNSYNC;
    return is_synchronised ? TIME_OK : TIME_ERROR;
}
