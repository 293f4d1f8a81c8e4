// The short proof finds the relation of every net that the linear construction makes (FJ07.13), for any knots, with
// weights and without, and none where one coordinate is off.
#include "torse/exact/decide/relation.hpp"

#include <gtest/gtest.h>

#include "torse/developable/linear_net.hpp"
#include "unit/developable/nets.hpp"

namespace torse::test {
namespace {

using Row = Vec<Q, 4>;

/// Which proper pieces have a short proof.
template <int D>
std::vector<bool> proved(const KnotList<Q>& u, const std::vector<Vec<Q, D>>& c, const std::vector<Vec<Q, D>>& d) {
  const std::vector<Integer> integers = integer_knots(u.list());
  RelationProver<D> prover(u.degree(), integers, c, d);
  std::vector<bool> result;
  for (int k : u.proper_pieces()) result.push_back(prover.prove(k));
  return result;
}

std::vector<bool> all_of(const KnotList<Q>& u) { return std::vector<bool>(u.proper_pieces().size(), true); }

/// The last vertex that acts on the last proper piece.
std::size_t last_vertex(const KnotList<Q>& u) {
  return static_cast<std::size_t>(u.proper_pieces().back() + u.degree() - 1);
}

TEST(IntegerKnots, BeginAtZeroWithoutACommonFactor) {
  const auto values_of = [](const std::vector<Rational>& u) {
    std::vector<Integer> found = integer_knots(u);
    std::vector<long> values;
    for (Integer& x : found) values.push_back(mpz_get_si(x.get()));
    return values;
  };
  EXPECT_EQ(values_of({Q(1) / Q(2), Q(5) / Q(2), Q(13) / Q(2)}), (std::vector<long>{0, 1, 3}));
  EXPECT_EQ(values_of({Q(-6), Q(-6), Q(0), Q(4)}), (std::vector<long>{0, 0, 3, 5}));
  EXPECT_EQ(values_of({Q(1) / Q(3), Q(1) / Q(2), Q(1)}), (std::vector<long>{0, 1, 4}));
}

TEST(RelationProver, ProvesLinearNets) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    std::vector<Point3> d = linear_net<Q, Point3>(u, c, Q(-7) / Q(3), Q(-1), point(3, 5, -7));
    EXPECT_EQ(proved<3>(u, c, d), all_of(u));
    if (u.degree() == 1) continue;  // two points of each rail have a relation where they are coplanar
    d[last_vertex(u)][1] += Q(1);
    EXPECT_FALSE(proved<3>(u, c, d).back());
  }
}

TEST(RelationProver, ProvesLinearNetsOfHomogeneousRows) {
  for (const KnotList<Q>& u : knot_lists()) {
    std::vector<Row> p;
    int weight = 1;
    for (const Point3& x : points(u.last() + 1)) p.push_back(Row(Q(++weight % 3 + 1), x[0], x[1], x[2]));
    std::vector<Row> q = linear_net<Q, Row>(u, p, Q(-7) / Q(3), Q(-1), Row(Q(2), Q(3), Q(5), Q(-7)));
    for (Row& row : q) scale(row, Q(3) / Q(5));
    EXPECT_EQ(proved<4>(u, p, q), all_of(u));
    if (u.degree() == 1) continue;
    q[last_vertex(u)][0] += Q(1);
    EXPECT_FALSE(proved<4>(u, p, q).back());
  }
}

/// Points moved by the prime keep the relation modulo it, which fails in the cells on either side. Pieces are asked for
/// out of order: what is known of cells 6 and later says nothing of the cells 3, 4, 5 before them.
TEST(RelationProver, ChecksTheCellsOfEveryPiece) {
  std::vector<Q> list;
  for (int i = 0; i < 14; ++i) list.emplace_back(i);
  const KnotList<Q> u(3, list);
  const std::vector<Point3> c = points(u.last() + 1);
  const std::vector<Point3> exact = linear_net<Q, Point3>(u, c, Q(-7) / Q(3), Q(-1), point(3, 5, -7));
  std::vector<Point3> d = exact;
  for (Point3* moved : {&d[4], &d[7]}) (*moved)[1] += Q(RelationProver<3>::prime);
  const std::vector<Integer> knots = integer_knots(u.list());
  RelationProver<3> prover(3, knots, c, d);
  for (const int k : {7, 4, 5, 3, 6, 2, 8}) EXPECT_FALSE(prover.prove(k)) << k;
  EXPECT_TRUE(prover.prove(1));  // cells 0, 1, 2
  EXPECT_TRUE(prover.prove(9));  // cells 8, 9, 10
  EXPECT_FALSE(prover.prove(8));
  RelationProver<3> backwards(3, knots, c, exact);
  for (int k = 9; k > 0; --k) EXPECT_TRUE(backwards.prove(k)) << k;
}

/// Pieces that share no cell: d = c + v before an n-fold knot and c + w behind it, but for the first cell there.
TEST(RelationProver, BeginsAnewBehindAKnotOfFullMultiplicity) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)});
  const std::vector<Point3> c = points(5);
  std::vector<Point3> d;
  for (std::size_t i = 0; i < 5; ++i) d.push_back(sum(c[i], i < 3 ? point(1, 5, 2) : point(3, -1, 1)));
  EXPECT_EQ(proved<3>(u, c, d), (std::vector<bool>{true, false}));
  d[2] = sum(c[2], point(3, -1, 1));
  EXPECT_EQ(proved<3>(u, c, d), (std::vector<bool>{false, true}));
}

}  // namespace
}  // namespace torse::test
