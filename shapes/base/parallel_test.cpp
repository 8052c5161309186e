#include "shapes/base/parallel.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <numeric>
#include <stdexcept>

namespace gridstep {
namespace {

TEST(ParallelChunks, CoverEveryIndexOnce) {
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (const std::size_t size : {0, 1, 7, 1000}) {
      std::vector<int> calls(size, 0);
      parallel_chunks(size, 3, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) ++calls[i];
      });
      EXPECT_EQ(calls, std::vector<int>(size, 1));
    }
  }
}

TEST(ParallelChunks, SeeWhatWasDoneBeforeAndShowWhatTheyDid) {
  // Under the thread sanitizer this fails where the order of loop and chunks is not told.
  std::vector<std::size_t> values(5000);
  for (int round = 0; round < 20; ++round) {
    std::iota(values.begin(), values.end(), std::size_t(round));
    PerWorker<std::size_t> sums;
    parallel_chunks(values.size(), 10, [&](std::size_t begin, std::size_t end) {
      EXPECT_LT(parallel_worker(), parallel_workers());
      for (std::size_t i = begin; i != end; ++i) sums.local() += values[i]++;
    });
    std::size_t sum = 0;
    sums.for_each([&](std::size_t one) { sum += one; });
    EXPECT_EQ(sum, 5000u * std::size_t(round) + 4999u * 2500u);
  }
}

TEST(ParallelChunks, ThrowWhatAChunkThrows) {
  EXPECT_THROW(parallel_chunks(100, 1,
                               [](std::size_t begin, std::size_t) {
                                 if (begin > 50) throw std::out_of_range("beyond 50");
                               }),
               std::out_of_range);
}

}  // namespace
}  // namespace gridstep
