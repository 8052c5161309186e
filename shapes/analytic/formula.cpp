#include "shapes/analytic/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

constexpr int kMaxDegree = 64;
constexpr int kMaxDepth = 200;  // of nested parentheses and signs: the parser recurses
constexpr std::size_t kMaxOperations = 10000;

/// In one line of a message, whatever the text is.
std::string shown(std::string text) {
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = '?';
  return text;
}

}  // namespace

/// Recursive descent; each rule returns the register of its value and the degree.
class Formula::Parser {
 public:
  struct Term {
    int reg;
    int degree;
  };

  Parser(const std::string& text, Formula& formula) : text_(text), formula_(formula) {}

  Term parse() {
    const Term term = sum();
    if (peek() != '\0' || at_ < text_.size()) fail("an operator or the end");
    return term;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(fmt::format(
        "polynomial '{}': expected {} at character {}{}", shown(text_), expected, at_ + 1,
        at_ < text_.size() ? fmt::format(", not '{}'", shown(text_.substr(at_, 1))) : ", where it ends"));
  }
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  /// Appends an operation, by a number in place of a constant factor; or its value where both operands are constants
  /// written next to each other.
  Term emit_binary(Kind kind, const Term& left, const Term& right, int degree) {
    std::vector<Operation>& all = formula_.operations_;
    const auto is_last_but = [&](int n, const Term& term) {
      return term.reg == int(all.size()) - 1 - n && all[std::size_t(term.reg)].kind == Kind::constant;
    };
    if (!is_last_but(1, left) || !is_last_but(0, right)) {
      if (kind == Kind::product)
        for (const auto& [factor, other] : {std::pair(left, right), std::pair(right, left)})
          if (const Operation& by = all[std::size_t(factor.reg)]; by.kind == Kind::constant)
            return emit({Kind::scaled, other.reg, 0, by.number}, degree);
      return emit({kind, left.reg, right.reg}, degree);
    }
    const double b = all.back().number;
    all.pop_back();
    double& a = all.back().number;
    a = kind == Kind::sum ? a + b : kind == Kind::difference ? a - b : a * b;
    return {int(all.size()) - 1, degree};
  }
  /// Appends an operation, or finds it where it was done before.
  Term emit(Operation operation, int degree) {
    if (degree > kMaxDegree) fail(fmt::format("a degree of at most {} before", kMaxDegree));
    std::vector<Operation>& all = formula_.operations_;
    if (operation.kind != Kind::constant) {  // these may still be folded
      const auto known = std::find(all.begin(), all.end(), operation);
      if (known != all.end()) return {int(known - all.begin()), degree};
    }
    if (all.size() >= kMaxOperations) fail(fmt::format("at most {} operations", kMaxOperations));
    all.push_back(operation);
    return {int(all.size()) - 1, degree};
  }

  Term sum() {
    Term left = product();
    while (true) {
      const bool plus = accept('+');
      if (!plus && !accept('-')) return left;
      const Term right = product();
      left =
          emit_binary(plus ? Kind::sum : Kind::difference, left, right, std::max(left.degree, right.degree));
    }
  }
  Term product() {
    Term left = power();
    while (true) {
      if (accept('*')) {
        const Term right = power();
        left = emit_binary(Kind::product, left, right, left.degree + right.degree);
      } else if (accept('/')) {
        const double divisor = number("a number to divide by");
        if (!std::isfinite(1 / divisor)) fail("a divisor other than 0 before");
        left = emit({Kind::scaled, left.reg, 0, 1 / divisor}, left.degree);
      } else {
        return left;
      }
    }
  }
  Term power() {
    if (++depth_ > kMaxDepth) fail(fmt::format("at most {} nested parentheses and signs", kMaxDepth));
    Term term;
    if (accept('-')) {
      term = power();
      Operation& last = formula_.operations_.back();
      if (last.kind == Kind::constant && term.reg == int(formula_.operations_.size()) - 1)
        last.number = -last.number;
      else
        term = emit({Kind::scaled, term.reg, 0, -1.0}, term.degree);
    } else if (accept('+')) {
      term = power();
    } else {
      term = atom();
      if (accept('^')) term = raised(term, exponent());
    }
    --depth_;
    return term;
  }
  Term atom() {
    const char c = peek();
    if (c >= 'x' && c <= 'z') {
      ++at_;
      formula_.variables_ = std::max(formula_.variables_, c - 'x' + 1);
      return emit({Kind::variable, c - 'x'}, 1);
    }
    if (accept('(')) {
      const Term term = sum();
      if (!accept(')')) fail("')'");
      return term;
    }
    return emit({Kind::constant, 0, 0, number("a number, x, y, z or '('")}, 0);
  }
  double number(const char* what) {
    peek();
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) fail(what);
    at_ = std::size_t(end - text_.data());
    return value;
  }
  int exponent() {
    peek();
    int value = -1;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || value < 0 || value > kMaxDegree)
      fail(fmt::format("an exponent 0 .. {}", kMaxDegree));
    at_ = std::size_t(end - text_.data());
    return value;
  }
  /// By repeated squaring, which intervals bound tightly.
  Term raised(Term base, int n) {
    if (n == 0) return emit({Kind::constant, 0, 0, 1.0}, 0);
    if (n == 1) return base;
    const Term half = raised(base, n / 2);
    const Term even = emit({Kind::square, half.reg}, 2 * half.degree);
    return n % 2 == 0 ? even : emit({Kind::product, even.reg, base.reg}, even.degree + base.degree);
  }

  const std::string& text_;
  Formula& formula_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

Formula::Formula(const std::string& text) : text_(text) {
  const auto [value, degree] = Parser(text_, *this).parse();
  degree_ = degree;
  keep_operands_of(value);
}

void Formula::keep_operands_of(int value) {
  const auto operands = [](Operation& o) -> std::vector<int*> {
    if (o.kind == Kind::constant || o.kind == Kind::variable) return {};
    if (o.kind == Kind::scaled || o.kind == Kind::square) return {&o.left};
    return {&o.left, &o.right};
  };
  std::vector<bool> needed(operations_.size());
  needed[std::size_t(value)] = true;
  for (std::size_t i = operations_.size(); i-- > 0;)
    if (needed[i])
      for (const int* operand : operands(operations_[i])) needed[std::size_t(*operand)] = true;
  std::vector<int> kept(operations_.size());
  std::vector<Operation> result;
  for (std::size_t i = 0; i < operations_.size(); ++i) {
    if (!needed[i]) continue;
    for (int* operand : operands(operations_[i])) *operand = kept[std::size_t(*operand)];
    kept[i] = int(result.size());
    result.push_back(operations_[i]);
  }
  operations_ = std::move(result);
}

double Formula::magnitude(std::span<const double> magnitudes) const {
  std::vector<double> r(operations_.size());
  for (std::size_t i = 0; i < operations_.size(); ++i) {
    const Operation& o = operations_[i];
    const auto left = std::size_t(o.left), right = std::size_t(o.right);
    switch (o.kind) {
      case Kind::constant:
        r[i] = std::abs(o.number);
        break;
      case Kind::variable:
        r[i] = magnitudes[left];
        break;
      case Kind::sum:
      case Kind::difference:
        r[i] = r[left] + r[right];
        break;
      case Kind::product:
        r[i] = r[left] * r[right];
        break;
      case Kind::scaled:
        r[i] = r[left] * std::abs(o.number);
        break;
      case Kind::square:
        r[i] = r[left] * r[left];
        break;
    }
  }
  return r.back();
}

}  // namespace gridstep
