#include "torse/fuzz/input_text.hpp"

#include <cstdio>

namespace torse::fuzz::detail {
namespace {

constexpr std::string_view digits = "0123456789abcdef";

}  // namespace

std::string hex_text(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += digits[value / 16];
    text += digits[value % 16];
  }
  return text;
}

std::string Field<double>::write(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "\"%a\"", x);
  return text;
}

std::string bytes_of(const Value& value) {
  const std::string& text = value.string();
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const std::size_t high = digits.find(text[i]);
    const std::size_t low = i + 1 < text.size() ? digits.find(text[i + 1]) : std::string_view::npos;
    if (high == std::string_view::npos || low == std::string_view::npos) {
      value.expected("pairs of the digits 0 to 9 and a to f");
    }
    bytes += static_cast<char>(high * 16 + low);
  }
  return bytes;
}

}  // namespace torse::fuzz::detail
