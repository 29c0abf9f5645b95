/* Disk errors by LD_PRELOAD, see faulty_disk.py.

   Each line of DISK_FAULTS is "CALL ERRNO PREFIX FLAG": the call fails with this error on files with
   a path that begins with PREFIX, while the file FLAG exists. CALL is open, read, write, fsync (of a
   file), fsyncdir (fsync of a folder), ftruncate or flock.

   Also calls number disk_first to disk_last of those on files below the folder disk_counted fail with
   disk_errno; disk_calls counts them. A process sets these variables by ctypes. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

long disk_calls, disk_first, disk_last;
int disk_errno;
char disk_counted[512];

static int counted(const char *path) {
    size_t length = strlen(disk_counted);
    if (!length || strncmp(path, disk_counted, length)) return 0;
    long call = __sync_add_and_fetch(&disk_calls, 1);
    if (call < disk_first || call > disk_last) return 0;
    errno = disk_errno;
    return 1;
}

static int refused(const char *call, const char *path) {
    const char *rule = getenv("DISK_FAULTS");
    char name[16], prefix[512], flag[512];
    int number;
    if (counted(path)) return 1;
    while (rule && sscanf(rule, "%15s %d %511s %511s", name, &number, prefix, flag) == 4) {
        if (!strcmp(name, call) && !strncmp(path, prefix, strlen(prefix)) && !access(flag, F_OK)) {
            errno = number;
            return 1;
        }
        rule = strchr(rule, '\n');
        rule = rule ? rule + 1 : NULL;
    }
    return 0;
}

static int refused_at(const char *call, int file) {
    char link[64], path[PATH_MAX + 1];
    int before = errno;
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    ssize_t length = readlink(link, path, PATH_MAX);
    errno = before;
    if (length < 0) return 0;
    path[length] = 0;
    return refused(call, path);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void *from, size_t count) {
    return refused_at("write", file) ? -1 : REAL(write)(file, from, count);
}

ssize_t pwrite64(int file, const void *from, size_t count, off64_t at) {
    return refused_at("write", file) ? -1 : REAL(pwrite64)(file, from, count, at);
}

ssize_t read(int file, void *to, size_t count) {
    return refused_at("read", file) ? -1 : REAL(read)(file, to, count);
}

int ftruncate64(int file, off64_t size) {
    return refused_at("ftruncate", file) ? -1 : REAL(ftruncate64)(file, size);
}

int fsync(int file) {
    struct stat found;
    int folder = !fstat(file, &found) && S_ISDIR(found.st_mode);
    return refused_at(folder ? "fsyncdir" : "fsync", file) ? -1 : REAL(fsync)(file);
}

int flock(int file, int how) {
    return refused_at("flock", file) ? -1 : REAL(flock)(file, how);
}

int open64(const char *path, int how, ...) {
    va_list more;
    va_start(more, how);
    mode_t mode = va_arg(more, mode_t);
    va_end(more);
    return refused("open", path) ? -1 : REAL(open64)(path, how, mode);
}
