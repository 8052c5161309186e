#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>

#include "estimators/integral_invariant/bricks/targets.hpp"
#include "estimators/integral_invariant/bricks/testing_cases.hpp"

namespace gridstep::bricks {
namespace {

/// @throws std::runtime_error where two ways differ.
template <class Sum, int d>
void compare(const Evaluations<Sum, d>& evaluations, const RandomSet<d>& set) {
  const std::vector<Sum> expected = evaluations.full(set);
  const auto check = [&](const std::vector<Sum>& sums, const std::string& way) {
    if (sums != expected) throw std::runtime_error(way + " differs from full on a set of kind " + set.kind);
  };
  check(evaluations.masks(set), "masks");
  for (const Target& target : targets()) {
    use_target(target.name);
    check(evaluations.bricks(set), "bricks/" + target.name);
  }
}

/// Sets for one ball; returns the number of spels.
template <int d>
std::size_t run(RandomStream& random, std::uint64_t sets) {
  // Few balls have rows of bricks that go through their inside: the full kernel of those is slow.
  const bool is_large = random.below(8) == 0;
  const RandomBall ball = random_ball<d>(random, d == 2 ? (is_large ? 150 : 40) : (is_large ? 24 : 8));
  const Evaluations<PlainSum<d, std::int64_t>, d> counts(ball);
  const Evaluations<MomentSums<d, std::int64_t>, d> moments(ball);
  std::size_t spels = 0;
  for (std::uint64_t i = 0; i < sets; ++i) {
    const RandomSet<d> set =
        random_set<d>(random, d == 2 ? (is_large ? 300 : 120) : (is_large ? 64 : 24), 16);
    spels += set.spels.size();
    try {
      compare(counts, set);
      compare(moments, set);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}, set {} of a ball of R/h = {} with half axis {}", error.what(), i,
                                           ball.radius.value, ball.half_axis));
    }
  }
  return spels;
}

/// A case is one set and one ball, in 2D or 3D, on one thread or two, in every way there is. GRIDSTEP_FUZZ_CASES and
/// GRIDSTEP_FUZZ_SEED ask for more of them than a test has time for, or for others.
TEST(Fuzz, EveryWayGivesTheSumsOfTheFullKernel) {
  const auto setting = [](const char* name, std::uint64_t usual) {
    const char* const value = std::getenv(name);
    return value ? std::strtoull(value, nullptr, 10) : usual;
  };
  const std::uint64_t cases = setting("GRIDSTEP_FUZZ_CASES", 2000), seed = setting("GRIDSTEP_FUZZ_SEED", 1);
  constexpr std::uint64_t kSetsOfBall = 200;  // the tables of a ball take longer than a case
  std::size_t spels = 0;
  for (std::uint64_t done = 0, ball = 0; done < cases; done += kSetsOfBall, ++ball) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1 + ball / 2 % 2);
    RandomStream random({seed, ball});
    const std::uint64_t sets = std::min(kSetsOfBall, cases - done);
    ASSERT_NO_THROW(spels += ball % 2 == 0 ? run<2>(random, sets) : run<3>(random, sets))
        << "seed " << seed << ", ball " << ball;
  }
  use_target(targets().front().name);
  RecordProperty("spels", std::to_string(spels));
}

}  // namespace
}  // namespace gridstep::bricks
