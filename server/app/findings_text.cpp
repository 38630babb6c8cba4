#include "server/app/findings_text.h"

#include <cstdio>
#include <string>

namespace toile {

void print_findings(const Findings& findings) {
  for (const Finding& f : findings) {
    std::printf("%s %s: %s (%s %s)\n", f.repaired ? "repaired" : name_of(f.severity),
                std::string(code_of(f.kind)).c_str(), f.message.c_str(), where_text(f).c_str(),
                place_text(f.place).c_str());
  }
  if (findings.empty()) std::printf("start: nothing to find fault with\n");
}

}  // namespace toile
