#pragma once
// The numbers by which seams are proposed: what speaks for a pair of edges, for a garment, for a seam of
// several edges, and how sure a proposal is of itself.
//
// They were set by hand and by trials on the even ones of 46 random designs of GarmentCode, on five more
// (blouse, hoody, pants, skirt, T-shirt), and on 80 garments drafted at random in the same manner with other
// measures, all read from DXF with their seams withheld. Scored at confidence 0.8 (bench_proposals;
// LongProposeShared), precision and recall:
//   even designs, developed on:  1.00, 0.87    at first 0.59, 0.26; of what is taken to be worn 0.99, 0.97
//   odd designs, scored only:    0.97, 0.84    at first 0.63, 0.24; of what is taken to be worn 0.95, 0.93
//   the five, developed on:      1.00, 0.96
//   four designs of FreeSewing:  1.00, 1.00
// Of what is told at 0.9 and above (mean 0.98) 0.91 is right on the odd designs. The rules for tailored
// clothes were found on a fifth design of FreeSewing, a jacket of 17 pieces; those for shoulders without
// sleeves, level shoulders, waistbands cut along their grain, briefs and seams that end at notches on
// patterns drawn for them; those for legs of one piece, raglan and dropped shoulders, bands, straps and
// gathered caps on twenty plain garments drawn for the purpose, and tried on eleven others; those for yokes,
// wrists of cut-on sleeves and cuffs of legs on a dozen more; those for second layers, drafted darts, raglans
// with an armhole's end, bust ease and flies on twenty-two designs of FreeSewing drafted anew, ten of
// which are well worn since; of eleven others one is; those for eased shoulders and for caps as long as hems
// on two of these in other sizes, those for the ends of armholes, hems, yokes and stands on six in nine
// sizes; those for flanks, gores and hems that are as long as necks on twelve garments that another hand
// drafted, of which 10 are worn since (5 before), and 8 of twelve others (7); those for strips, bias cuts,
// batwings, circles, parted sides of legs, bibs and strap places on twelve more of such garments, of which 7
// are worn since (2 before), and 3 of twelve others (2). How shapes tell kinds (named_by_shape) was tried on
// 46 garments of these that are worn, with numbers for names: of 489 seams 374 stay the same, 302 at first.
// Those for collars of buttoned fronts, stands, yokes of trousers, whole legs, tiers and edges parted at
// notches were found on twenty-four more garments, of which 18 are worn since (11 before), and on two of a
// further set, of which the twelve that nobody looked at are worn as often as before (5).
// What came later, rules about folded bands, stands with round ends, pockets, halves of waistbands, hoods,
// vents and names, was found on four further sets of sixteen to twenty-four; tests/data/drawings has these,
// and how many of each half are worn.
// What is changed here is to be scored again on all of them, the two halves told apart.

#include <cstddef>

namespace toile::seams {

/// A step of a curve of straight lines: its value at a place.
struct WeightStep {
  double at, value;
};

/// What speaks for sewing two edges to each other, by themselves. Merits are without a unit: 6 for two edges
/// of equal length is the yardstick.
struct PairWeights {
  // Lengths: merit by the difference over the longer one.
  WeightStep length[10] = {{0, 6},     {0.003, 5.7}, {0.01, 5},  {0.03, 3.5}, {0.06, 2.2},
                           {0.1, 0.8}, {0.2, -1},    {0.35, -2}, {0.5, -3.5}, {0.7, -8}};
  double drawn_mm = 0.5;            ///< how truly lengths are drawn
  double short_mm = 15;             ///< lengths below it are like by chance
  double most_of_twins = 2.5;       ///< the most that like lengths say of mirrored edges …
  double most_of_counterparts = 5;  ///< … and of the same edge of two pieces that are drawn alike
  double upright = 0.8;         ///< rise of an edge that runs along the grain; there cloth is gathered seldom
  double ease_upright = 4;      ///< against a difference there, in full at 1.33 times …
  double ease_bust = 1;         ///< … but along the side of a front that is longer by up to …
  double bust_ease = 0.13;      ///< … this share, which a dart takes in
  double shoulder_ease = 0.08;  ///< share that a back's shoulder is longer by at most
  double fair_straight = 0.015;  ///< … this share of the length for straight edges, …
  double fair_curved = 0.06;     ///< … or this one
  double ease_begins = 0.33;     ///< times that share, where it begins to count
  double inexact = 2.5;  ///< against straight edges that differ: they are drawn to the tenth of a mm …
  double inexact_share = 0.005;  ///< … in full at 1.1 times this share of the length …
  double inexact_begins = 0.1;   ///< … beginning at this part of it …
  double gathered = 0.1;         ///< … unless they differ by this share: they are gathered

  // Shapes, degrees.
  double straight_deg = 8;  ///< that an edge may turn by and count as straight
  double curved_deg = 25;   ///< from where on it is curved
  double round_deg = 60;    ///< from where on it is round
  double like_deg = 8;      ///< mean difference of the turning of like curves
  double like_curves = 0.8;
  double straight_to_round = -1.2;
  double hollow_deg = -40;       ///< turning of an armhole
  double two_hollows = -3;       ///< armholes go to caps, not to armholes …
  double two_armholes = -8;      ///< … least of all where both are known
  double armhole_end_deg = -20;  ///< turning of an armhole's end below a raglan sleeve's slope, at least …
  double armhole_slope = 0.4;    ///< … and how much that slope faces up

  // Heights along the grain: pieces mostly lie as they are worn.
  double level = 0.08;         ///< spread of heights over the length; an even slope has 0.29
  double height = 1.5;         ///< times the correlation of the two edges' heights
  double facing = 0.8;         ///< how much an edge faces up or down that does
  double facing_fully = 0.97;  ///< waists; shoulders slope
  double pointed_deg = 190;    ///< corner of a neck that is cut to a point …
  double dart_deg = 300;       ///< … and of a dart, from here on
  double neck_deg = -20;       ///< turning of a neck at least, and of an armhole beside a shoulder
  double level_up = 0.995;     ///< a straight neck is level
  double off_neck = 0.6;       ///< how much an edge faces the side that is at no neck
  double two_hems = -8;
  double crotch = 0.12;  ///< of the outline's length, a lower end that two leg openings leave at most …
  double leg_opening_up = -0.32;  ///< … which face down so much: insides of legs are steeper
  double two_waists = -5;
  double level_shoulder = 1.5;     ///< but of a front and a back, beside their necks
  double torsos_shoulder = 3;      ///< … which are bodices
  double level_shoulder_up = 0.9;  ///< how much a shoulder faces up that tells of a bodice
  double shoulder_high = 0.25;     ///< of the piece's height, where a shoulder lies …
  double shoulder_slope = 0.05;    ///< … and how much it rises at least that tells where the neck is
  double waists_in_row = -12;      ///< the same of gores in a row
  double side_to_hem = -4;         ///< of pieces of one kind; a side faces up or down by at most …
  double side_up = 0.2;            ///< … this
  double hem_to_own_waist = -3;
  double hem_to_twins_waist = -8;  ///< a left leg does not hang from the right one
  double larger_hangs = 0.8;       ///< what hangs below is mostly the larger, a skirt from its band: so …
  double smaller_hangs = 0.4;      ///< … and otherwise
  double hanging_face = 1;         ///< front to front, back to back; against front to back
  double crosses_over = -4;        ///< the left of a front to the right of a back
  double sleeve_of_other_side = -1.5;  ///< a left sleeve to a whole front's right
  double hangs_across = -8;            ///< a front below a back that is its like: both are worn at one height
  double hangs = 1.5;                  ///< what kinds of pieces say that one hangs from the other …
  double hangs_not = -6;               ///< … or does not
  double half_takes_all = -6;   ///< an end that both halves of a bodice or of trousers come to, for one alone
  double gathered_least = 2.5;  ///< there cloth is gathered often: the least that lengths say is this …
  double gathered_slope = 4;    ///< … less so much times their difference …
  double gathered_most = 0.6;   ///< … up to this share: nothing is gathered to a third …
  double gathered_cap = 0.45;   ///< … nor a cap onto half of its armhole
  double lying = 0.3;           ///< how much the opening of a sleeve that lies faces up or down
  double inner = 0.2;           ///< how much a neck faces the body's middle …
  double fully_inner = 0.9;     ///< … and its centre front
  double not_middle = -4;
  double outer_sides = -10;  ///< the sides of a left and a right front to each other
  double raglan_neck = -4;   ///< for a part of a neck that goes through raglan sleeves: only all of it fits
  double armhole = 1.5;      ///< for a sleeve at a hollow edge of a bodice, against it at others
  double insert_face = 2;    ///< inserts of the front are let into the front
  double cap = 1.5;          ///< for a sleeve's cap there, against its other edges …
  double tailored_ease = 0.08;  ///< of a cap over its armhole, where nothing is gathered
  double cap_to_sleeve = -5;    ///< … and for the cap sewn to a sleeve
  double insert_place = -6;     ///< times the share of the width that it is from where its number says
  double stays_open = -8;       ///< the edge of a front that opens, but for linings and facings; the other
                                ///< front's edges; a collar's own ends above such fronts
  double turns_in_deg = 225;    ///< corners where a piece turns in …
  double two_straps = -25;      ///< straps and ties are sewn to a garment
  double strap_end = 0.2;       ///< of the outline, an end of a strap at most
  double two_corners = -4;      ///< … are of openings: two edges at such are not sewn to each other
  double never_meet = -8;       ///< kinds of pieces that are not sewn to each other …
  double waist_longer = 1.5;    ///< times a leg's hem, that a band is too long for it
  double only_hangs = -8;       ///< … or only where one hangs from the other

  // Names.
  double both_sleeves = -8;  ///< the same edge of the left and of the right one
  double same_side = 0.5;
  double other_side_limbs = -8;
  double other_side_limb = -4;  ///< where one of the two is a sleeve
  double other_side = -4;
  double limb_face = 2;  ///< a sleeve's front to the front

  // Edges that run into a narrow corner and are no dart: a slit, or another piece is let in.
  double slit_deg = 270;
  double slit = -5;

  // Pieces that numbers tell apart.
  double gores = 0.05;  ///< share that the girths of gores differ by
  double next_in_row = 1;
  double not_in_order = -3;

  // Mirrored pieces meet in a straight line along the grain, as at a centre front.
  double twin_across = -3;        ///< in full for edges across the grain …
  double twin_across_round = -1;  ///< … that are not round: a hood's back, a seam that gives shape
  double twin_round_deg = 45;
  double twin_round_front = -6;     ///< a front's round edge …
  double round_front_rise = 0.85;   ///< … of this rise
  double twin_face = -2;            ///< a hood's straight edge is around the face …
  double twin_hollow_face = -6;     ///< … and a hollow one all the more
  double collar_long = -6;          ///< pieces of a collar do not meet along an edge …
  double collar_end = 0.28;         ///< … of more than this share of their outline
  double collar_bulges_deg = 75;    ///< a collar edge that turns more outwards is its outer one
  double fold_on_stand = 0.004;     ///< … but for a collar on its stand, where lengths differ by less
  double twin_crotch = 3;           ///< legs meet along a hollow …
  double twin_leg_side = -8;        ///< … and not along what begins at their hems
  double twin_straight = 4;         ///< a straight one …
  double twin_straight_rise = 0.9;  ///< … of this rise
  double middle_rise = 0.998;       ///< of the middle itself, from which a front's neck goes on aslant
  double vent_out_mm = 10;          ///< that a vent's edge lies beyond the middle line above it …
  double vent_bend_deg = 40;        ///< that it may bend by where its hem is turned up
  double vent_step = 0.6;           ///< … by a step of at most this share of its length …
  double vent = -6;                 ///< … and it is sewn to no other piece's edge …
  double twin_vent =
      -1.5;  ///< … and hardly to its mirror image, but of a skirt: the line above may be a neck
  double twin_hollow_deg = -25;
  double twin_hollow = -3;          ///< a neck or armhole, in full below a rise of …
  double twin_upright_rise = 0.95;  ///< … this less the next; from this on it is a crotch and is not meant
  double twin_upright_width = 0.1;

  // A piece sewn to itself: bands and sleeves are tubes, a front is none.
  double own_front = -8;
  double least_ring_mm = 120;  ///< that a hand passes through
  double own_tube = 1;
  double own_tube_rise = 0.9;
  double own_piece = -1;

  // Notches.
  double notch_mm = 5;       ///< within which two meet
  double notch_meets = 1.5;  ///< each
  double notches_most = 3;
  double notch_alone = -0.3;  ///< each that meets none

  // Edges that were cut to fit others: that parts agree says less, and together they are one coincidence.
  double cut_to_cut = -4;       ///< nothing is there to cut both for
  double cut_ease = 0.06;       ///< parts that differ by more were not meant …
  double cut_differs = -4;      ///< … and count so much
  double part_least = 0.15;     ///< weight of a part: this …
  double part_per_share = 0.7;  ///< … and so much times its share of its edge …
  double part_most = 0.5;       ///< … up to this
};

/// What speaks for all that is sewn together.
struct GarmentWeights {
  // Around a point inside the cloth 360° lie flat, 180° would be a fold's end. Degrees off that, and merits.
  double inner_flat_deg = 40, inner_fair_deg = 100;
  double inner = 1.5;         ///< in full up to flat, none at fair
  double inner_cone = -10;    ///< each 100° beyond fair where cloth is missing …
  double inner_ruffle = -2;   ///< … or too much
  double arm_shut_deg = 260;  ///< a front's side and shoulder that are both sewn meet in less: …
  double arm_shut = -12;      ///< … no arm comes out of it
  // A border mostly runs on straight (180°) across a seam.
  double border_straight_deg = 25, border_fair_deg = 70;
  double border = 0.7;
  double border_bent = -2.5;    ///< each 100° beyond fair …
  double border_slit = -1.2;    ///< … at most where a slit ends, at 360° …
  double border_corner = -2.5;  ///< … or where the border turns in

  double hangs_both_ways = -12;  ///< the lower of two level pieces holds the upper one as well
  double handle = -25;           ///< a ring sewn to a ring of the same cloth
  double part = -2.5;            ///< cloth that hangs on nothing
  double opening = 1.5;          ///< a way in or out for the body, beyond the first
  int openings = 3;              ///< that count
  double narrow = -6;            ///< a border of the bodice alone that nothing passes through: …
  double narrow_share = 0.28;    ///< … under this share of the bodice's girth, …
  double narrow_most_mm = 300;   ///< … and this: sleeves that are cut on widen it …
  double wrist_mm = 200;         ///< … and where they turn off the sides in corners they end at wrists
  double shut = -1.5;            ///< a piece without any free edge
  double both_limbs = -10;       ///< a piece of a sleeve that is sewn to the left one and to the right one
  double strap_across = -6;      ///< a strap from a front to the same front …
  double strap_crosses = -4;     ///< … or from its left to the right of the back
  double left_out = -6;          ///< a piece of the bodice that is sewn to nothing: it is no trim
  double free_round = -2.5;      ///< openings run straight or hollow: a round edge is there to be sewn
  double round_deg = 45;         ///< that it turns by …
  double hem = -0.5;             ///< … unless it faces down so much
  double mirrored = 1;           ///< the same seam on the other side
  double parted = -2.5;          ///< a part up to a notch sewn to such a part: lengths agree twice by chance
  double torn_line = -2.5;       ///< a smooth line that is sewn up to some point of it and no further
  double smooth_deg = 15;        ///< that it may bend by
  double same_gather = 3;        ///< neighbours gathered alike
  double gathered = 1.05;        ///< times the other edge's length
  double like_gather = 0.015;    ///< share by which their ratios may differ
  int gathers = 2;               ///< that count
  double second_line = -10;      ///< twins meet along one line, the middle of the body, seldom along two

  // Pieces are mostly drawn from their right side, and mirrored ones from the same side.
  double turned = -4;          ///< a piece from the other side …
  double turned_collar = 0.1;  ///< times that for a collar
  double turned_known = -50;   ///< … where the sides are known
  double twin_turned = -3;
  double face_turned = -0.6;  ///< a front unlike other fronts
};

/// What speaks for seams of several edges on a side.
struct SeriesWeights {
  double meet = 0.012;              ///< of the seam's length: corners this close meet
  double meet_least_mm = 3;         ///< or this close
  double corner = 0.7;              ///< for corners of both sides that meet …
  double corners_most = 2.5;        ///< … together
  double notch_from_middle_mm = 3;  ///< that a collar's notch is off a corner of its neck, from their middles
  double whole_borders = 2.5;       ///< an edge all around sewn to one all around
  double collar_on_neck = 10;  ///< a collar and a neck, each its own mirror image, that differ by less than …
  double collar_fits = 0.03;    ///< … this share
  double overlap_least_mm = 6;  ///< what a neck goes on beyond each end of a collar, or a stand beyond that …
  double overlap_most_mm = 45;     ///< … where fronts are buttoned over each other
  double collar_in_middle = 24;    ///< it ends before the fronts do
  double tier_on_tier = 5;         ///< the least that lengths say of a tier gathered onto the one above it
  double rib_on_neck = 2;          ///< the least that lengths say of a closed neckband …
  double rib_along_neck = 6;       ///< … or of an open one that is its own mirror image …
  double rib_stretched = 0.75;     ///< … which is at least this share of its neck
  double stand_on_neck = 9;        ///< or of a stand that overlaps
  double hood_behind = -4;         ///< a hood whose face would be behind
  double round_collar_point = -8;  ///< a collar's point, of less than …
  double collar_point_deg = 130;   ///< … this, is no place that a seam runs around
  double gores_in_order = 3;       ///< gores counted from a side, the front's first
  double differ_mm = 15;           ///< sides of a seam that differ by this are sewn on along what goes on …
  double further_mm = 4;           ///< … where they agree so then
  double ratio = 1.12;             ///< of the lengths, at most …
  double ratio_whole = 1.7;        ///< … and of whole borders: gathers
  double ratio_gathered = 3;       ///< … of a skirt on its waistband or a bodice, gathered or in pleats …
  double gathered_below = 2;       ///< … the least that lengths say of these
  double worthwhile = 1.5;         ///< that the garment must gain by it
};

/// Where long edges may be cut for others.
struct CutWeights {
  double alike = 0.01;        ///< share of the length by which neighbours differ that lie end to end
  double ease = 0.045;        ///< that a long edge may have over the two
  double ease_cap = 0.4;      ///< that a sleeve's cap may have over the armholes of a front and a back
  double yoke = 0.05;         ///< of a cap's length, that armholes and a yoke's end may differ by from it
  double arm_least_mm = 100;  ///< of a side that goes up to the shoulder, what is left open for the arm …
  double arm_most = 0.75;     ///< … at most this share
  double arm_notch_mm = 15;   ///< that its notch may be off a sleeve's half
  double exact = 0.004;       ///< that lengths may differ which were drawn to fit
  double shortest_mm = 60;    ///< shorter edges are sewn to one other
  double notch_mm = 1;        ///< that the part beside a notch may differ by from the edge sewn to it
  double least_part_mm = 15;  ///< shorter parts between notches tell of nothing
  double most_parts = 5;      ///< the shorter of two lines is this part of the edge or more
  double dart_deg = 50;       ///< the widest between a dart's legs
  double dart_least_deg = 0.5;
  double dart_ease = 0.04;  ///< share that its legs may differ by
  double rising = 0.5;      ///< climb of lines whose lower ends meet
  double level = 0.8;       ///< how much an edge faces up or down that halves of a garment meet at
  double bent_deg = 35;  ///< that a line bends by which is sewn to one edge all the same, if they fit exactly
  double bent_raglan_deg = 70;  ///< … or where a raglan sleeve's slope turns into the armhole's end …
  double ease_raglan = 0.02;    ///< … which fits within this
};

/// Which corners of a piece are darts that are closed before anything is sewn.
struct DartWeights {
  double legs = 0.04;             ///< share that the legs may differ by
  double least_deg = 0.5;         ///< width of the tip, at least …
  double most_deg = 30;           ///< … and at most; wider ones may be meant for another piece, …
  double most_up_deg = 55;        ///< … but for those of waists
  double mouth_deg = 25;          ///< that the outline may bend by across the closed mouth, …
  double straight_mouth_deg = 8;  ///< … or across the open one, of waists: programs cut them straight
  double drawn = 0.002;           ///< share that legs differ by which are drawn to be closed: …
  double drawn_most_deg = 52;     ///< … so wide between their chords they may be
  double inside_deg = 30;         ///< that a front's side may bend by at a dart which is drawn inside it …
  double inside_rise = 0.9;       ///< … of this rise at least …
  double inside_part = 0.25;      ///< … the shorter part being this much of it at most
  double corner_deg = 45;         ///< that an outline bends by across a closed mouth which is a corner
  double smooth_deg = 3;          ///< that an outline may bend by where an edge goes on
  double halves = 0.005;          ///< but not between edges that differ by less than this share
  double top = 0.5;               ///< mouths of skirts, legs and sleeves that face up less are slits
  double neck = 90;               ///< mm, that a V in the middle is wide which is a neck and no dart, …
  double faces_up = 0.9;          ///< … by which it faces up at least
};

/// How sure a proposal is, from its margin: what the best garment without the seam would lose.
struct ConfidenceWeights {
  double even = 1.8;            ///< margin of an even chance; about 4 mean four in five
  double slope = 1.7;           ///< of the logistic curve
  double gathers = 0.35;        ///< times the share by which lengths differ beyond …
  double gathers_begin = 0.03;  ///< … this is taken off: gathers are never quite sure
  double dart = 0.97;           ///< of a dart's legs
  double mirror_image = 0.95;   ///< factor for what is sewn on the other side
  double strap_place = 0.7;     ///< of a strap's end that is sewn onto a piece
  double collar = 0.95;         ///< factor for a collar's …
  double folded_collar = 0.7;   ///< … with lapels: nothing tells how it is folded over
  double layer = 0.6;           ///< factor for a seam of a lining, facing or pocket …
  double settled = 0.5;         ///< seams of the pieces below are kept when layers are sewn to them
  double beside_layer = 0.85;   ///< … and for others of a garment that has any
  double nameless = 0.78;       ///< factor where no name tells sides or fronts …
  double enough_names = 0.5;    ///< … none from this share of pieces on
  double gores = 0.8;           ///< factor for the waist of a skirt of gores: they may be turned in it
  double beside_middle = 0.5;   ///< factor for halves sewn on aslant from their middle
  double rival = 0.79;          ///< factor where another piece has the role of one of its pieces
};

inline constexpr PairWeights kPairWeights{};
inline constexpr GarmentWeights kGarmentWeights{};
inline constexpr SeriesWeights kSeriesWeights{};
inline constexpr CutWeights kCutWeights{};
inline constexpr DartWeights kDartWeights{};
inline constexpr ConfidenceWeights kConfidenceWeights{};

}  // namespace toile::seams
