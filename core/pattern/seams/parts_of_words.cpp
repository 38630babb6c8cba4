#include "core/pattern/seams/parts_of_words.h"

namespace toile::seams {
namespace {

/// Signs of Chinese and Japanese that tell a word wherever they stand, longer ones first.
constexpr PieceTerm kSigns[] = {
    {"前身頃", "front"},      {"後身頃", "back"},       {"後ろ身頃", "back"},     {"前中", "front"},
    {"后中", "back"},         {"前侧", "front side"},   {"后侧", "back side"},    {"前片", "front"},
    {"后片", "back"},         {"後片", "back"},         {"大袖", "topsleeve"},    {"小袖", "undersleeve"},
    {"袖口", "cuff"},         {"克夫", "cuff"},         {"介英", "cuff"},         {"鸡英", "cuff"},
    {"カフス", "cuff"},       {"袖头", "cuff"},         {"领座", "collar stand"}, {"下级领", "collar stand"},
    {"底领", "collar stand"}, {"領座", "collar stand"}, {"台衿", "collar stand"}, {"领口", "neck"},
    {"领圈", "neck"},         {"腰头", "waistband"},    {"腰頭", "waistband"},    {"腰带", "belt"},
    {"ベルト", "waistband"},  {"裤头", "waistband"},    {"裙头", "waistband"},    {"口袋", "pocket"},
    {"袋布", "pocket"},       {"袋盖", "flap"},         {"ポケット", "pocket"},   {"里布", "lining"},
    {"裏地", "lining"},       {"挂面", "facing"},       {"貼邊", "facing"},       {"贴边", "facing"},
    {"見返し", "facing"},     {"门襟", "placket"},      {"門襟", "placket"},      {"里襟", "fly"},
    {"育克", "yoke"},         {"过肩", "yoke"},         {"担干", "yoke"},         {"ヨーク", "yoke"},
    {"罗纹", "rib"},          {"リブ", "rib"},          {"下摆", "hem"},          {"下脚", "hem"},
    {"肩带", "strap"},        {"吊带", "strap"},        {"フード", "hood"},       {"帽", "hood"},
    {"前", "front"},          {"后", "back"},           {"後", "back"},           {"左", "left"},
    {"右", "right"},          {"侧", "side"},           {"側", "side"},           {"脇", "side"},
    {"袖", "sleeve"},         {"领", "collar"},         {"領", "collar"},         {"衿", "collar"},
    {"腰", "waist"},          {"裙", "skirt"},          {"スカート", "skirt"},    {"裤", "pants"},
    {"褲", "pants"},          {"パンツ", "pants"},      {"袋", "pocket"},         {"衬", "interlining"},
    {"朴", "interlining"},    {"芯", "interlining"},    {"贴", "facing"},         {"边", "edge"}};

/// Compounds: what a word of German, Dutch or Swedish begins with …
constexpr PieceTerm kBeginnings[] = {
    {"vorder", "front"},   {"voor", "front"},    {"rucken", "back"},   {"hinter", "back"},
    {"achter", "back"},    {"seiten", "side"},   {"zij", "side"},      {"hals", "neck"},
    {"saum", "hem"},       {"zoom", "hem"},      {"bauch", "waist"},   {"taillen", "waist"},
    {"taschen", "pocket"}, {"zak", "pocket"},    {"fram", "front"},    {"bak", "back"},
    {"sid", "side"},       {"rock", "skirt"},    {"hosen", "pants"},   {"jacken", "jacket"},
    {"armel", "sleeve"},   {"kragen", "collar"}, {"futter", "lining"}, {"oberteil", "bodice"},
    {"mieder", "bodice"},  {"blusen", "blouse"}, {"rok", "skirt"},     {"broek", "pants"},
    {"mouw", "sleeve"},    {"kjol", "skirt"},    {"byx", "pants"}};
/// … and ends with.
constexpr PieceTerm kEndings[] = {{"armel", "sleeve"},
                                  {"kragen", "collar"},
                                  {"manschette", "cuff"},
                                  {"bundchen", "rib"},
                                  {"hosenbund", "waistband"},
                                  {"rockbund", "waistband"},
                                  {"taillenbund", "waistband"},
                                  {"hose", "pants"},
                                  {"hosenteil", "pants"},
                                  {"rock", "skirt"},
                                  {"rockteil", "skirt"},
                                  {"passe", "yoke"},
                                  {"trager", "strap"},
                                  {"tasche", "pocket"},
                                  {"taschenbeutel", "pocket"},
                                  {"beleg", "facing"},
                                  {"besatz", "facing"},
                                  {"futter", "lining"},
                                  {"einlage", "interlining"},
                                  {"schlaufe", "loop"},
                                  {"leiste", "placket"},
                                  {"kapuze", "hood"},
                                  {"kleid", "dress"},
                                  {"hemd", "shirt"},
                                  {"bluse", "blouse"},
                                  {"mantel", "coat"},
                                  {"jacke", "jacket"},
                                  {"mouw", "sleeve"},
                                  {"kraag", "collar"},
                                  {"broek", "pants"},
                                  {"pijp", "leg"},
                                  {"boord", "rib"},
                                  {"zak", "pocket"},
                                  {"voering", "lining"},
                                  {"manchet", "cuff"},
                                  {"schouderband", "strap"},
                                  {"ficka", "pocket"},
                                  {"fickor", "pocket"},
                                  {"lomme", "pocket"},
                                  {"krage", "collar"},
                                  {"foder", "lining"},
                                  {"infodring", "facing"},
                                  {"vorderteil", "front"},
                                  {"hinterteil", "back"},
                                  {"ruckenteil", "back"},
                                  {"seitenteil", "side"},
                                  {"voorpand", "front"},
                                  {"achterpand", "back"},
                                  {"zijpand", "side"},
                                  {"framstycke", "front"},
                                  {"bakstycke", "back"}};

}  // namespace

std::span<const PieceTerm> sign_terms() { return kSigns; }
std::span<const PieceTerm> beginnings_of_words() { return kBeginnings; }
std::span<const PieceTerm> endings_of_words() { return kEndings; }

}  // namespace toile::seams
