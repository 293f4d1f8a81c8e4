// A problem of the comparison with the extracted programs, one line of text, and its answer.
//   Problem     `NAME KEY=VALUE ...`; numbers in a list are separated by commas, points by semicolons
//   Answer      the fractions or words of an answer, one after the other
#pragma once

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/spline/curve.hpp"

namespace torse::compare {

/// The parts of `text` between the separators; none for an empty text.
inline std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> list;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) list.push_back(part);
  return list;
}

/// The members of a line by their keys. A member that is not there is a std::out_of_range.
class Problem {
 public:
  explicit Problem(const std::string& line) {
    const std::vector<std::string> words = parts(line, ' ');
    name_ = words.at(0);
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t equals = words[i].find('=');
      members_.emplace(words[i].substr(0, equals), words[i].substr(equals + 1));
    }
  }

  const std::string& name() const { return name_; }
  int integer(const char* key) const { return std::stoi(members_.at(key)); }
  std::vector<std::string> words(const char* key) const { return parts(members_.at(key), ','); }
  Rational number(const char* key) const { return Rational::from_text(members_.at(key)); }
  std::vector<Rational> numbers(const char* key) const { return list(members_.at(key)); }

  template <int D>
  Vec<Rational, D> point(const char* key) const {
    return vector<D>(members_.at(key));
  }

  template <int D>
  std::vector<Vec<Rational, D>> points(const char* key) const {
    std::vector<Vec<Rational, D>> result;
    for (const std::string& part : parts(members_.at(key), ';')) result.push_back(vector<D>(part));
    return result;
  }

  /// The knots u of degree n, checked by the library.
  KnotList<Rational> knots() const { return KnotList<Rational>(integer("n"), numbers("u")); }

  /// The spline with the points `key` over them.
  template <int D>
  Spline<Rational, Vec<Rational, D>> spline(const char* key = "c") const {
    return {knots(), points<D>(key)};
  }

 private:
  static std::vector<Rational> list(const std::string& text) {
    std::vector<Rational> result;
    for (const std::string& part : parts(text, ',')) result.push_back(Rational::from_text(part));
    return result;
  }

  template <int D>
  static Vec<Rational, D> vector(const std::string& text) {
    const std::vector<Rational> coordinates = list(text);
    if (coordinates.size() != D) throw std::out_of_range("coordinates");
    Vec<Rational, D> point;
    for (int i = 0; i < D; ++i) point[i] = coordinates[static_cast<std::size_t>(i)];
    return point;
  }

  std::string name_;
  std::map<std::string, std::string> members_;
};

/// What the library gives: numbers, points, rows of points.
class Answer {
 public:
  Answer& operator<<(const std::string& word) {
    text_ += (text_.empty() ? "" : " ") + word;
    return *this;
  }
  Answer& operator<<(const Rational& x) { return *this << x.text(); }
  template <int D>
  Answer& operator<<(const Vec<Rational, D>& p) {
    for (int i = 0; i < D; ++i) *this << p[i];
    return *this;
  }
  template <class T>
  Answer& operator<<(const std::vector<T>& list) {
    for (const T& x : list) *this << x;
    return *this;
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace torse::compare
