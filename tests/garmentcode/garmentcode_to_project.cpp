// garmentcode_to_project DATA NAME OUT [MM [HELD…]]: see to_project.h. The body is garmentcode-mean_all.obj.

#include <cstdio>
#include <cstdlib>

#include "tests/garmentcode/to_project.h"

int main(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(stderr,
                 "usage: garmentcode_to_project DATA NAME OUT [PARTICLE_DISTANCE_MM [HELD_PIECES…]]\n");
    return 2;
  }
  const double distance = count > 4 ? std::atof(arguments[4]) : 15;
  const std::vector<std::string> held(arguments + (count > 5 ? 5 : count), arguments + count);
  const toile::Status status = toile::test::write_garmentcode_project(
      arguments[1], arguments[2], "garmentcode-mean_all.obj", held, distance, arguments[3]);
  if (!status) std::fprintf(stderr, "%s\n", toile::to_string(status.error()).c_str());
  return status.ok() ? 0 : 1;
}
