#include "torse/studies/autopsy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torse::studies {
namespace {

using Q = Rational;

constexpr double unit = 0x1p-53;
const double all_digits = 53 * std::log10(2.0);
constexpr std::size_t most_shown = 10;
constexpr int most_depth = 4;

Q magnitude(const Q& x) { return x.sign() < 0 ? -x : x; }

/// |value - exact| / |exact|; 0 where both are zero, 1 where exact alone is zero or nothing is finite.
double relative_error(const Operation& x) {
  if (!std::isfinite(x.value)) return 1;
  const Q error = magnitude(Q::from_double(x.value) - x.exact);
  if (error.sign() == 0) return 0;
  return x.exact.sign() == 0 ? 1 : std::min(1.0, (error / magnitude(x.exact)).to_double());
}

/// A record with what is derived from it.
class Reader {
 public:
  explicit Reader(const RecordScope& record) : record_(record) {
    for (const Operation& x : record.operations()) {
      errors_.push_back(relative_error(x));
      coordinates_.push_back(coordinate_bits(x));
      locals_.push_back(local_error(x));
    }
  }

  const Operation& at(int i) const { return record_.operations()[static_cast<std::size_t>(i)]; }
  double error(int i) const { return errors_[static_cast<std::size_t>(i)]; }
  /// value - (what the rounded operands give exactly).
  const Q& local(int i) const { return locals_[static_cast<std::size_t>(i)]; }

  Loss loss(int i) const {
    const Operation& x = at(i);
    Loss loss;
    if (x.place >= 0) loss.place = record_.places()[static_cast<std::size_t>(x.place)];
    loss.coordinate = coordinate_text(coordinates_[static_cast<std::size_t>(i)]);
    loss.kind = x.kind;
    loss.expression = expression(i, most_depth);
    loss.value = x.value;
    loss.exact = x.exact.to_double();
    loss.digits = digits_lost(i);
    if ((x.kind == '+' || x.kind == '-') && x.value != 0) {
      const double larger = std::max(std::abs(at(x.left).value), std::abs(at(x.right).value));
      loss.cancelled = std::max(0.0, std::log2(larger / std::abs(x.value)));
    } else if (x.kind == '+' || x.kind == '-') {
      loss.cancelled = x.exact.sign() == 0 ? 0 : std::numeric_limits<double>::digits;
    }
    if (x.value != 0) loss.local = std::abs((local(i) / Q::from_double(x.value)).to_double()) / unit;
    return loss;
  }

  /// log10 of the error over the operands' largest error, which counts as u at least: a rounded number is not better.
  double digits_lost(int i) const {
    const Operation& x = at(i);
    if (x.kind == '=' || x.kind == '#') return 0;
    double before = unit;
    for (const int operand : {x.left, x.right}) {
      if (operand >= 0) before = std::max(before, error(operand));
    }
    return error(i) > before ? std::log10(error(i) / before) : 0;
  }

 private:
  static unsigned coordinate_of_name(const std::string& name) {
    const std::size_t size = name.size();
    if (size < 2 || name[size - 2] != '.') return 0;
    const std::size_t index = std::string("xyzw").find(name.back());
    return index == std::string::npos ? 0 : 1U << index;
  }

  unsigned coordinate_bits(const Operation& x) const {
    if (x.kind == '=') return coordinate_of_name(x.name);
    unsigned bits = 0;
    for (const int operand : {x.left, x.right}) {
      if (operand >= 0) bits |= coordinates_[static_cast<std::size_t>(operand)];
    }
    return bits;
  }

  static std::string coordinate_text(unsigned bits) {
    for (const unsigned i : {0U, 1U, 2U, 3U}) {
      if (bits == 1U << i) return std::string(1, "xyzw"[i]);
    }
    return "";
  }

  Q local_error(const Operation& x) const {
    if (!std::isfinite(x.value) || x.kind == '#' || x.kind == 'n') return {};
    const Q value = Q::from_double(x.value);
    if (x.kind == '=') return value - x.exact;
    if (!std::isfinite(at(x.left).value) || !std::isfinite(at(x.right).value)) return {};
    const Q a = Q::from_double(at(x.left).value);
    const Q b = Q::from_double(at(x.right).value);
    switch (x.kind) {
      case '+':
        return value - (a + b);
      case '-':
        return value - (a - b);
      case '*':
        return value - a * b;
      default:
        return b.sign() == 0 ? Q() : value - a / b;
    }
  }

  /// As text; below `depth` levels only what is an input is written out.
  std::string expression(int i, int depth) const {
    const Operation& x = at(i);
    if (x.kind == '=') return x.name;
    if (x.kind == '#') return ScalarTraits<double>::text(x.value);
    if (depth == 0) return "...";
    if (x.kind == 'n') return "-" + expression(x.left, depth - 1);
    const auto trivial = [&](int operand, char kind, double value) {  // 0 + y, 1 * y
      return at(operand).kind == '#' && x.kind == kind && at(operand).value == value;
    };
    if (trivial(x.left, '+', 0) || trivial(x.left, '*', 1)) return expression(x.right, depth);
    if (trivial(x.right, '*', 1)) return expression(x.left, depth);
    const bool product = x.kind == '*' || x.kind == '/';
    const auto part = [&](int operand, bool last) {
      const std::string text = expression(operand, depth - 1);
      const char kind = at(operand).kind;
      const bool sum = kind == '+' || kind == '-' || kind == 'n';
      const bool enclosed = (sum && (product || last)) || (kind != '=' && kind != '#' && last && x.kind == '/');
      return enclosed && text != "..." ? "(" + text + ")" : text;
    };
    return part(x.left, false) + " " + x.kind + " " + part(x.right, true);
  }

  const RecordScope& record_;
  std::vector<double> errors_;
  std::vector<unsigned> coordinates_;
  std::vector<Q> locals_;
};

Outcome outcome_of(const Reader& reader, const Result& result) {
  const Operation& x = reader.at(result.number);
  const double error = reader.error(result.number);
  return {result.name, x.value, x.exact.to_double(),
          error == 0   ? all_digits
          : error >= 1 ? 0
                       : std::min(-std::log10(error), all_digits)};
}

/// d(result)/d(operation i) for all i, to first order in doubles.
std::vector<double> adjoints(const Reader& reader, int result) {
  std::vector<double> adjoint(static_cast<std::size_t>(result) + 1, 0.0);
  adjoint.back() = 1;
  for (int i = result; i >= 0; --i) {
    const Operation& x = reader.at(i);
    const double a = adjoint[static_cast<std::size_t>(i)];
    if (a == 0 || x.left < 0) continue;
    double& left = adjoint[static_cast<std::size_t>(x.left)];
    if (x.kind == 'n') {
      left -= a;
      continue;
    }
    const double l = reader.at(x.left).exact.to_double();
    const double r = reader.at(x.right).exact.to_double();
    left += a * (x.kind == '*' ? r : x.kind == '/' ? 1 / r : 1);
    double& right = adjoint[static_cast<std::size_t>(x.right)];
    right += a * (x.kind == '*' ? l : x.kind == '/' ? -l / (r * r) : x.kind == '-' ? -1 : 1);
  }
  return adjoint;
}

void add_makers(Autopsy& autopsy, const Reader& reader, int result) {
  const Operation& x = reader.at(result);
  if (!std::isfinite(x.value)) return;
  const double error = (Q::from_double(x.value) - x.exact).to_double();
  if (error == 0) return;
  const std::vector<double> adjoint = adjoints(reader, result);
  std::vector<std::pair<double, int>> shares;
  for (int i = 0; i <= result; ++i) {
    const double share = reader.local(i).to_double() * adjoint[static_cast<std::size_t>(i)] / error;
    if (share != 0 && std::isfinite(share)) shares.emplace_back(share, i);
  }
  std::ranges::stable_sort(shares, [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  shares.resize(std::min(shares.size(), most_shown));
  for (const auto& [share, i] : shares) {
    autopsy.made.push_back(reader.loss(i));
    autopsy.made.back().share = share;
  }
}

}  // namespace

Autopsy examine(const RecordScope& record, const std::vector<Result>& results) {
  if (results.empty()) throw InvalidInput("results", "expected at least one");
  const Reader reader(record);
  Autopsy autopsy;
  autopsy.operations = static_cast<std::size_t>(
      std::ranges::count_if(record.operations(), [](const Operation& x) { return x.kind != '=' && x.kind != '#'; }));
  const Result* worst = &results.front();
  for (const Result& result : results) {
    if (reader.error(result.number) > reader.error(worst->number)) worst = &result;
  }
  autopsy.worst = outcome_of(reader, *worst);
  add_makers(autopsy, reader, worst->number);

  std::vector<std::pair<double, int>> losses;
  for (int i = 0; i < static_cast<int>(record.operations().size()); ++i) {
    if (const double digits = reader.digits_lost(i); digits >= 1) losses.emplace_back(digits, i);
  }
  std::ranges::stable_sort(losses, [](const auto& a, const auto& b) { return a.first > b.first; });
  losses.resize(std::min(losses.size(), most_shown));
  for (const auto& [digits, i] : losses) autopsy.lost.push_back(reader.loss(i));
  return autopsy;
}

}  // namespace torse::studies
