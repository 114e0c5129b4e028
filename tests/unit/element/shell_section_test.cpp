// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "element/shell4.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "support/shell_bench.hpp"

using namespace brunt;
using element::ShellSection;
using element::ThicknessPoints;
using element::ThicknessRule;
using test::ShellBench;

namespace {

double integral_of_power(const ThicknessPoints& rule, int power) {
  double sum = 0;
  for (int k = 0; k < rule.count; ++k) sum += rule.weight[k] * std::pow(rule.at[k], power);
  return sum;
}
const ThicknessPoints& rule(ThicknessRule kind, int points) {
  ShellSection section;
  section.rule = kind;
  section.points = points;
  return element::thickness_points(section);
}

using Field = Eigen::Matrix<double, 3, 4>;
using J2 = material::J2Response<false, false>;

/// Ideally plastic, E = 1000, nu = 0, so that bending about one axis is that of a beam.
template <class Response>
ShellBench<element::Shell4<Response>> strip(int points) {
  ShellSection section;
  section.thickness = 0.1;
  section.points = points;
  section.thinning = false;
  material::J2 constants;
  constants.density = 1;
  constants.young = 1000;
  constants.yield = 1;
  Field x;
  x << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  if constexpr (std::is_same_v<Response, J2>)
    return {{J2(constants), section, {}}, x, 1};
  else
    return {{Response({1, 1000, 0.3}), section, {}}, x, 1};
}

}  // namespace

TEST_CASE("rules through the thickness are exact for the powers they promise") {
  for (int n = 1; n <= ShellSection::most_points; ++n)
    for (const ThicknessRule kind : {ThicknessRule::gauss, ThicknessRule::lobatto}) {
      const ThicknessPoints& r = rule(kind, n);
      CHECK(r.count == n);
      const int exact = kind == ThicknessRule::gauss || n == 1 ? 2 * n - 1 : 2 * n - 3;
      for (int power = 0; power <= exact; ++power)
        CHECK(integral_of_power(r, power) ==
              Approx(power % 2 ? 0 : std::pow(0.5, power) / (power + 1)).epsilon(1e-13).margin(1e-15));
      CHECK(std::abs(integral_of_power(r, exact + 1) - std::pow(0.5, exact + 1) / (exact + 2)) > 1e-13);
      if (n > 1 && kind == ThicknessRule::lobatto) CHECK((r.at[0] == -0.5 && r.at[n - 1] == 0.5));
    }
  CHECK(rule(ThicknessRule::gauss, 2).at[1] == Approx(0.5 / std::sqrt(3.0)).epsilon(1e-15));
  CHECK(rule(ThicknessRule::lobatto, 3).weight[1] == Approx(2.0 / 3).epsilon(1e-15));
  CHECK(rule(ThicknessRule::gauss, 1).second == 0);
}

TEST_CASE("the thickness follows the normal strain: of elastic uniaxial strain by -nu/(1 - nu), of flow by volume") {
  auto elastic = strip<material::ElasticResponse>(3);
  elastic.kernel.section.thinning = true;
  Field x;
  x << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  Field v = Field::Zero();
  double log_strain = 0;
  const auto pull = [&](auto& bench, int steps) {
    for (int step = 0; step < steps; ++step) {
      v(0, 1) = v(0, 2) = 1e-3;
      const double before = x(0, 1);
      x += v;
      log_strain += std::log(x(0, 1) / before);
      bench.move(x, v, Field::Zero());
    }
  };
  pull(elastic, 100);
  CHECK(elastic.history[2][0] == Approx(0.1 * std::exp(-0.3 / 0.7 * log_strain)).epsilon(1e-5));
  auto plastic = strip<J2>(3);
  plastic.kernel.section.thinning = true;
  x(0, 1) = x(0, 2) = 1;
  log_strain = 0;
  pull(plastic, 500);
  CHECK(plastic.history[2][0] * x(0, 1) == Approx(0.1).epsilon(2e-3));  // elastic strains are 1e-3
}

// Plane strain across (nu = 0, elastic): the yield moment h^2/6 Y grows to the limit moment h^2/4 2/sqrt(3) Y.
TEST_CASE("an ideally plastic section reaches its limit moment") {
  for (const int points : {5, 10}) {
    auto bench = strip<J2>(points);
    Field x, r = Field::Zero();
    x << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
    r.row(1) << -1e-3, 1e-3, 1e-3, -1e-3;
    double moment = 0;
    for (int step = 0; step < 600; ++step) {
      const auto answer = bench.move(x, Field::Zero(), r);
      moment = -answer.moment(1, 1) - answer.moment(1, 2);
    }
    double lever = 0;  // of the rule; in the limit of many points 1/4
    const ThicknessPoints& points_of_rule = element::thickness_points(bench.kernel.section);
    for (int k = 0; k < points; ++k) lever += points_of_rule.weight[k] * std::abs(points_of_rule.at[k]);
    CHECK(lever == Approx(0.25).epsilon(points == 10 ? 0.012 : 0.06));
    CHECK(moment == Approx(0.1 * 0.1 * lever * 2 / std::sqrt(3.0)).epsilon(1e-3));
  }
}
