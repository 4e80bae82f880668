/* A wall clock that a test can set, for the programs that it starts with this preloaded: all that
 * they and LCM read of it through the C library is ahead by the number of nanoseconds in the file
 * $STEPPED_CLOCK. Not covered: the kernel's own stamps (LCM's receive time, files). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static const int64_t kSecond = 1000000000;
static int (*real_clock_gettime)(clockid_t, struct timespec*);
static const volatile int64_t* ahead;

__attribute__((constructor)) static void open_clock(void) {
  const char* name = getenv("STEPPED_CLOCK");
  const int file = name == NULL ? -1 : open(name, O_RDONLY | O_CLOEXEC);
  if (file < 0) _exit(127);
  ahead = mmap(NULL, sizeof(*ahead), PROT_READ, MAP_SHARED, file, 0);
  close(file);
  if (ahead == MAP_FAILED) _exit(127);
}

int clock_gettime(clockid_t clock, struct timespec* time) {
  if (real_clock_gettime == NULL) *(void**)&real_clock_gettime = dlsym(RTLD_NEXT, "clock_gettime");
  const int result = real_clock_gettime(clock, time);
  const int is_wall = clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE;
  if (result != 0 || !is_wall || ahead == NULL) return result;
  const int64_t now = (int64_t)time->tv_sec * kSecond + time->tv_nsec + *ahead;
  time->tv_sec = now / kSecond;
  time->tv_nsec = now % kSecond;
  return 0;
}

int gettimeofday(struct timeval* restrict time, void* restrict zone) {
  (void)zone;
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* result) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (result != NULL) *result = now.tv_sec;
  return now.tv_sec;
}
