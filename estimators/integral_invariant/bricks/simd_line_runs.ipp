// Rows of bricks as runs of points along their lines, and the ends of balls on them. Included once for each
// instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

/// Lines of 8 points are bytes, those of 64 are words; so are numbers of points along a row. Words are signed, as
/// what AVX2 compares and multiplies.
template <int d>
using LineTag = std::conditional_t<d == 2, LongTag, ByteTag>;
template <int d>
using LineVector = hn::VFromD<LineTag<d>>;
template <int d>
using LineNumber = hn::TFromD<LineTag<d>>;

/// On each line of a row of bricks the points x of one run, begin <= x < end, or none: end = 0. On the sides: the number
/// of points between the row's base and the run, and the run's length.
template <int d>
struct LineRuns {
  alignas(64) std::array<LineNumber<d>, hn::MaxLanes(LineTag<d>())> begin, end_or_length;
};

/// Parts of rows as line runs: for each part as many as the line that has most needs, one where the set is smooth.
template <int d>
class RowRuns {
 public:
  /// The middle is counted from this many points left of the source brick: more than it reaches.
  static constexpr int kMiddleOrigin = 16 * Lines<d>::kLength;

  /// All in the lanes from the at-th line of every brick on.
  template <class Sum>
  void list_middle(const SourceLists<d, Sum>& lists, std::size_t at) {
    clear();
    for (const CutRow<d, Sum>& part : lists.rows.cut) list(lists, part, at, -kMiddleOrigin);
  }
  template <class Sum>
  void list_right(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, std::size_t at) {
    clear();
    for (const CutRow<d, Sum>& part : lists.right.cut) {
      const std::size_t first = rows_.size();
      list(lists, part, at, ball.rows()[part.row].base());
      change(first, [](auto begin, auto) HWY_ATTR { return begin; });
    }
  }
  template <class Sum>
  void list_left(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, std::size_t at) {
    clear();
    for (const CutRow<d, Sum>& part : lists.left.cut) {
      const std::size_t first = rows_.size();
      const auto& row = ball.rows()[part.row];
      list(lists, part, at, -row.reach * kLength);
      const auto base = hn::Set(tag, LineNumber<d>((row.reach + 1 - row.near) * kLength));
      change(first, [&](auto, auto end) HWY_ATTR { return hn::Sub(base, end); });
    }
  }

  std::size_t size() const { return rows_.size(); }
  std::uint32_t row(std::size_t i) const { return rows_[i]; }
  const LineRuns<d>& operator[](std::size_t i) const { return runs_[i]; }

 private:
  static constexpr LineTag<d> tag{};
  static constexpr int kLength = Lines<d>::kLength;

  void clear() {
    rows_.clear();
    runs_.clear();
  }
  /// Makes ends lengths, and begins what from(begin, end) says.
  template <class From>
  HWY_INLINE void change(std::size_t first, From from) {
    for (std::size_t i = first; i < rows_.size(); ++i) {
      LineRuns<d>& one = runs_[i];
      const auto begin = hn::Load(tag, one.begin.data()), end = hn::Load(tag, one.end_or_length.data());
      hn::Store(from(begin, end), tag, one.begin.data());
      hn::Store(hn::Sub(end, begin), tag, one.end_or_length.data());
    }
  }
  /// Counts x from `origin`.
  template <class Sum>
  HWY_INLINE void list(const SourceLists<d, Sum>& lists, const CutRow<d, Sum>& part, std::size_t at, int origin) {
    const std::size_t first = rows_.size();
    auto begin = hn::Zero(tag), end = begin;
    lists.for_each_run(part, [&](int first_brick, int last_brick, const Brick<d>* mixed) HWY_ATTR {
      const auto bits = mixed
                            ? hn::Load(tag, reinterpret_cast<const LineNumber<d>*>(mixed->words.data()) + at)
                            : hn::Set(tag, LineNumber<d>(~LineNumber<d>{}));
      const int x = first_brick * kLength - origin, more = (last_brick - first_brick - 1) * kLength;
      const auto others = join(bits, x, more, begin, end);
      if (!hn::AllTrue(tag, hn::Eq(others, hn::Zero(tag)))) add(part.row, first, others, x, more);
    });
    if (!hn::AllTrue(tag, hn::Eq(end, hn::Zero(tag)))) push(part.row, begin, end);
  }
  static HWY_INLINE LineVector<d> bit_count(LineVector<d> bits) {
    return hn::BitCast(tag, hn::PopulationCount(hn::BitCast(hn::RebindToUnsigned<LineTag<d>>(), bits)));
  }
  /// The brick that begins at x, mixed or full and followed by `more` points of full ones: the lowest run of each line
  /// goes on where begin and end leave off, or begins them. Returns the bits of all other runs.
  static HWY_INLINE LineVector<d> join(LineVector<d> bits, int x, int more, LineVector<d>& begin,
                                       LineVector<d>& end) {
    const auto zero = hn::Zero(tag);
    const auto lowest = hn::And(bits, hn::Sub(zero, bits)), above = hn::Add(bits, lowest);
    const auto at =
        hn::Add(bit_count(hn::Sub(lowest, hn::Set(tag, LineNumber<d>{1}))), hn::Set(tag, LineNumber<d>(x)));
    const auto length = hn::Add(bit_count(hn::AndNot(above, bits)), hn::Set(tag, LineNumber<d>(more)));
    const auto any = hn::Ne(bits, zero), is_free = hn::Eq(end, zero);
    const auto fits = hn::And(any, hn::Or(is_free, hn::Eq(end, at)));
    begin = hn::IfThenElse(hn::And(fits, is_free), at, begin);
    end = hn::IfThenElse(fits, hn::Add(at, length), end);
    return hn::IfThenElse(fits, hn::And(bits, above), bits);
  }
  /// Joins bits with the runs from the i-th on, and with new ones.
  HWY_NOINLINE void add(std::uint32_t row, std::size_t i, LineVector<d> bits, int x, int more) {
    while (!hn::AllTrue(tag, hn::Eq(bits, hn::Zero(tag)))) {
      if (i == rows_.size()) push(row, hn::Zero(tag), hn::Zero(tag));
      LineRuns<d>& own = runs_[i++];
      auto begin = hn::Load(tag, own.begin.data()), end = hn::Load(tag, own.end_or_length.data());
      bits = join(bits, x, more, begin, end);
      hn::Store(begin, tag, own.begin.data());
      hn::Store(end, tag, own.end_or_length.data());
    }
  }
  HWY_INLINE void push(std::uint32_t row, LineVector<d> begin, LineVector<d> end) {
    rows_.push_back(row);
    LineRuns<d>& own = runs_.emplace_back();
    hn::Store(begin, tag, own.begin.data());
    hn::Store(end, tag, own.end_or_length.data());
  }

  std::vector<std::uint32_t> rows_;
  std::vector<LineRuns<d>> runs_;
};

/// All that the balls around the spels of a source brick may cut.
template <int d>
struct CutRuns {
  RowRuns<d> middle, right, left;

  template <class Sum>
  void list(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, std::size_t at) {
    middle.list_middle(lists, at);
    right.list_right(lists, ball, at);
    left.list_left(lists, ball, at);
  }
};

/// The balls around N spels of one line of the source brick, which share their half-widths.
template <int d, std::size_t N>
struct LineBalls {
  static constexpr int kLength = Lines<d>::kLength;
  static constexpr LineTag<d> tag{};
  using V = LineVector<d>;

  const LineNumber<d>* widths;
  V right_end[N], left_end[N];  // in the middle, where the width is 0: it is to be added, or subtracted
  V to_right[N], to_left[N];    // as in AlignedBall

  LineBalls(const BallRows<d>& ball, const std::uint16_t* bits, std::size_t at)
      : widths(ball.widths(bits[0] / kLength)->of.data() + at) {
    constexpr int kOrigin = RowRuns<d>::kMiddleOrigin;
    for (std::size_t i = 0; i < N; ++i) {
      const int x = bits[i] % kLength;
      right_end[i] = hn::Set(tag, LineNumber<d>(kOrigin + x + 1 - kLength));
      left_end[i] = hn::Set(tag, LineNumber<d>(kOrigin + x + kLength + ball.skew()));
      to_right[i] = hn::Set(tag, LineNumber<d>(kLength - 1 - x));
      to_left[i] = hn::Set(tag, LineNumber<d>(x + ball.skew()));
    }
  }
  HWY_INLINE V width(std::uint32_t row) const {
    return hn::Load(tag, widths + std::size_t(row) * Lines<d>::kCount);
  }
};

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
