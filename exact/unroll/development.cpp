// Steps, halved until the rails are close to their chords.
#include "torse/exact/unroll/development.hpp"

#include <optional>
#include <string>
#include <utility>

#include "torse/exact/unroll/taylor.hpp"

namespace torse {
namespace {

using Q = Rational;
using arb::Complex;
using arb::Real;

/// A step that is shorter than 2^-deepest of its stretch does not get better.
constexpr int deepest = 300;

/// The chain of stations as it grows.
class Chain {
 public:
  Chain(double tolerance, std::size_t most) : tolerance_(tolerance), most_(most) {}

  void start(const Stretch& stretch, const Q& t) {
    arb_const_pi(angle_.get(), stretch.bits());
    arb_mul_2exp_si(angle_.get(), angle_.get(), -1);
    Station first{t, {}, {}, {}, {}, {}};
    place_end(first, stretch, Q(0));
    stations_.push_back(std::move(first));
  }

  void advance(const PieceStrip& strip, const Stretch& stretch) {
    if (stretch.breaking()) {
      const Step step = breaking_step(stretch);
      keep(step, stationed(strip, stretch, stretch.to(), step));
    } else {
      advance(strip, stretch, stretch.from(), stretch.to(), 0);
    }
  }

  std::vector<Station> take() { return std::move(stations_); }

 private:
  void advance(const PieceStrip& strip, const Stretch& stretch, const Q& from, const Q& to, int depth) {
    if (const std::optional<Step> step = taylor_step(stretch, from, to)) {
      Station next = stationed(strip, stretch, to, *step);
      if (close(*step, next)) return keep(*step, std::move(next));
    }
    if (stations_.size() >= most_) {
      throw InvalidInput("tolerance", "more than " + std::to_string(most_) + " rulings do not reach it");
    }
    if (depth == deepest) {
      throw InvalidInput("tolerance", "rulings however near do not reach it in the piece from " + as_text(strip.begin) +
                                          " to " + as_text(strip.end));
    }
    const Q middle = (from + to) / Q(2);
    advance(strip, stretch, from, middle, depth + 1);
    advance(strip, stretch, middle, to, depth + 1);
  }

  bool close(const Step& step, const Station& next) const {
    Complex chord;
    acb_sub(chord.get(), next.q.get(), stations_.back().q.get(), 256);
    return sagitta(step.length_c, step.chord) <= tolerance_ && sagitta(step.length_d, chord) <= tolerance_;
  }

  static Complex direction(const Real& angle, slong bits) {
    Complex z;
    arb_sin_cos(acb_imagref(z.get()), acb_realref(z.get()), angle.get(), bits);
    return z;
  }

  /// Q = P + |D - C| u.
  void place_end(Station& station, const Stretch& stretch, const Q& tau, const Real& angle) const {
    Complex w = direction(angle, stretch.bits());
    acb_mul_arb(w.get(), w.get(), stretch.ruling(tau).get(), stretch.bits());
    acb_add(station.q.get(), station.p.get(), w.get(), stretch.bits());
  }

  void place_end(Station& station, const Stretch& stretch, const Q& tau) const {
    place_end(station, stretch, tau, angle_);
  }

  Real turned(const Step& step, slong bits) const {
    Real angle;
    arb_sub(angle.get(), angle_.get(), step.turn.get(), bits);
    return angle;
  }

  /// The station after a step.
  Station stationed(const PieceStrip& strip, const Stretch& stretch, const Q& tau, const Step& step) const {
    const Station& last = stations_.back();
    const slong bits = stretch.bits();
    Station next{
        strip.begin + tau * (strip.end - strip.begin), step.chord, {}, last.length_c, last.length_d, last.area};
    acb_mul(next.p.get(), next.p.get(), direction(angle_, bits).get(), bits);
    acb_add(next.p.get(), next.p.get(), last.p.get(), bits);
    arb_add(next.length_c.get(), next.length_c.get(), step.length_c.get(), bits);
    arb_add(next.length_d.get(), next.length_d.get(), step.length_d.get(), bits);
    arb_add(next.area.get(), next.area.get(), step.area.get(), bits);
    place_end(next, stretch, tau, turned(step, bits));
    return next;
  }

  void keep(const Step& step, Station next) {
    angle_ = turned(step, 512);
    stations_.push_back(std::move(next));
  }

  double tolerance_;
  std::size_t most_;
  Real angle_;
  std::vector<Station> stations_;
};

}  // namespace

double sagitta(const Real& length, const Complex& chord) {
  constexpr slong bits = 256;
  Real square;
  Real distance;
  arb_mul(square.get(), length.get(), length.get(), bits);
  acb_abs(distance.get(), chord.get(), bits);
  arb_submul(square.get(), distance.get(), distance.get(), bits);
  const double upper = arb::enclosure(square).upper();
  return upper > 0 ? upper_root(upper) / 2 : 0;
}

std::vector<Station> develop(const std::vector<PieceStrip>& strips, const std::vector<Rational>& marks,
                             double tolerance, std::size_t most) {
  Chain chain(tolerance, most);
  bool started = false;
  for (const PieceStrip& strip : strips) {
    for (const Stretch& stretch : stretches(strip, marks)) {
      if (!std::exchange(started, true)) chain.start(stretch, strip.begin);
      chain.advance(strip, stretch);
    }
  }
  return chain.take();
}

}  // namespace torse
