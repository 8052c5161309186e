#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace gridstep {

#ifdef __SANITIZE_THREAD__
namespace detail {

/// Tells the thread sanitizer what it cannot see in a TBB that was built without it: all that was done before a
/// parallel loop happens before its chunks, and they before what follows the loop. Chunks stay unordered among
/// themselves, so that races between them are found.
class ForkAndJoin {
 public:
  ForkAndJoin() { __tsan_release(&fork_); }
  ~ForkAndJoin() { __tsan_acquire(&join_); }
  ForkAndJoin(const ForkAndJoin&) = delete;
  ForkAndJoin& operator=(const ForkAndJoin&) = delete;

  void begin_chunk() { __tsan_acquire(&fork_); }
  void end_chunk() { __tsan_release(&join_); }

 private:
  char fork_ = 0, join_ = 0;
};

}  // namespace detail
#endif

/// Calls chunk(begin, end) for disjoint ranges that cover [0, size), of no more than `grain` indices unless all are
/// busy, on the threads of the current arena. Returns when all are done, or throws what a chunk threw.
template <class Chunk>
void parallel_chunks(std::size_t size, std::size_t grain, const Chunk& chunk) {
  using Range = tbb::blocked_range<std::size_t>;
#ifdef __SANITIZE_THREAD__
  detail::ForkAndJoin order;
  // TBB copies this function to memory of its own, hence nothing in it is checked but the chunk itself.
  tbb::parallel_for(
      Range(0, size, grain), [&order, &chunk ](const Range& range) __attribute__((no_sanitize_thread)) {
        order.begin_chunk();
        try {
          chunk(range.begin(), range.end());
        } catch (...) {
          order.end_chunk();
          throw;
        }
        order.end_chunk();
      });
#else
  tbb::parallel_for(Range(0, size, grain), [&](const Range& range) { chunk(range.begin(), range.end()); });
#endif
}

}  // namespace gridstep
