#include "core/body/mesh_import/confine.h"

#include <grp.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace toile::mesh_import {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCanFilter = false;  // their runtimes ask for much else
#else
constexpr bool kCanFilter = kArchitecture != 0;
#endif

/// Memory, time, the files that are open, and the end: what a C++ program does that reads and counts.
constexpr int kAllowed[] = {
    SYS_read,         SYS_readv,          SYS_pread64,      SYS_write,         SYS_writev,
    SYS_lseek,        SYS_fstat,          SYS_newfstatat,   SYS_close,         SYS_fcntl,
    SYS_brk,          SYS_mmap,           SYS_munmap,       SYS_mremap,        SYS_mprotect,
    SYS_madvise,      SYS_futex,          SYS_sched_yield,  SYS_clock_gettime, SYS_clock_nanosleep,
    SYS_gettimeofday, SYS_getrandom,      SYS_getpid,       SYS_gettid,
    SYS_tgkill,  // of abort()
    SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack,   SYS_restart_syscall,
    SYS_exit,         SYS_exit_group};

sock_filter statement(int code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}

/// Goes on `then` or `otherwise` statements further, by whether what was loaded is `value`.
sock_filter jump_if_equal(std::uint32_t value, std::uint8_t then, std::uint8_t otherwise) {
  return {static_cast<std::uint16_t>(BPF_JMP | BPF_JEQ | BPF_K), then, otherwise, value};
}

void filter_calls() {
  constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM;
  std::vector<sock_filter> program{
      statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      jump_if_equal(kArchitecture, 1, 0),  // numbers mean something else to another one
      statement(BPF_RET | BPF_K, kRefuse),
      statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
  };
  for (const int call : kAllowed) {
    program.push_back(jump_if_equal(static_cast<std::uint32_t>(call), 0, 1));
    program.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  program.push_back(statement(BPF_RET | BPF_K, kRefuse));
  const sock_fprog whole{static_cast<unsigned short>(program.size()), program.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &whole);
}

/// Root's readers become nobody: the limit on processes does not hold for root.
void become_nobody() {
  constexpr unsigned kNobody = 65534;
  if (::geteuid() != 0 || ::setgroups(0, nullptr) != 0) return;
  if (::setresgid(kNobody, kNobody, kNobody) != 0) return;
  if (::setresuid(kNobody, kNobody, kNobody) != 0) return;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a change of user forgets it
}

}  // namespace

void confine() {
  const rlimit three{3, 3}, none{0, 0};
  ::setrlimit(RLIMIT_NOFILE, &three);  // those that are open stay open
  become_nobody();
  ::setrlimit(RLIMIT_NPROC, &none);
  if (kCanFilter) filter_calls();
}

}  // namespace toile::mesh_import
