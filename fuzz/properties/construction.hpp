// construct: every construction of the library in every exact arithmetic.
#pragma once

#include "torse/fuzz/properties/constructions.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct Construction {
  struct In {
    ConstructionInput input{};
    std::string arithmetic{"Q"};
    int prime = 0;  ///< the seed of the prime and the lane of a batch

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("input", in.input);
      visit("arithmetic", in.arithmetic);
      visit("prime", in.prime);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

/// Throws Failed unless the surface is what the method promises, by plain/pieces.hpp.
void require_promise(const ConstructionInput& in, const SurfaceOver<Rational>& surface);

// The construction in one arithmetic: throws Failed unless the surface is `exact` and passes the test of developability
// there.
void require_in_cpp(const Construction::In& in, const SurfaceOver<Rational>& exact);
void require_in_prime_field(const Construction::In& in, const SurfaceOver<Rational>& exact);
void require_in_batch(const Construction::In& in, const SurfaceOver<Rational>& exact);
/// Whether balls decide all that the construction asks; where they do not there is no surface to compare.
bool hold_in_balls(const Construction::In& in, const SurfaceOver<Rational>& exact);

/// Drawn by itself for other properties too.
ConstructionInput draw_construction(Choices& choices, const Scale& scale, std::string_view method);

}  // namespace torse::fuzz
