// Compiled without the thread sanitizer, like the TBB that distributions ship: what TBB's threads do to its own data is
// not checked. All that chunks do is.

#include "shapes/base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef GRIDSTEP_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace gridstep {

namespace {

/// Tells the sanitizer what it cannot see: all that was done before a loop happens before its chunks, and they before
/// what follows it. Chunks stay unordered among themselves, so that races between them are found.
class ForkAndJoin {
 public:
#ifdef GRIDSTEP_THREAD_SANITIZER
  ForkAndJoin() {
    __tsan_release(&fork_);
  }
  ~ForkAndJoin() {
    __tsan_acquire(&join_);
  }
  ForkAndJoin(const ForkAndJoin&) = delete;
  ForkAndJoin& operator=(const ForkAndJoin&) = delete;

  struct Chunk {
    explicit Chunk(ForkAndJoin& loop) : loop_(loop) { __tsan_acquire(&loop_.fork_); }
    ~Chunk() { __tsan_release(&loop_.join_); }
    Chunk(const Chunk&) = delete;
    Chunk& operator=(const Chunk&) = delete;
    ForkAndJoin& loop_;
  };

 private:
  char fork_ = 0, join_ = 0;
#else
  struct Chunk {
    explicit Chunk(ForkAndJoin&) {}
  };
#endif
};

}  // namespace

void parallel_chunks(std::size_t size, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& chunk) {
  using Range = tbb::blocked_range<std::size_t>;
  ForkAndJoin loop;
  tbb::parallel_for(Range(0, size, grain), [&](const Range& range) {
    [[maybe_unused]] const ForkAndJoin::Chunk order(loop);
    chunk(range.begin(), range.end());
  });
}

std::size_t parallel_workers() {
  return std::size_t(tbb::this_task_arena::max_concurrency());
}

std::size_t parallel_worker() {
  return std::size_t(tbb::this_task_arena::current_thread_index());
}

}  // namespace gridstep
