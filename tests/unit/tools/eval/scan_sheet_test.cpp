#include "tools/eval/scan_sheet.hpp"

#include <regex>

#include <gmock/gmock.h>

#include "tests/support/scene.hpp"
#include "tests/unit/tools/eval/findings.hpp"

namespace perceptor {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using testing::HandMade;
using ::testing::HasSubstr;
using ::testing::Lt;
using ::testing::Not;
using ::testing::SizeIs;

std::ptrdiff_t count(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return std::distance(std::sregex_iterator(text.begin(), text.end(), expression),
                       std::sregex_iterator());
}

std::string panel(const HandMade& made, const std::vector<Vector2>& footprint = {}) {
  return scan_panel(made.findings(), footprint, 0.0, 0.0);
}

void add_corner(HandMade& made, CornerMethod method, PointProperty property) {
  scan::Corner corner;
  corner.method = method;
  corner.property = property;
  corner.place = {{2.0, 0.5}, Eigen::Matrix2d::Zero()};
  made.found.corners.push_back(corner);
}

TEST(PanelView, ShowsForwardUpAndLeftToTheLeft) {
  const PanelView view{.centre = {1.0, 0.0}, .half = 2.0};
  EXPECT_EQ(view.to_panel({1.0, 0.0}), Vector2(200.0, 200.0));
  EXPECT_EQ(view.to_panel({3.0, 0.0}), Vector2(200.0, 0.0));
  EXPECT_EQ(view.to_panel({1.0, 2.0}), Vector2(0.0, 200.0));
}

TEST(PanelView, FewFarReturnsDoNotShrinkIt) {
  const test::Scene scene = test::room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  LaserScan scan = test::sweep(scene, test::pico_laser());
  const PanelView whole = view_of(scan);
  EXPECT_GT(whole.half, 2.0);
  EXPECT_LT(whole.half, 2.5);
  for (std::size_t i = 300; i < 320; ++i) scan.ranges[i] = 9.0;
  EXPECT_LT(view_of(scan).half, 2.5);
}

TEST(PanelView, AScanWithoutReturnsHasOne) { EXPECT_GT(view_of(LaserScan()).half, 0.0); }

TEST(ScanPanel, HasALineForEachWallAndAPointForEachReturn) {
  HandMade made;
  made.found.walls.push_back(made.found.walls[0]);
  const std::string svg = panel(made);
  EXPECT_EQ(count(svg, "<line class=\"wall\""), 2);
  EXPECT_EQ(count(svg, "<line class=\"end\""), 4);
  EXPECT_EQ(count(svg, "class=\"number\""), 2);
  EXPECT_EQ(count(svg, "M[-0-9. ]+h0"), 4);
  EXPECT_EQ(count(svg, "class=\"used\" d=\"(M[-0-9. ]+h0){3}\""), 1);
  EXPECT_EQ(count(svg, "class=\"unused\" d=\"(M[-0-9. ]+h0){1}\""), 1);
  EXPECT_THAT(svg, HasSubstr(">12</text>"));
  EXPECT_THAT(svg, HasSubstr(">1 m</text>"));
}

TEST(ScanPanel, DrawsWhereThingsAre) {
  // From the robot to x = 2.25 and y = 1.09: 2.25 m, and a margin, in 400 px.
  const HandMade made;
  const PanelView view = view_of(made.labelled.scan);
  const Vector2 first = view.to_panel({2.0, -0.5});
  char line[80];
  std::snprintf(line, sizeof line, "x1=\"%.1f\" y1=\"%.1f\"", first.x(), first.y());
  EXPECT_THAT(panel(made), HasSubstr(line));
  for (const Vector2& shown : {Vector2(2.0, -0.5), Vector2(2.0, 0.5), Vector2(0.0, 0.0)})
    EXPECT_THAT(view.to_panel(shown), AllOf(Each(Lt(kPanelSize)), Each(::testing::Gt(0.0))));
}

TEST(ScanPanel, MarksCornersByHowTheyWereSeen) {
  HandMade made;
  add_corner(made, CornerMethod::intersection, PointProperty::concave);
  add_corner(made, CornerMethod::intersection, PointProperty::convex);
  add_corner(made, CornerMethod::spike, PointProperty::convex);
  add_corner(made, CornerMethod::vector, PointProperty::floating);
  const std::string svg = panel(made);
  EXPECT_EQ(count(svg, "<circle class=\"concave filled\""), 1);
  EXPECT_EQ(count(svg, "<circle class=\"convex filled\""), 1);
  EXPECT_EQ(count(svg, "<circle class=\"convex\""), 1);
  EXPECT_EQ(count(svg, "<rect class=\"floating\""), 1);
}

TEST(ScanPanel, DrawsTheFootprintWhereThereIsOne) {
  EXPECT_EQ(count(panel(HandMade()), "<polygon"), 1);
  EXPECT_EQ(count(panel(HandMade(), {{0.2, 0.2}, {-0.2, 0.2}, {0.0, -0.2}}), "<polygon"), 2);
}

TEST(ScanPanel, ASmallScaleHasALongerBar) {
  HandMade made;
  made.labelled.scan.ranges = {50.0, 50.0, 50.0, 50.0, 50.0};
  EXPECT_THAT(panel(made), HasSubstr(">10 m</text>"));
}

TEST(ScanSheet, SpreadsSomePanelsEvenly) {
  EXPECT_THAT(scans_of_sheet(3, {}), ElementsAre(0, 1, 2));
  EXPECT_THAT(scans_of_sheet(1, {}), ElementsAre(0));
  EXPECT_THAT(scans_of_sheet(0, {}), SizeIs(0));
  const auto chosen = scans_of_sheet(1051, {});
  EXPECT_THAT(chosen, SizeIs(24));
  EXPECT_EQ(chosen.front(), 0U);
  EXPECT_EQ(chosen[1], 45U);
  EXPECT_EQ(chosen.back(), 1050U);
}

TEST(ScanSheet, TakesEachNthScan) {
  EXPECT_THAT(scans_of_sheet(7, 3), ElementsAre(0, 3, 6));
  EXPECT_THAT(scans_of_sheet(2, 3), ElementsAre(0));
}

TEST(ScanSheet, HasATitleAndAPanelForEachScan) {
  const HandMade made;
  ScanSheet sheet({});
  for (int i = 0; i < 7; ++i) sheet.add(made.findings());
  const std::string svg = sheet.document({"a<b & c.scan", "some_method", 0.005, 0.005});
  EXPECT_EQ(count(svg, "<svg "), 8);
  EXPECT_EQ(count(svg, "<svg "), count(svg, "</svg>"));
  EXPECT_THAT(svg, HasSubstr("a&lt;b &amp; c.scan, some_method, sigma 5.0 mm"));
  EXPECT_THAT(svg, HasSubstr("<svg x=\"2000.0\" y=\"56.0\""));
  EXPECT_THAT(svg, HasSubstr("<svg x=\"0.0\" y=\"456.0\""));
  EXPECT_THAT(svg, Not(HasSubstr("<svg x=\"400.0\" y=\"456.0\"")));
}

TEST(ScanSheet, ASetOfSeveralLasersHasTwoSigmas) {
  EXPECT_THAT(ScanSheet({}).document({"f", "m", 0.005, 0.02}), HasSubstr("sigma 5.0 to 20.0 mm"));
}

}  // namespace
}  // namespace perceptor
