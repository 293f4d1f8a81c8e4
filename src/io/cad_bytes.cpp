// One list of members for each type; a Writer and a Reader go through it.
#include "torse/io/cad_bytes.hpp"

#include <concepts>
#include <cstring>
#include <type_traits>

#include "torse/scalar/errors.hpp"

namespace torse {
namespace {

class Writer {
 public:
  static constexpr bool reads = false;
  void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  static constexpr bool reads = true;
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  void raw(void* data, std::size_t size) {
    if (size > bytes_.size()) throw Error("cad_model: expected more bytes");
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }
  /// Throws unless the rest can hold so many elements of at least one byte.
  void require(std::size_t size) const {
    if (size > bytes_.size()) throw Error("cad_model: expected more bytes");
  }
  bool done() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

template <class A, class... T>
void all(A& a, T&... members);

template <class A, class T>
requires(std::is_arithmetic_v<T> && !std::same_as<T, bool>) void pass(A& a, T& x) { a.raw(&x, sizeof x); }

/// A byte, since a bool in memory has no other values than 0 and 1.
template <class A>
void pass(A& a, bool& x) {
  unsigned char byte = x ? 1 : 0;
  a.raw(&byte, sizeof byte);
  if (byte > 1) throw Error("cad_model: expected 0 or 1");
  x = byte == 1;
}

template <class A, class T>
std::size_t pass_size(A& a, T& list) {
  std::size_t size = list.size();
  a.raw(&size, sizeof size);
  if constexpr (A::reads) a.require(size);
  return size;
}

template <class A>
void pass(A& a, std::string& text) {
  text.resize(pass_size(a, text));
  a.raw(text.data(), text.size());
}

/// A list grows as its elements are read: the bytes that promise many do not make room for them.
template <class A, class T>
void pass(A& a, std::vector<T>& list) {
  const std::size_t size = pass_size(a, list);
  for (std::size_t i = 0; i < size; ++i) {
    if constexpr (A::reads) list.emplace_back();
    all(a, list[i]);
  }
}

template <class A, class T, std::size_t N>
void pass(A& a, std::array<T, N>& list) {
  for (T& x : list) all(a, x);
}

template <class A, class T>
void pass(A& a, std::optional<T>& x) {
  bool there = x.has_value();
  all(a, there);
  if (!there) return;
  if constexpr (A::reads) x.emplace();
  all(a, *x);
}

template <class A, class... T>
void pass(A& a, std::variant<T...>& x) {
  std::size_t index = x.index();
  all(a, index);
  std::size_t at = 0;
  const auto choose = [&]<class U>(std::type_identity<U>) {
    if (at++ != index) return;
    if constexpr (A::reads) x.template emplace<U>();
    all(a, std::get<U>(x));
  };
  (choose(std::type_identity<T>{}), ...);
  if (index >= sizeof...(T)) throw Error("cad_model: expected the number of an alternative");
}

template <class A>
void pass(A& a, CadRange& x) {
  all(a, x.from, x.to);
}
template <class A>
void pass(A& a, CadRail& x) {
  all(a, x.degree, x.knots, x.points, x.weights, x.part, x.reversed);
}
template <class A>
void pass(A& a, CadRails& x) {
  all(a, x.c, x.d);
}
template <class A>
void pass(A& a, CadExtrusion& x) {
  all(a, x.c, x.vector, x.end);
}
template <class A>
void pass(A& a, CadMeridianEnd& x) {
  all(a, x.base, x.radius, x.height);
}
template <class A>
void pass(A& a, CadRevolution& x) {
  all(a, x.origin, x.axis, x.radial, x.meridian, x.turn);
}
template <class A>
void pass(A& a, CadStrip& x) {
  all(a, x.surface, x.along, x.across);
}
template <class A>
void pass(A& a, CadFace& x) {
  all(a, x.number, x.name, x.type, x.strips, x.reason, x.remark, x.claimed_developable, x.by_arc_length, x.trimmed,
      x.placement);
}
template <class A>
void pass(A& a, CadModel& x) {
  all(a, x.unit, x.metres, x.tolerance, x.faces);
}

template <class A>
void pass(A& a, CadCurve& x) {
  all(a, x.number, x.name, x.rail, x.reason, x.placement);
}
template <class A>
void pass(A& a, CadCurves& x) {
  all(a, x.unit, x.metres, x.tolerance, x.curves);
}

template <class A, class... T>
void all(A& a, T&... members) {
  (pass(a, members), ...);
}

template <class T>
std::string bytes_of(T copy) {
  Writer writer;
  all(writer, copy);
  return writer.take();
}

template <class T>
T from_bytes(std::string_view bytes) {
  Reader reader(bytes);
  T model;
  all(reader, model);
  if (!reader.done()) throw Error("cad_model: expected no more bytes");
  return model;
}

}  // namespace

std::string cad_bytes(const CadModel& model) { return bytes_of(model); }

std::string cad_bytes(const CadCurves& curves) { return bytes_of(curves); }

CadModel cad_model(std::string_view bytes) { return from_bytes<CadModel>(bytes); }

CadCurves cad_curves(std::string_view bytes) { return from_bytes<CadCurves>(bytes); }

}  // namespace torse
