// IGES files written by hand.
//   IgesText       collects entities; `file` is the whole text in lines of 80 columns       text      their names
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace torse::testing {

/// The name of an entity, or another whole number, as a parameter.
inline std::string text(int number) { return std::to_string(number); }

/// Entities are named by the number of their directory entry, as the format has it.
class IgesText {
 public:
  /// `unit` is IGES's flag: 1 inch, 2 mm, 6 m, and others, but not 3.
  explicit IgesText(int unit = 2) : unit_(unit) {}

  struct Extra {
    int form = 0;
    std::string label{};
    int matrix = 0;
    bool dependent = false;
  };

  /// Adds an entity with its parameters, such as "0.,0.,0.,1.,0.,0." for a line, and returns its name.
  int add(int type, const std::string& parameters) { return add(type, parameters, Extra()); }
  int add(int type, const std::string& parameters, const Extra& extra) {
    const int name = static_cast<int>(directory_.size()) + 1;
    const int first = static_cast<int>(parameters_.size()) + 1;
    std::string text = std::to_string(type) + "," + parameters + ";";
    int lines = 0;
    while (!text.empty()) {
      std::size_t size = text.size() <= 64 ? text.size() : text.rfind(',', 63) + 1;
      parameters_.push_back(padded(text.substr(0, size), 64) + field(name));
      text.erase(0, size);
      ++lines;
    }
    directory_.push_back(field(type) + field(first) + field(0) + field(0) + field(0) + field(0) + field(extra.matrix) +
                         field(0) + (extra.dependent ? "00010000" : "00000000"));
    directory_.push_back(field(type) + field(0) + field(0) + field(lines) + field(extra.form) + field(0) + field(0) +
                         padded(extra.label, 8, true) + field(0));
    return name;
  }

  int line(const std::string& from, const std::string& to) { return add(110, from + "," + to, {.dependent = true}); }
  /// Entity 126 of one clamped piece on [0, 1]; `points` are "x,y,z,..." and `weights` as many numbers.
  int bezier(int degree, const std::string& weights, const std::string& points) {
    std::string knots;
    for (int i = 0; i <= degree; ++i) knots += "0.,";
    for (int i = 0; i <= degree; ++i) knots += "1.,";
    const std::string n = std::to_string(degree);
    return add(126, n + "," + n + ",0,0,0,0," + knots + weights + "," + points + ",0.,1.,0.,0.,0.",
               {.dependent = true});
  }
  /// Entity 118 between two curves.
  int ruled(int c, int d, int reversed, int developable, const Extra& extra) {
    return add(118,
               std::to_string(c) + "," + std::to_string(d) + "," + std::to_string(reversed) + "," +
                   std::to_string(developable),
               extra);
  }

  std::string file() const {
    const std::string units[] = {"",    "2HIN", "2HMM",  "",     "2HFT", "2HMI",
                                 "1HM", "2HKM", "3HMIL", "2HUM", "2HCM", "3HUIN"};
    const std::string global = "1H,,1H;,4Hpart,8Hpart.igs,5Htorse,5Htorse,32,38,6,308,15,4Hpart,1.," +
                               std::to_string(unit_) + "," + units[unit_] +
                               ",1,0.01,15H20260101.000000,1.E-05,1000.,5Htorse,5Htorse,11,0,15H20260101.000000;";
    std::vector<std::string> globals;
    for (std::size_t at = 0; at < global.size(); at += 72) globals.push_back(padded(global.substr(at, 72), 72));
    std::string text;
    const auto section = [&](char letter, const std::vector<std::string>& lines) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        char tail[16];
        std::snprintf(tail, sizeof tail, "%c%7d\n", letter, static_cast<int>(i) + 1);
        text += padded(lines[i], 72) + tail;
      }
      char count[16];
      std::snprintf(count, sizeof count, "%c%7d", letter, static_cast<int>(lines.size()));
      return std::string(count);
    };
    std::string last = section('S', {"A part."});
    last += section('G', globals);
    last += section('D', directory_);
    last += section('P', parameters_);
    section('T', {last});
    return text;
  }

 private:
  static std::string field(int x) {
    char text[16];
    std::snprintf(text, sizeof text, "%8d", x);
    return text;
  }
  static std::string padded(const std::string& text, std::size_t width, bool right = false) {
    const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
    return right ? blanks + text : text + blanks;
  }

  int unit_;
  std::vector<std::string> directory_;
  std::vector<std::string> parameters_;
};

}  // namespace torse::testing
