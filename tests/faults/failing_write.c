/* Loaded before the C library: write number FAULT_AT fails, with FAULT_ERRNO, and all that follow, as on a disk that
   is full or mounted read-only. Counted are the calls that change files: writes to files, fsync, rename, link, mkdir,
   and opening to write. CLOCK_BACK=N: after N calls the clock of the day is an hour behind. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

static atomic_long calls;
static atomic_long looks;

/* Whether this call is to fail. The number of calls so far goes to FAULT_COUNT's descriptor at the end. */
static int fails(void) {
    const char* at = getenv("FAULT_AT");
    const long call = atomic_fetch_add(&calls, 1) + 1;
    if (at == NULL || call < atol(at)) return 0;
    const char* number = getenv("FAULT_ERRNO");
    errno = number != NULL ? atoi(number) : ENOSPC;
    return 1;
}

/* Terminals and pipes are no disk. */
static int is_file(int file) {
    struct stat status;
    const int before = errno;
    const int is = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    errno = before;
    return is;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* data, size_t size) {
    return is_file(file) && fails() ? -1 : REAL(write)(file, data, size);
}
ssize_t writev(int file, const struct iovec* parts, int count) {
    return is_file(file) && fails() ? -1 : REAL(writev)(file, parts, count);
}
ssize_t pwrite(int file, const void* data, size_t size, off_t at) {
    return is_file(file) && fails() ? -1 : REAL(pwrite)(file, data, size, at);
}
int fsync(int file) { return fails() ? -1 : REAL(fsync)(file); }
int rename(const char* from, const char* to) { return fails() ? -1 : REAL(rename)(from, to); }
int link(const char* from, const char* to) { return fails() ? -1 : REAL(link)(from, to); }
int mkdir(const char* path, mode_t mode) { return fails() ? -1 : REAL(mkdir)(path, mode); }

static int opening(const char* path, int flags, mode_t mode) {
    return (flags & O_CREAT) != 0 && fails() ? -1 : REAL(open)(path, flags, mode);
}
int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opening(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opening(path, flags, mode);
}
FILE* fopen(const char* path, const char* mode) {
    return mode[0] != 'r' && fails() ? NULL : REAL(fopen)(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
    return mode[0] != 'r' && fails() ? NULL : REAL(fopen64)(path, mode);
}

static time_t behind(void) {
    const char* after = getenv("CLOCK_BACK");
    return after != NULL && atomic_fetch_add(&looks, 1) >= atol(after) ? 3600 : 0;
}
int clock_gettime(clockid_t clock, struct timespec* now) {
    const int result = REAL(clock_gettime)(clock, now);
    if (clock == CLOCK_REALTIME) now->tv_sec -= behind();
    return result;
}
time_t time(time_t* out) {
    const time_t now = REAL(time)(NULL) - behind();
    if (out != NULL) *out = now;
    return now;
}

/* How many there are to fail. */
__attribute__((destructor)) static void tell(void) {
    const char* file = getenv("FAULT_COUNT");
    FILE* out = file != NULL ? REAL(fopen)(file, "w") : NULL;
    if (out == NULL) return;
    fprintf(out, "%ld\n", atomic_load(&calls));
    fclose(out);
}
