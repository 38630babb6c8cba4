#include "server/app/findings_text.h"

#include <cstdio>
#include <string>

namespace toile::app {

void print_findings(const preflight::Findings& findings) {
  for (const preflight::Finding& f : findings) {
    std::printf("%s %s: %s (%s %s)\n", f.repaired ? "repaired" : preflight::name_of(f.severity),
                std::string(preflight::code_of(f.kind)).c_str(), f.message.c_str(),
                preflight::where_text(f).c_str(), preflight::place_text(f.place).c_str());
  }
  if (findings.empty()) std::printf("start: nothing to find fault with\n");
}

}  // namespace toile::app
