#include "core/body/measure/measures.h"

namespace toile::measure {
namespace {

struct Entry {
  std::string_view name, rule;
  bool girth;
};

constexpr Entry kEntries[kMeasureCount] = {
    {"height", "from the floor to the top of the head", false},
    {"bust",
     "widest level girth about the bust points; where there are no breasts, between waist and armpits", true},
    {"underbust", "level girth right below the breasts, 41 % of the way down from nape to crotch", true},
    {"waist", "narrowest level girth between hip and ribs", true},
    {"hip", "widest level girth between crotch and waist", true},
    {"neck", "narrowest girth of the neck, the tape across its axis", true},
    {"shoulder_width",
     "from shoulder point to shoulder point, straight; they lie on the skin above the joints", false},
    {"upper_arm",
     "girth of the upper arm, 60 % of the way from shoulder point to elbow, the tape across the arm", true},
    {"wrist", "narrowest girth between forearm and hand, the tape across the arm", true},
    {"arm_length", "from the shoulder point along the arm's axis to the wrist", false},
    {"thigh", "level girth of one thigh right below the crotch", true},
    {"calf", "widest level girth of one leg between ankle and knee", true},
    {"inseam", "from the floor to the crotch", false},
    {"back_length", "from the nape (seventh cervical) along the mid-back to the small of the back", false},
};

const Entry& entry(Measure m) { return kEntries[static_cast<size_t>(m)]; }

}  // namespace

std::string_view measure_name(Measure m) { return entry(m).name; }
std::string_view measure_rule(Measure m) { return entry(m).rule; }
bool is_girth(Measure m) { return entry(m).girth; }

}  // namespace toile::measure
