// What the vector loops share. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A brick, or the half-widths of a row, is one vector of 64 bytes or several smaller ones.
using ByteTag = hn::CappedTag<std::uint8_t, 64>;
using WordTag = hn::Repartition<std::uint64_t, ByteTag>;
using Bytes = hn::VFromD<ByteTag>;
using Words = hn::VFromD<WordTag>;

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
