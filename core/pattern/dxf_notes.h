#pragma once
// What a DXF reader passed over, told once per kind.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace toile {

/// Notes with their lines. A broken file must not answer with a book: after 500 the rest is dropped.
class DxfNotes {
 public:
  void add(int line, std::string text);
  /// One more of a kind; told as "line 12: 31 <kind>", with the first line.
  void count(int line, const std::string& kind);
  /// "line 12: …" by line.
  std::vector<std::string> told() const;

 private:
  struct Note {
    int line = 0;
    std::string text;
  };
  struct Tally {
    int line = 0;
    std::size_t count = 0;
  };
  std::vector<Note> notes_;
  std::map<std::string, Tally> tallies_;
};

}  // namespace toile
