// Joints are the control points of n-fold knots.
#include "torse/exact/repair/segments.hpp"

namespace torse::repair {

std::vector<Segment> segments_of(const KnotList<Rational>& u) {
  const int n = u.degree();
  std::vector<int> ends;
  for (int i = 1; i < u.last(); ++i) {
    const bool inside = u.domain_begin() < u[i] && u[i] < u.domain_end();
    if (inside && u[i] == u[i + n - 1]) ends.push_back(i);
  }
  ends.push_back(u.last());
  std::vector<Segment> segments;
  int begin = 0;
  for (const int end : ends) {
    const auto first = u.list().begin() + begin;
    segments.push_back({begin, end, KnotList<Rational>(n, {first, first + (end - begin + n)})});
    begin = end;
  }
  return segments;
}

template <int D>
RealNet<D> part_of(const RealNet<D>& net, const Segment& segment) {
  RealNet<D> part;
  for (std::size_t i = 2 * static_cast<std::size_t>(segment.begin); i < 2 * static_cast<std::size_t>(segment.end) + 2;
       ++i) {
    part.points.push_back(net.points[i]);
    part.scale.push_back(net.scale[i]);
  }
  return part;
}

template RealNet<3> part_of<3>(const RealNet<3>&, const Segment&);
template RealNet<4> part_of<4>(const RealNet<4>&, const Segment&);

}  // namespace torse::repair
