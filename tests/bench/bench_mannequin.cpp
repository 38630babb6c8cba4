// By hand: CPU seconds that a mannequin takes, by figure and number of triangles.

#include <cstdio>
#include <ctime>

#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/proportions.h"

int main() {
  using namespace toile;
  for (const char* size : {"eu38", "eu48", "m50", "child116"}) {
    for (Index count : {2204, 3304, 4562, 5624, 20000}) {
      const BodyPreset* preset = find_preset(size);
      MannequinSettings settings;
      settings.sex = preset->sex;
      settings.asked = preset->measures();
      settings.triangle_count = count;
      const std::clock_t start = std::clock();
      const Result<Mannequin> made = make_mannequin(settings);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      std::printf("%-9s %5d triangles  %.3f s%s\n", size, count, seconds, made ? "" : "  NOT MADE");
    }
  }
}
