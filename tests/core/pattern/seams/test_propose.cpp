// Which seams are proposed for garments whose true seams are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

#include "core/pattern/seams/check.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/propose.h"
#include "core/pattern/validate.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using garments::Garment;
using EdgeSet = std::set<std::pair<std::string, std::string>>;
using SeamKey = std::pair<EdgeSet, EdgeSet>;

struct Score {
  int known = 0, proposed = 0, correct = 0;
  double precision() const { return proposed == 0 ? 1 : static_cast<double>(correct) / proposed; }
  double recall() const { return static_cast<double>(correct) / known; }
};

SeamKey ordered(EdgeSet a, EdgeSet b) { return a < b ? SeamKey(a, b) : SeamKey(b, a); }

SeamKey key_of(const pattern::Pattern& pattern, const pattern::Seam& seam) {
  const auto side = [&](const std::vector<pattern::SeamEdge>& edges) {
    EdgeSet set;
    for (const pattern::SeamEdge& e : edges) {
      const pattern::Panel& panel = pattern.panels[e.panel];
      set.insert({panel.id, panel.outline.edges[e.edge].id});
    }
    return set;
  };
  return ordered(side(seam.a), side(seam.b));
}

std::set<SeamKey> keys_of(const Garment::Seams& seams) {
  const auto side = [](const std::vector<garments::Side>& sides) {
    EdgeSet set;
    for (const auto& s : sides)
      for (const std::string& e : s.edges) set.insert({s.piece, e});
    return set;
  };
  std::set<SeamKey> truth;
  for (const auto& [a, b] : seams) truth.insert(ordered(side(a), side(b)));
  return truth;
}

pattern::Pattern pattern_of(const Garment& g) { return {g.panels, {}}; }

Score score_of(const Garment& g, const pattern::Pattern& pattern, bool sides_known,
               const std::string& variant) {
  std::set<SeamKey> truth = keys_of(g.seams);
  Score score;
  score.known = static_cast<int>(truth.size());
  truth.merge(keys_of(g.as_good));
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {sides_known})) {
    if (p.confidence < 0.8) continue;
    ++score.proposed;
    score.correct += truth.contains(key_of(pattern, p.seam));
  }
  std::printf("%-18s %-10s panels %zu true %d proposed %d correct %d precision %.2f recall %.2f\n",
              g.name.c_str(), variant.c_str(), g.panels.size(), score.known, score.proposed, score.correct,
              score.precision(), score.recall());
  return score;
}

Score sum(const std::vector<Score>& scores) {
  Score all;
  for (const Score& s : scores) {
    all.known += s.known;
    all.proposed += s.proposed;
    all.correct += s.correct;
  }
  return all;
}

TEST(ProposeSeams, FindsTheSeamsOfGarmentsDrawnByCode) {
  std::vector<Score> scores;
  for (const Garment& g : garments::all()) {
    ASSERT_TRUE(pattern::validate(pattern_of(g)).ok())
        << g.name << ": " << to_string(pattern::validate(pattern_of(g)).error());
    scores.push_back(score_of(g, pattern_of(g), true, "as drawn"));
  }
  EXPECT_GE(sum(scores).precision(), 0.95);
  EXPECT_GE(sum(scores).recall(), 0.85);
}

TEST(ProposeSeams, FindThemWhenPiecesAreTurnedWithTheirGrain) {
  std::vector<Score> scores;
  for (Garment g : garments::all()) {
    for (std::size_t p = 0; p < g.panels.size(); ++p)
      g.panels[p] = garments::turned(g.panels[p], 0.7 + 1.9 * static_cast<double>(p));
    scores.push_back(score_of(g, pattern_of(g), true, "turned"));
  }
  EXPECT_GE(sum(scores).precision(), 0.95);
  EXPECT_GE(sum(scores).recall(), 0.85);
}

TEST(ProposeSeams, FindThemWhenAllIsMirrored) {
  std::vector<Score> scores;
  for (Garment g : garments::all()) {
    for (pattern::Panel& panel : g.panels) panel = garments::mirrored(panel, panel.id);
    scores.push_back(score_of(g, pattern_of(g), true, "mirrored"));
  }
  EXPECT_GE(sum(scores).precision(), 0.95);
  EXPECT_GE(sum(scores).recall(), 0.85);
}

TEST(ProposeSeams, FindThemWithoutHelpfulNames) {
  std::vector<Score> scores;
  for (Garment g : garments::all()) {
    std::map<std::string, std::string> names;
    for (std::size_t p = 0; p < g.panels.size(); ++p) {
      const std::string name = "piece" + std::to_string(p);
      names[g.panels[p].id] = name;
      g.panels[p].id = name;
    }
    for (Garment::Seams* seams : {&g.seams, &g.as_good})
      for (auto& seam : *seams)
        for (auto* sides : {&seam.first, &seam.second})
          for (garments::Side& side : *sides) side.piece = names[side.piece];
    scores.push_back(score_of(g, pattern_of(g), true, "nameless"));
  }
  EXPECT_GE(sum(scores).precision(), 0.95);
  EXPECT_GE(sum(scores).recall(), 0.75) << "without names less is sure, and what is sure is right";
}

/// What is proposed for the pieces in another order, by names.
std::map<SeamKey, double> confidences(const Garment& g, const std::vector<std::size_t>& order) {
  pattern::Pattern pattern;
  for (const std::size_t i : order) pattern.panels.push_back(g.panels[i]);
  std::map<SeamKey, double> found;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern))
    found[key_of(pattern, p.seam)] = p.confidence;
  return found;
}

TEST(ProposeSeams, DoNotDependOnTheOrderOfThePieces) {
  for (const Garment& g : {garments::trousers(), garments::hooded_top()}) {
    std::vector<std::size_t> order(g.panels.size());
    std::iota(order.begin(), order.end(), 0u);
    const std::map<SeamKey, double> as_drawn = confidences(g, order);
    EXPECT_GE(as_drawn.size(), 6u);
    std::rotate(order.begin(), order.begin() + 1, order.end());
    std::reverse(order.begin() + 1, order.end());
    EXPECT_EQ(confidences(g, order), as_drawn) << g.name;
  }
}

TEST(ProposeSeams, SewAFrontsBustDartAgainstASmoothBack) {
  // The side of each front is parted by a dart; closed, it is as long as the back's.
  const pattern::Panel front = garments::piece("front_r", {{0, 0},
                                                           {240, 0},
                                                           {248, 250},
                                                           {120, 262},
                                                           {246, 290},
                                                           {250, 400, Vec2{185, 440}},
                                                           {190, 600},
                                                           {80, 640, Vec2{10, 550}},
                                                           {0, 520}});
  const pattern::Panel back = garments::piece("back", {{-240, 0},
                                                       {240, 0},
                                                       {250, 360, Vec2{195, 400}},
                                                       {190, 560},
                                                       {80, 600, Vec2{0, 560}},
                                                       {-80, 600},
                                                       {-190, 560, Vec2{-195, 400}},
                                                       {-250, 360}});
  const pattern::Pattern pattern{{front, garments::mirrored(front, "front_l"), back}, {}};
  ASSERT_TRUE(pattern::validate(pattern)) << to_string(pattern::validate(pattern).error());
  std::set<SeamKey> sure;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern))
    if (p.confidence >= 0.8) sure.insert(key_of(pattern, p.seam));
  for (const std::string id : {"front_r", "front_l"}) {
    EXPECT_TRUE(sure.contains(ordered({{id, "e2"}}, {{id, "e3"}}))) << "the dart";
    const SeamKey right = ordered({{id, "e1"}, {id, "e4"}}, {{"back", "e1"}});
    const SeamKey left = ordered({{id, "e1"}, {id, "e4"}}, {{"back", "e7"}});
    EXPECT_TRUE(sure.contains(right) || sure.contains(left)) << id;
  }
}

TEST(ProposeSeams, LeaveNamelessPiecesOfUnknownSidesToAPerson) {
  Garment g = garments::shirt();
  const std::map<SeamKey, double> named = confidences(g, {0, 1, 2, 3});
  EXPECT_TRUE(std::any_of(named.begin(), named.end(), [](const auto& one) { return one.second >= 0.8; }));
  for (std::size_t p = 0; p < g.panels.size(); ++p) g.panels[p].id = "p" + std::to_string(p);
  const std::map<SeamKey, double> nameless = confidences(g, {0, 1, 2, 3});
  EXPECT_GE(nameless.size(), 4u) << "they are proposed all the same";
  for (const auto& [key, confidence] : nameless) EXPECT_LT(confidence, 0.8);
}

/// The key with the garment's name before its pieces'.
SeamKey in_garment(const Garment& g, const SeamKey& key) {
  const auto named = [&](const EdgeSet& side) {
    EdgeSet set;
    for (const auto& [piece, edge] : side) set.insert({g.name + " " + piece, edge});
    return set;
  };
  return ordered(named(key.first), named(key.second));
}

TEST(ProposeSeams, AreSureInAWardrobeOnlyOfTrueSeamsWithinAGarment) {
  pattern::Pattern wardrobe;
  std::set<SeamKey> truth;
  for (const Garment& g : garments::all()) {
    for (const auto* seams : {&g.seams, &g.as_good})
      for (const SeamKey& key : keys_of(*seams)) truth.insert(in_garment(g, key));
    for (pattern::Panel panel : g.panels) {
      panel.id = g.name + " " + panel.id;
      wardrobe.panels.push_back(std::move(panel));
    }
  }
  const std::vector<seams::SeamProposal> proposals = seams::propose_seams(wardrobe);
  EXPECT_GE(proposals.size(), 20u);
  for (const seams::SeamProposal& p : proposals) {
    if (p.confidence < 0.8) continue;
    std::string edges;
    for (const auto* side : {&p.seam.a, &p.seam.b})
      for (const pattern::SeamEdge& e : *side)
        edges += " " + wardrobe.panels[e.panel].id + "/" + std::to_string(e.edge);
    EXPECT_TRUE(truth.contains(key_of(wardrobe, p.seam))) << p.seam.id << edges << " at " << p.confidence;
  }
}

TEST(ProposeSeams, GiveTheSameAnswerEveryTimeAndWithSeveralThreads) {
  const pattern::Pattern pattern = pattern_of(garments::trousers());
  std::vector<double> told;
  RunContext context;
  context.threads = 3;
  context.on_progress = [&](const Progress& progress) { told.push_back(progress.fraction); };
  const auto once = seams::propose_seams(pattern), twice = seams::propose_seams(pattern, {}, context);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].confidence, twice[i].confidence);
    EXPECT_EQ(key_of(pattern, once[i].seam), key_of(pattern, twice[i].seam));
  }
}

TEST(ProposeSeams, MakeAPatternThatNothingIsToBeSaidAgainst) {
  for (const Garment& g : {garments::trousers(), garments::shirt()}) {
    pattern::Pattern pattern = pattern_of(g);
    for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true}))
      if (p.confidence >= 0.8) pattern.seams.push_back(p.seam);
    EXPECT_TRUE(pattern::validate(pattern).ok()) << g.name;
    for (const seams::SeamIssue& issue : seams::check_seams(pattern))
      ADD_FAILURE() << g.name << ": " << issue.where << ": " << issue.message;
  }
}

TEST(ProposeSeams, LeaveAloneWhatIsSewnAlready) {
  pattern::Pattern pattern = pattern_of(garments::trousers());
  pattern.seams = {{"seam0", {{0, 1}}, {{1, 1}}, false}};
  ASSERT_EQ(pattern.panels[1].outline.edges[4].id, "e1") << "mirrored outlines run the other way";
  pattern.seams[0].b[0].edge = 4;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true})) {
    EXPECT_NE(p.seam.id, "seam0");
    for (const auto* side : {&p.seam.a, &p.seam.b})
      for (const pattern::SeamEdge& e : *side)
        EXPECT_FALSE((e.panel == 0 && e.edge == 1) || (e.panel == 1 && e.edge == 4)) << p.seam.id;
  }
}

TEST(ProposeSeams, HaveNothingForASingleClothOrNone) {
  EXPECT_TRUE(seams::propose_seams({}).empty());
  const pattern::Pattern napkin{{garments::piece("napkin", {{0, 0}, {300, 0}, {310, 290}, {-20, 280}})}, {}};
  for (const seams::SeamProposal& p : seams::propose_seams(napkin)) EXPECT_LT(p.confidence, 0.8);
}

TEST(ProposeSeams, TakeNotchesIntoAccount) {
  // Two like edges that only their notches tell apart.
  pattern::Panel a = garments::piece("a", {{0, 0}, {300, 0}, {300, 200}, {0, 200}});
  const auto other = [](const std::string& id, double notch) {
    pattern::Panel p = garments::piece(id, {{0, 0}, {250, 0}, {250, 200}, {0, 200}});
    p.notches = {{{250, notch}, 0, {}}};
    return p;
  };
  a.notches = {{{0, 70}, 0, {}}};
  const pattern::Pattern pattern{{a, other("b", 140), other("c", 70)}, {}};
  bool found = false;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true}))
    found = found || key_of(pattern, p.seam) == ordered({{"a", "e3"}}, {{"c", "e1"}});
  EXPECT_TRUE(found);
}

TEST(ProposeSeams, EndASeamAtANotch) {
  // A kimono: the sides of front and back take the sleeves down to the notch and each other below it.
  const auto body = [](const std::string& id, double neck) {
    pattern::Panel p = garments::piece(
        id, {{-280, 0}, {280, 0}, {280, 700}, {90, 700, Vec2{0, 700 - neck}}, {-90, 700}, {-280, 700}});
    p.notches = {{{280, 450}, 0, {}}, {{-280, 450}, 0, {}}};
    return p;
  };
  const auto sleeve = [](const std::string& id) {
    pattern::Panel p = garments::piece(id, {{0, 0}, {420, 30}, {420, 470}, {0, 500}});
    p.notches = {{{0, 250}, 0, {}}};
    return p;
  };
  const pattern::Pattern pattern{
      {body("front", 200), body("back", 60), sleeve("sleeve_left"), sleeve("sleeve_right")}, {}};
  int sleeves = 0, sides = 0;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true})) {
    if (p.confidence < 0.5) continue;  // which of two equal sleeves is whose is no more than even
    const bool set_in = (p.seam.a[0].panel < 2) != (p.seam.b[0].panel < 2);
    const bool side = p.seam.a[0].panel != p.seam.b[0].panel && p.seam.a[0].panel < 2 &&
                      p.seam.b[0].panel < 2 && std::abs(p.length_a - 450) < 2;
    EXPECT_FALSE(set_in && std::abs(p.length_a - 250) > 2 && std::abs(p.length_a - 500) > 2) << p.length_a;
    sleeves += set_in ? static_cast<int>(std::lround(p.length_a / 250)) : 0;
    sides += side && p.confidence > 0.8;
  }
  EXPECT_EQ(sleeves, 4) << "each sleeve to the front and to the back";
  EXPECT_EQ(sides, 2);
}

TEST(ProposeSeams, AreSureOfPiecesThatMayChangeRound) {
  // A tube skirt of two like pieces and a band in two like halves: which half comes to which piece is all
  // one.
  const auto sheet = [](const std::string& id, double height) {
    return garments::piece(id, {{0, 0}, {420, 0}, {400, height}, {20, height}});
  };
  const auto band = [](const std::string& id) {
    return garments::piece(id, {{0, 0}, {380, 0}, {380, 40}, {0, 40}});
  };
  const pattern::Pattern pattern{{sheet("a", 600), sheet("b", 600), band("c"), band("d")}, {}};
  int waists = 0;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true}))
    waists += p.confidence >= 0.8 && (p.seam.a[0].panel < 2) != (p.seam.b[0].panel < 2) ? 1 : 0;
  EXPECT_EQ(waists, 2);
}

/// The two edges that a proposal joins, in words.
std::string pair_of(const pattern::Pattern& pattern, const seams::SeamProposal& p) {
  std::vector<std::string> sides;
  for (const auto* side : {&p.seam.a, &p.seam.b}) {
    const pattern::Panel& panel = pattern.panels[side->front().panel];
    sides.push_back(panel.id + "." + panel.outline.edges[side->front().edge].id);
  }
  return std::min(sides[0], sides[1]) + " " + std::max(sides[0], sides[1]);
}

TEST(ProposeSeams, AreUnsureWhereClothLiesOnCloth) {
  pattern::Pattern pattern = pattern_of(garments::trousers());
  int sure = 0;
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true}))
    sure += p.confidence >= 0.8 ? 1 : 0;
  EXPECT_GE(sure, 5);
  for (std::size_t i = 0, n = pattern.panels.size(); i < n; ++i) {
    pattern.panels.push_back(pattern.panels[i]);
    pattern.panels.back().id += " lining";
  }
  for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true})) {
    bool lining = false;
    for (const auto* side : {&p.seam.a, &p.seam.b})
      for (const pattern::SeamEdge& e : *side)
        lining = lining || pattern.panels[e.panel].id.ends_with("lining");
    if (lining) {
      EXPECT_LE(p.confidence, 0.6) << p.seam.id;
    }
  }
}

TEST(ProposeSeams, APatternIsSewnAsSurelyBesideItsLining) {
  const auto sure_of = [](const pattern::Pattern& pattern) {
    std::set<std::string> sure;
    for (const seams::SeamProposal& p : seams::propose_seams(pattern, {true}))
      if (p.confidence >= 0.8) sure.insert(pair_of(pattern, p));
    return sure;
  };
  pattern::Pattern pattern = pattern_of(garments::trousers());
  const std::set<std::string> alone = sure_of(pattern);
  EXPECT_GE(alone.size(), 5U);
  for (std::size_t i = 0, n = pattern.panels.size(); i < n; ++i) {
    pattern.panels.push_back(pattern.panels[i]);
    pattern.panels.back().id += " lining";
  }
  EXPECT_EQ(sure_of(pattern), alone);
}

TEST(PieceWords, AreReadFromNamesInManyWays) {
  EXPECT_EQ(seams::words_of("left_sleeve_f").side, -1);
  EXPECT_EQ(seams::words_of("left_sleeve_f").face, 1);
  EXPECT_TRUE(seams::words_of("left_sleeve_f").limb);
  EXPECT_EQ(seams::words_of("FrontRight").face, 1);
  EXPECT_EQ(seams::words_of("FrontRight").side, 1);
  EXPECT_EQ(seams::words_of("BK-2").face, -1);
  EXPECT_EQ(seams::words_of("Cuff RT").side, 1);
  EXPECT_EQ(seams::words_of("yoke").side, 0);
  EXPECT_FALSE(seams::words_of("belt").limb);
}

}  // namespace
}  // namespace toile
