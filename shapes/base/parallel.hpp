#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace gridstep {

/// Calls chunk(begin, end) for disjoint ranges that cover [0, size), each of at least half of `grain` indices where
/// there are as many, on the threads of the current TBB arena. Returns when all are done, or throws what a chunk threw.
void parallel_chunks(std::size_t size, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& chunk);

/// How many threads chunks may run on, and, inside a chunk, which of them this is: 0 <= worker < parallel_workers().
std::size_t parallel_workers();
std::size_t parallel_worker();

/// A value for each thread that chunks run on. To be read as a whole after the loop.
template <class T>
class PerWorker {
 public:
  explicit PerWorker(const T& initial = {}) : values_(parallel_workers(), {initial}) {}

  T& local() { return values_[parallel_worker()].value; }

  template <class Visit>
  void for_each(Visit visit) const {
    for (const Slot& slot : values_) visit(slot.value);
  }

 private:
  struct alignas(64) Slot {  // a cache line, so that threads do not share one
    T value;
  };
  std::vector<Slot> values_;
};

}  // namespace gridstep
